// Elements of the page.

export const byId = (id) => document.getElementById(id);

/** An element with attributes (on... are listeners) and children, which are elements or texts. */
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (typeof value === "boolean") made.toggleAttribute(key, value);
    else made.setAttribute(key, value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

/** A part of the side panel that opens and closes. */
export function section(title, open, ...children) {
  return element("details", { open }, element("summary", {}, element("h2", {}, title)), ...children);
}

/** A table of rows of cells; the first cell of a row is its head. */
export function table(head, rows) {
  return element("table", {},
    head ? element("thead", {}, element("tr", {}, ...head.map((cell) => element("th", { scope: "col" }, cell)))) : null,
    element("tbody", {}, ...rows.map(([first, ...rest]) =>
      element("tr", {}, element("th", { scope: "row" }, first), ...rest.map((cell) => element("td", {}, cell))))));
}
