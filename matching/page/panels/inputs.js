// Inputs of the controls.

import { element } from "./dom.js";

/** A labelled slider: its box, and a function that sets it. \param take (value) is called, then `changed` \param text of a value */
export function slider(id, label, min, max, step, value, take, changed, text) {
  const output = element("output", { for: id }, text(value));
  const input = element("input", { type: "range", id, min, max, step, oninput: () => {
    output.textContent = text(+input.value);
    take(+input.value);
    changed();
  } });
  input.value = value;
  const box = element("div", { class: "slider" }, element("label", { for: id }, label), input, output);
  return { box, set: (x) => { input.value = x; output.textContent = text(x); } };
}

export function checkbox(id, label, checked, take) {
  const input = element("input", { type: "checkbox", id, onchange: () => take(input.checked) });
  input.checked = checked;
  return element("label", { class: "check" }, input, label);
}

/**
 * A button that plays and pauses: `begin` is called first, then `step` with the seconds since then for each frame, until it returns false.
 * \returns the button, and functions that toggle and stop it
 */
export function playButton(attributes, begin, step) {
  let playing = 0;
  const show = (sign, label) => {
    button.textContent = sign;
    button.setAttribute("aria-label", label);
  };
  const stop = () => {
    cancelAnimationFrame(playing);
    playing = 0;
    show("▶", "Play");
  };
  const toggle = () => {
    if (playing) return stop();
    show("❚❚", "Pause");
    begin();
    let first = null;
    const frame = (now) => {
      first ??= now;
      if (step((now - first) / 1000)) playing = requestAnimationFrame(frame);
      else stop();
    };
    playing = requestAnimationFrame(frame);
  };
  const button = element("button", { type: "button", class: "play", ...attributes, onclick: toggle });
  stop();
  return { button, toggle, stop };
}
