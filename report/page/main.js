// Puts the page together.
(() => {
    R.setTheme(R.remember("raysteps-theme"));
    const graded = R.steps.length > 0 || !R.hasSpeed;
    document.title = graded ? `Raysteps report: ${R.points(R.object(R.results.score).points)} of ${R.points(R.object(R.results.score).max)} points` : "Raysteps: speed against accuracy";
    document.getElementById("rail").append(...R.rail());
    document.getElementById("main").append(...(graded ? [R.hero(), R.heroes(), R.galleryWall(), R.rubric(), ...R.steps.map(R.stepSection), R.speed(),
        R.h("p", {class: "nothing-failed", text: R.needAttention.length ? "" : "Nothing failed: there is nothing to show under this filter."}), R.colophon()] : [R.speed({heading: "h1"}), R.colophon()]).filter(Boolean));
    R.preparePrint();
    R.unpackNear(document.getElementById("main"));
    const goThere = () => {
        const target = document.getElementById(location.hash.slice(1));
        const fold = target?.closest("details");
        if (fold) fold.open = true;
        target?.scrollIntoView();
    };
    if (location.hash.length > 1) goThere();
    addEventListener("hashchange", goThere);

    // The step that is being read is marked in the rail.
    const links = new Map([...document.querySelectorAll(".rail-list > li > a")].map((a) => [a.getAttribute("href").slice(1), a]));
    const seen = new IntersectionObserver((entries) => entries.forEach((entry) => entry.isIntersecting && links.forEach((a, id) =>
        id === entry.target.id ? a.setAttribute("aria-current", "true") : a.removeAttribute("aria-current"))), {rootMargin: "-20% 0px -70% 0px"});
    links.forEach((_, id) => document.getElementById(id) && seen.observe(document.getElementById(id)));
})();
