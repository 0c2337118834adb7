// Pictures are unpacked when what is seen comes near them, for all of a report's take seconds; all of them before it is printed.
(() => {
    const waiting = new Map();  // a box on the page -> its picture: the blobs that it needs, and what unpacks and draws it
    const near = new Set();

    /** Unpacks a picture when its box comes near. Returns the box. */
    R.whenNear = (box, {blobs, unpack}) => {
        waiting.set(box, {blobs: blobs.filter(Boolean), unpack});
        return box;
    };

    const finish = (box) => {
        const {unpack} = waiting.get(box);
        waiting.delete(box);
        near.delete(box);
        unpack();
    };

    /** The box nearest to what is seen, and how far away it is. */
    const nearest = () => {
        let found = {box: null, away: Infinity};
        for (const box of near) {
            const {top, bottom} = box.getBoundingClientRect(), away = Math.max(0, top - innerHeight, -bottom);
            if (away < found.away) found = {box, away};
        }
        return found;
    };

    // A blob at a time: the page stays alive, and who scrolls on does not wait for what has gone by.
    let next = 0;
    const work = () => {
        clearTimeout(next);
        const {box, away} = nearest();
        document.documentElement.toggleAttribute("data-ready", away > 0);  // what is seen is drawn
        if (!box) return;
        next = setTimeout(work);
        const {blobs} = waiting.get(box);
        if (blobs.length > 0) R.pixels.get(blobs.shift());
        if (blobs.length === 0) finish(box);
    };

    /** From when the page stands. Its main part is watched so that a page without pictures is ready, too. */
    R.unpackNear = (main) => {
        const observer = new IntersectionObserver((entries) => {
            for (const {target, isIntersecting} of entries) isIntersecting && waiting.has(target) ? near.add(target) : near.delete(target);
            work();
        }, {rootMargin: "50% 0px"});
        [main, ...waiting.keys()].forEach((box) => observer.observe(box));
    };

    // Printing waits for no promise. Here, ahead of what puts the pictures on paper.
    addEventListener("beforeprint", () => [...waiting.keys()].forEach(finish));
})();
