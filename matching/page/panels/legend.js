// What the colours mean.

import { gradient } from "../views/color_maps.js";
import { element } from "./dom.js";

/** Shows a scale, where there is one, and a note. */
export function fillLegend(legend, scale, note) {
  legend.replaceChildren(...(scale ? [element("div", { class: "bar", style: `background:${gradient(scale.map)}` }),
    element("div", { class: "ticks" }, ...scale.ticks.map((text) => element("span", {}, text))), element("div", { class: "label" }, scale.label)] : []),
    element("p", { class: "note" }, note));
}
