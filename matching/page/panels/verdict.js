// Whether the shapes match, why not, and where.

import { figure } from "../data/format.js";
import { element, section } from "./dom.js";

const words = {
  matched: ["matched", "The shapes match: no figure is unusual."],
  "look-here": ["look here", "A figure is unusual. It may be what the shapes are like; look at the places."],
  "not-matched": ["not matched", "The shapes do not match."],
};

export function outcomeText(verdict) {
  return verdict ? words[verdict.outcome]?.[0] ?? verdict.outcome : "no verdict";
}

/** \param flyTo (place, shape) moves the camera */
export function verdictPanel(model, flyTo) {
  const { verdict } = model.summary;
  if (!verdict) return section("Verdict", true, element("p", {}, "The run has none."));
  const buttons = [];
  const reasons = verdict.reasons.map((reason) => {
    const button = reason.place.length === 0 ? null : element("button", { type: "button", class: "place", "aria-pressed": "false", onclick: () => {
      for (const b of buttons) b.setAttribute("aria-pressed", String(b === button));
      flyTo([...reason.place, 0, 0].slice(0, 3), reason.shape);
    } }, "Show the place");
    if (button) buttons.push(button);
    const at = button ? element("span", { class: "at" }, `on the ${reason.shape === "deformed" ? "result" : reason.shape} at (${reason.place.map((x) => figure(x, 4)).join(", ")})${model.unit ? ` ${model.unit}` : ""}`) : null;
    return element("li", {}, element("p", { class: "what" }, `${reason.what[0].toUpperCase()}${reason.what.slice(1)}.`),
      button ? element("p", {}, button, " ", at) : null, element("p", { class: "advice" }, `${reason.advice[0].toUpperCase()}${reason.advice.slice(1)}.`));
  });
  return section("Verdict", true, element("p", {}, words[verdict.outcome]?.[1] ?? ""), element("ol", { class: "reasons" }, ...reasons));
}
