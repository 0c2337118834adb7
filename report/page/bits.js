// Reads what report/bit_code.h writes: bits by learnt chances, in the very same integers.
R.bits = (() => {
    const MOST_SEEN = 40, MIXING_RATE = 24, FARTHEST = 2047, OPINIONS = 3;
    const rates = Int32Array.from({length: MOST_SEEN + 1}, (_, seen) => Math.floor(32768 / (2 * seen + 3)));
    const chanceOf = Int32Array.from({length: 2 * FARTHEST + 1}, (_, i) => Math.min(4095, Math.max(1, Math.round(4096 / (1 + Math.exp((FARTHEST - i) / 256))))));
    const oddsOf = new Int32Array(4096);
    for (let p = 0, d = 0; p < 4096; ++p) {
        while (d < 2 * FARTHEST && chanceOf[d] < p) ++d;
        oddsOf[p] = d - FARTHEST;
    }

    /** n contexts, each with its chance of a 1. */
    const contexts = (n) => ({one: new Uint16Array(n).fill(32768), seen: new Uint8Array(n)});
    /** n sets of weights. */
    const weights = (n) => new Int32Array(OPINIONS * n).fill(23000);
    const learn = (set, i, bit) => {
        const one = set.one[i], seen = set.seen[i];
        set.one[i] = one + (((bit ? 65535 : 0) - one) * rates[seen] >> 14);
        if (seen < MOST_SEEN) set.seen[i] = seen + 1;
    };

    const reader = (bytes) => {
        // Numbers of 32 bits in an array: in variables engines would put each new one on the heap.
        const range = new Uint32Array([0, 0xffffffff, 0]), LOW = 0, HIGH = 1, VALUE = 2;
        let at = 0;
        const shift = () => (range[VALUE] = (range[VALUE] << 8) | (at < bytes.length ? bytes[at++] : 0));
        for (let i = 0; i < 4; ++i) shift();
        const narrow = (chance) => {
            const middle = range[LOW] + ((range[HIGH] - range[LOW]) >>> 12) * chance, bit = range[VALUE] <= middle ? 1 : 0;
            if (bit) range[HIGH] = middle;
            else range[LOW] = middle + 1;
            while ((range[LOW] ^ range[HIGH]) >>> 24 === 0) {
                range[LOW] <<= 8;
                range[HIGH] = (range[HIGH] << 8) | 255;
                shift();
            }
            return bit;
        };
        const bit = (set, i) => {
            const read = narrow(Math.min(4095, Math.max(1, set.one[i] >> 4)));
            learn(set, i, read);
            return read;
        };
        /** Three sets, a context of each, and which weights mix them. */
        const mixed = (a, i, b, j, c, k, mix, set) => {
            const w = OPINIONS * set, p = oddsOf[a.one[i] >> 4], q = oddsOf[b.one[j] >> 4], r = oddsOf[c.one[k] >> 4];
            const odds = Math.floor((p * mix[w] + q * mix[w + 1] + r * mix[w + 2]) / 65536);
            const chance = chanceOf[Math.min(FARTHEST, Math.max(-FARTHEST, odds)) + FARTHEST], read = narrow(chance);
            const error = ((read << 12) - chance) * MIXING_RATE;
            mix[w] += (p * error + 0x8000) >> 16;
            mix[w + 1] += (q * error + 0x8000) >> 16;
            mix[w + 2] += (r * error + 0x8000) >> 16;
            learn(a, i, read);
            learn(b, j, read);
            learn(c, k, read);
            return read;
        };
        const plain = (count) => {
            let read = 0;
            while (count-- > 0) read = read << 1 | narrow(2048);
            return read;
        };
        return {bit, mixed, plain};
    };
    return {reader, contexts, weights};
})();
