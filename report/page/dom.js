// Raysteps' report: one namespace for the scripts of the page. All text enters the page as text, never as markup.
const R = (globalThis.R = {});

/** An element. Properties: class, text, on (listeners by name), data, style (custom properties and lengths), attributes. */
R.h = (name, props = {}, ...children) => R.fill(document.createElement(name), props, children);

/** The same for SVG. */
R.svg = (name, props = {}, ...children) =>
    R.fill(document.createElementNS("http://www.w3.org/2000/svg", name), props, children);

R.fill = (element, props, children) => {
    for (const [key, value] of Object.entries(props)) {
        if (value === undefined || value === null || value === false) continue;
        if (key === "text") element.textContent = value;
        else if (key === "on") for (const [name, run] of Object.entries(value)) element.addEventListener(name, run);
        else if (key === "data") Object.assign(element.dataset, value);
        else if (key === "style") for (const [name, v] of Object.entries(value)) element.style.setProperty(name, v);
        else element.setAttribute(key, value === true ? "" : String(value));
    }
    element.append(...children.flat().filter((child) => child !== null && child !== undefined && child !== false));
    return element;
};

/** A list, whatever the file holds there. */
R.list = (value) => (Array.isArray(value) ? value : []);
R.object = (value) => (value && typeof value === "object" && !Array.isArray(value) ? value : {});
/** Text, whatever the file holds there. */
R.text = (value) => (value === undefined || value === null ? "" : typeof value === "object" ? JSON.stringify(value) : String(value));

R.copyButton = (text, label) => {
    const button = R.h("button", {class: "copy", type: "button", "aria-label": label, text: "Copy"});
    const done = (word) => {
        button.textContent = word;
        setTimeout(() => (button.textContent = "Copy"), 1600);
    };
    // Pages opened from disk do not have the clipboard in every browser: there the line is selected instead.
    const select = () => {
        const range = document.createRange();
        range.selectNodeContents(button.parentElement.querySelector("code"));
        getSelection().removeAllRanges();
        getSelection().addRange(range);
        done(document.execCommand("copy") ? "Copied" : "Selected");
    };
    button.addEventListener("click", () => {
        if (!navigator.clipboard) return select();
        navigator.clipboard.writeText(text).then(() => done("Copied"), select);
    });
    return button;
};

/** A colour of the style sheet as the canvas takes it, for the theme in force. */
R.color = (name) => {
    R.probe ??= document.body.appendChild(R.h("span", {hidden: true, "aria-hidden": "true"}));
    R.probe.style.color = `var(${name})`;
    return getComputedStyle(R.probe).color;
};
