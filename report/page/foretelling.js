// What the pixels before it say about a pixel's number: report/foretelling.h tells how, and this must do the same.
R.foretelling = (() => {
    const LENGTHS = 30, DOUBTS = 24, FAR_OFF = 1 << 20, LEARNT_DIGITS = 3, GUESSES = 7;
    const lengthOf = (v) => 32 - Math.clz32(v);
    const classOf = (v) => (v < 4 ? v : Math.min(DOUBTS - 1, 2 + lengthOf(v)));
    const signOf = (v) => (v < 0 ? 0 : v === 0 ? 1 : 2);
    const capped = (v) => Math.min(FAR_OFF, Math.abs(v));
    const medianEdge = (left, above, corner) => {
        const low = Math.min(left, above), high = Math.max(left, above);
        return corner >= high ? low : corner <= low ? high : left + above - corner;
    };

    /** Neighbours that come before pixel i; of the first one all are `none`. */
    const around = (at, i, width, none) => {
        const x = i % width, above = i >= width;
        at.w = x > 0 ? i - 1 : above ? i - width : none;
        at.n = above ? i - width : at.w;
        at.nw = x > 0 && above ? i - width - 1 : at.n;
        at.ne = above && x + 1 < width ? i - width + 1 : at.n;
        at.ww = x > 1 ? i - 2 : at.w;
        at.nn = i >= 2 * width ? i - 2 * width : at.n;
    };

    /** Three planes of n numbers (G R B); base: the planes that they may resemble, or null. */
    const planes = (reader, width, n, base) => {
        const {contexts, weights} = R.bits;
        const each = (make) => [0, 1, 2].map(make);
        const values = each(() => new Int32Array(n + 1)), residuals = each(() => new Int32Array(n + 1)), off = each(() => new Int32Array(GUESSES * (n + 1)));
        const byDoubt = contexts(3 * DOUBTS * 16 * 6 * LENGTHS), byResiduals = contexts(3 * DOUBTS * 16 * LENGTHS), byNeighbours = contexts(3 * 12 * 12 * 8 * LENGTHS);
        const signs = contexts(3 * 3 * 3 * 2), digits = contexts(LENGTHS << LEARNT_DIGITS), mix = weights(3 * LENGTHS * DOUBTS);
        const at = {w: 0, n: 0, nw: 0, ne: 0, ww: 0, nn: 0}, guesses = new Int32Array(GUESSES);

        const guess = (c, i) => {
            const own = values[c], {w, n: above, nw} = at;
            let count = 0;
            if (base) guesses[count++] = base[c][i];
            guesses[count++] = medianEdge(own[w], own[above], own[nw]);
            if (c === 0) {
                guesses[count++] = own[w];
                guesses[count++] = own[above];
                guesses[count++] = own[w] + own[above] - own[nw];
                guesses[count++] = own[at.ne];
                guesses[count++] = own[nw];
                return count;
            }
            for (let known = 0; known < c; ++known) {
                const other = values[known];
                guesses[count++] = other[i] + medianEdge(own[w] - other[w], own[above] - other[above], own[nw] - other[nw]);
            }
            const green = values[0], red = values[1], g = green[i];
            let closest = w, least = -1;
            for (let j = 0; j < 6; ++j) {
                const k = j === 0 ? w : j === 1 ? above : j === 2 ? at.ne : j === 3 ? nw : j === 4 ? at.ww : at.nn;
                let distance = Math.abs(g - green[k]);
                if (c === 2) distance += Math.abs(red[i] - red[k] - (g - green[k]));
                if (least < 0 || distance < least) {
                    least = distance;
                    closest = k;
                }
            }
            guesses[count++] = own[closest] + g - green[closest];
            return count;
        };
        /** Which guess was closest around here, and how far it was off. */
        const best = {k: 0, doubt: 0};
        const choose = (c, count) => {
            const o = off[c], w = GUESSES * at.w, above = GUESSES * at.n, nw = GUESSES * at.nw, ne = GUESSES * at.ne;
            best.doubt = -1;
            for (let k = 0; k < count; ++k) {
                const doubt = 2 * o[w + k] + 2 * o[above + k] + o[nw + k] + o[ne + k];
                if (best.doubt >= 0 && doubt >= best.doubt) continue;
                best.k = k;
                best.doubt = doubt;
            }
        };
        const residual = (c, i) => {
            const own = residuals[c], w = own[at.w], above = own[at.n];
            let others = 0;
            for (let known = 0; known < c; ++known) others += capped(residuals[known][i]);
            const doubt = classOf(best.doubt), beside = Math.min(15, lengthOf(others)), still = (w === 0 ? 1 : 0) + (above === 0 ? 1 : 0), based = base && best.k === 0 ? 1 : 0;
            const busy = classOf(2 * capped(w) + 2 * capped(above) + capped(own[at.nw]) + capped(own[at.ne]));
            const west = Math.min(11, lengthOf(capped(w))), north = Math.min(11, lengthOf(capped(above)));
            const first = ((((c * DOUBTS + doubt) * 16 + beside) * 3 + still) * 2 + based) * LENGTHS;
            const second = ((c * DOUBTS + busy) * 16 + beside) * LENGTHS, third = (((c * 12 + west) * 12 + north) * 8 + Math.min(7, beside)) * LENGTHS;
            let length = 0;
            while (length < LENGTHS && reader.mixed(byDoubt, first + length, byResiduals, second + length, byNeighbours, third + length, mix, (c * LENGTHS + length) * DOUBTS + doubt)) ++length;
            if (length === 0) return 0;
            const before = c === 0 ? 1 : signOf(residuals[c - 1][i]), negative = reader.bit(signs, ((c * 3 + signOf(w)) * 3 + before) * 2 + based);
            let left = length - 1, size = 1;
            for (let k = 0; k < LEARNT_DIGITS && left > 0; ++k, --left) size = size << 1 | reader.bit(digits, (length << LEARNT_DIGITS) + size);
            size = size << left | reader.plain(left);
            return negative ? -size : size;
        };

        for (let i = 0; i < n; ++i) {
            around(at, i, width, n);
            for (let c = 0; c < 3; ++c) {
                const count = guess(c, i);
                choose(c, count);
                const r = residuals[c][i] = residual(c, i), value = values[c][i] = guesses[best.k] + r;
                for (let k = 0; k < count; ++k) off[c][GUESSES * i + k] = capped(value - guesses[k]);
            }
        }
        return values;
    };

    /** A bit a pixel. */
    const bitmap = (reader, width, n) => {
        const bits = new Uint8Array(n + 1), chances = R.bits.contexts(64), at = {};
        for (let i = 0; i < n; ++i) {
            around(at, i, width, n);
            bits[i] = reader.bit(chances, bits[at.w] << 5 | bits[at.n] << 4 | bits[at.nw] << 3 | bits[at.ne] << 2 | bits[at.ww] << 1 | bits[at.nn]);
        }
        return bits;
    };
    return {planes, bitmap};
})();
