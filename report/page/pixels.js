// Float pixel values out of the page's data blocks; report/pixel_code.h says how they were packed.
R.pixels = (() => {
    const FLOAT_MANTISSA = 23;
    const ORDER = [1, 0, 2];  // green first

    const toFloats = (out, planes, mantissa) => {
        const bits = new Int32Array(out.buffer), shift = FLOAT_MANTISSA - mantissa;
        for (let c = 0; c < 3; ++c)
            for (let i = 0; 3 * i < bits.length; ++i) {
                const v = planes[c][i];
                bits[3 * i + ORDER[c]] = v < 0 ? (-v << shift) | 0x80000000 : v << shift;
            }
    };
    /** `finer` more bits of mantissa for pixels that differ from the reference's. */
    const refine = (out, reader, planes, where, mantissa, finer) => {
        const bits = new Int32Array(out.buffer), shift = FLOAT_MANTISSA - mantissa - finer, half = 1 << (finer - 1);
        for (let i = 0; 3 * i < bits.length; ++i)
            for (let c = 0; c < 3 && where(i); ++c) {
                const v = (planes[c][i] << finer) + reader.plain(finer + 1) - half;
                bits[3 * i + ORDER[c]] = v < 0 ? (-v << shift) | 0x80000000 : v << shift;
            }
    };

    const known = new Map();
    const decode = (blob) => {
        const n = blob.width * blob.height, base = blob.base ? known.get(blob.base) : null;
        const reader = R.bits.reader(R.unpack91(document.getElementById(blob.id).textContent));
        const planes = R.foretelling.planes(reader, blob.width, n, base?.planes);
        const picture = {width: blob.width, height: blob.height, mantissa: blob.mantissa, planes, rgb: new Float32Array(3 * n), marked: () => false, explained: () => false};
        if (blob.counts) planes.forEach((plane, c) => plane.subarray(0, n).forEach((v, i) => (picture.rgb[3 * i + ORDER[c]] = v)));
        else toFloats(picture.rgb, planes, blob.mantissa);
        const bitmap = () => {
            const bits = R.foretelling.bitmap(reader, blob.width, n);
            return (i) => bits[i] === 1;
        };
        // Of the reference: outlines. Of the student's picture: pixels beyond the tolerance, and those of them on silhouettes.
        if (blob.outlines) picture.marked = bitmap();
        if (base) {
            picture.marked = bitmap();
            picture.explained = bitmap();
            const differs = (i) => picture.marked(i) || planes.some((plane, c) => plane[i] !== base.planes[c][i]);
            if (blob.finer) refine(picture.rgb, reader, planes, differs, blob.mantissa, blob.finer);
        }
        return picture;
    };

    const get = (blob) => {
        if (!blob) return null;
        if (!known.has(blob.id)) known.set(blob.id, decode(blob));
        return known.get(blob.id);
    };

    /** {student, reference} of a check's image, either may be null. */
    const pair = (image) => {
        const embedded = R.object(image.embedded);
        const reference = get(embedded.reference);
        return {reference, student: get(embedded.student)};
    };
    return {get, pair};
})();
