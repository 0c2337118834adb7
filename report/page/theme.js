// What the reader may change: the theme, the filter, what is unfolded. And the page on paper.
R.remember = (key, value) => {
    try {
        if (value === undefined) return localStorage.getItem(key);
        localStorage.setItem(key, value);
    } catch {
        // Some browsers give pages from disk no storage: then nothing is remembered.
    }
    return null;
};

R.setTheme = (name) => {
    if (name === "light" || name === "dark") document.documentElement.dataset.theme = name;
    else delete document.documentElement.dataset.theme;
    R.charts.forEach((draw) => draw());
};

R.isDark = () => {
    const {theme} = document.documentElement.dataset;
    return theme ? theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
};

R.themeSwitch = () => {
    const now = R.remember("raysteps-theme") ?? "auto";
    const choose = (name) => () => {
        R.remember("raysteps-theme", name);
        R.setTheme(name);
    };
    return R.h("fieldset", {class: "segments"}, R.h("legend", {text: "Theme"}), ...[["auto", "Auto"], ["light", "Light"], ["dark", "Dark"]].map(([name, text]) => {
        const input = R.h("input", {type: "radio", name: "theme", value: name, on: {change: choose(name)}});
        input.checked = now === name;
        return R.h("label", {}, input, R.h("span", {text}));
    }));
};

R.filterSwitch = () => {
    const count = R.needAttention.length;
    const input = R.h("input", {type: "checkbox", role: "switch", id: "only-failed", on: {change: () => (document.body.dataset.filter = input.checked ? "open" : "all")}});
    return R.h("label", {class: "switch"}, input, R.h("i", {"aria-hidden": "true"}), R.h("span", {text: "Only what failed"}), R.h("span", {class: "count", text: String(count)}));
};

R.expandSwitch = () => {
    let open = false;
    const button = R.h("button", {type: "button", class: "quiet", text: "Unfold all", on: {click: () => {
        open = !open;
        R.expanders.forEach(({expand, urgent}) => expand(open || urgent));
        button.textContent = open ? "Fold again" : "Unfold all";
    }}});
    return button;
};

/** Paper is light. What is folded stays folded: it passed. */
R.preparePrint = () => {
    let before = null;
    addEventListener("beforeprint", () => {
        before ??= {theme: document.documentElement.dataset.theme};
        R.setTheme("light");
    });
    addEventListener("afterprint", () => {
        R.setTheme(before?.theme);
        before = null;
    });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => R.charts.forEach((draw) => draw()));
};
