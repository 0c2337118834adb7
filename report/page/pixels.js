// Float pixel values out of the page's data blocks; report/pixel_code.h says how they were packed.
R.pixels = (() => {
    const FLOAT_MANTISSA = 23;
    const ORDER = [1, 0, 2];  // green first

    const inflate = async (text) => {
        const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
        const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
        return new Uint8Array(await new Response(stream).arrayBuffer());
    };

    const residuals = (bytes, channel, n) => {
        const plane = new Int32Array(n);
        const first = channel * 4 * n;
        for (let i = 0; i < n; ++i) {
            const z = bytes[first + i] | bytes[first + n + i] << 8 | bytes[first + 2 * n + i] << 16 | bytes[first + 3 * n + i] << 24;
            plane[i] = (z >>> 1) ^ -(z & 1);
        }
        return plane;
    };

    const addNeighbours = (plane, width) => {
        for (let i = 0; i < plane.length; ++i) {
            const hasLeft = i % width !== 0, hasAbove = i >= width;
            const left = hasLeft ? plane[i - 1] : 0, above = hasAbove ? plane[i - width] : 0;
            let guess = hasLeft ? left : above;
            if (hasLeft && hasAbove) {
                const corner = plane[i - width - 1], low = Math.min(left, above), high = Math.max(left, above);
                guess = corner >= high ? low : corner <= low ? high : (left + above - corner) | 0;
            }
            plane[i] = (plane[i] + guess) | 0;
        }
    };

    const add = (plane, other, shift) => {
        for (let i = 0; i < plane.length; ++i) plane[i] = (plane[i] + (other[i] << shift)) | 0;
    };

    const toFloats = (planes, n, mantissa) => {
        const bits = new Int32Array(3 * n);
        const shift = FLOAT_MANTISSA - mantissa;
        for (let c = 0; c < 3; ++c)
            for (let i = 0; i < n; ++i) {
                const v = planes[c][i];
                bits[3 * i + ORDER[c]] = v < 0 ? (-v << shift) | 0x80000000 : v << shift;
            }
        return new Float32Array(bits.buffer);
    };

    const known = new Map();
    const decode = async (blob) => {
        const n = blob.width * blob.height;
        const bytes = await inflate(document.getElementById(blob.id).textContent);
        const planes = [0, 1, 2].map((c) => residuals(bytes, c, n));
        if (blob.gradient) planes.forEach((plane) => addNeighbours(plane, blob.width));
        if (blob.color) [1, 2].forEach((c) => add(planes[c], planes[0], 0));
        if (blob.base) {
            const base = await known.get(blob.base);
            planes.forEach((plane, c) => add(plane, base.planes[c], blob.mantissa - blob.base_mantissa));
        }
        // Of the reference: outlines. Of the student's picture: pixels beyond the tolerance, and those of them on silhouettes.
        const marks = bytes.subarray(12 * n), plane = (n + 7) >> 3;
        const bits = (k) => (i) => (marks[k * plane + (i >> 3)] >> (i & 7) & 1) === 1;
        return {width: blob.width, height: blob.height, mantissa: blob.mantissa, planes, rgb: toFloats(planes, n, blob.mantissa), marked: bits(0), explained: bits(1)};
    };

    const get = (blob) => {
        if (!blob) return Promise.resolve(null);
        if (!known.has(blob.id)) known.set(blob.id, decode(blob));
        return known.get(blob.id);
    };

    /** {student, reference} of a check's image, either may be null. */
    const pair = async (image) => {
        const embedded = R.object(image.embedded);
        const reference = await get(embedded.reference);
        return {reference, student: await get(embedded.student)};
    };
    return {get, pair};
})();
