// What is set below the views: time, level, colours, overlay, grid.

import { element } from "./dom.js";
import { checkbox, playButton, slider } from "./inputs.js";
import { fillLegend } from "./legend.js";

/**
 * \param state is changed by the controls, after which `changed` is called
 * \returns keys: what the keyboard may do
 */
export function addControls(container, model, colorings, state, changed, reset) {
  const time = slider("time", "Time t", 0, 1, 0.01, state.t, (t) => Object.assign(state, { t }), changed, (t) => t.toFixed(2));
  let start = 0;
  const player = playButton({ id: "play", title: "Play (space)" }, () => { start = state.t >= 1 ? 0 : state.t; }, (seconds) => {
    state.t = Math.min(1, start + seconds / 2.5);
    time.set(state.t);
    changed();
    return state.t < 1;
  });
  time.box.title = "φ_t = (1 − t) id + t φ";
  time.box.prepend(player.button);
  time.box.querySelector("input").addEventListener("input", player.stop);

  const names = model.levels.map(({ level }) => String(level));
  const level = slider("level", "Level", 0, names.length - 1, 1, state.level, (value) => Object.assign(state, { level: value }), changed, (i) => names[i]);
  level.box.title = "The result at the end of this level";
  level.box.hidden = names.length < 2;

  const legend = element("div", { id: "legend", "aria-live": "polite" });
  const choice = element("select", { id: "coloring", title: "Colours (C)", onchange: () => { state.coloring = choice.value; showLegend(); changed(); } },
    ...Object.entries(colorings).map(([key, { name }]) => element("option", { value: key }, name)));
  choice.value = state.coloring;
  const showLegend = () => {
    const { scale, note } = colorings[state.coloring];
    const carried = scale && (state.level < names.length - 1 || state.t < 1) ? " Values of the finished result." : "";
    fillLegend(legend, scale, note + carried);
  };

  const overlay = checkbox("overlay", "Template over result", state.overlay, (value) => { state.overlay = value; changed(); });
  const axes = model.dimension === 3 ? [["none", "no grid"], ["0", "across x"], ["1", "across y"], ["2", "across z"]] : [["none", "no grid"], ["0", "all cells"]];
  const place = slider("place", "at (domain sides)", 0, 1, 0.005, state.place, (value) => Object.assign(state, { place: value }), changed, (x) => x.toFixed(3));
  const cut = checkbox("cut", "Cut the shapes there", state.cut, (value) => { state.cut = value; changed(); });
  // They keep their room, so that the views do not change their size.
  const showPlace = () => [place.box, cut].forEach((box) => box.toggleAttribute("data-unused", state.grid === "none" || model.dimension === 2));
  const grid = element("select", { id: "grid", onchange: () => { state.grid = grid.value; showPlace(); changed(); } },
    ...axes.map(([value, name]) => element("option", { value }, name)));
  grid.value = state.grid;
  showPlace();
  showLegend();
  container.append(
    element("div", { class: "row" }, time.box, level.box),
    element("div", { class: "row" }, element("label", { class: "choice" }, "Colours", choice), legend),
    element("div", { class: "row" }, element("label", { class: "choice" }, "Grid", grid), place.box, cut, overlay,
      element("button", { type: "button", id: "reset", title: "The first view (0)", onclick: reset }, "Reset view")));
  return {
    /** Shows what the state says after others have changed it. */
    show: () => {
      player.stop();
      time.set(state.t);
      level.set(state.level);
      showLegend();
      changed();
    },
    togglePlaying: player.toggle,
    nextColoring: () => {
      const keys = Object.keys(colorings);
      state.coloring = choice.value = keys[(keys.indexOf(state.coloring) + 1) % keys.length];
      showLegend();
      changed();
    },
    refresh: showLegend,
  };
}
