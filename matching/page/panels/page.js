// What every page does: its colours follow the system, keys are listened to, and what fails is said.

import { byId, element } from "./dom.js";

function currentScheme() {
  const style = getComputedStyle(document.documentElement), color = (name) => style.getPropertyValue(name).trim();
  const rgb = color("--grid").match(/[\da-f]{2}/gi).map((x) => parseInt(x, 16) / 255);
  return { text: color("--text"), faint: color("--faint"), line: rgb, lineText: color("--grid") };
}

/** Light or dark: the system's until the button says otherwise. \param apply takes the colours for what is drawn */
export function followScheme(button, apply) {
  const system = matchMedia("(prefers-color-scheme: dark)"), root = document.documentElement;
  let dark = system.matches;
  const set = (value) => {
    dark = value;
    root.dataset.scheme = dark ? "dark" : "light";
    button.textContent = dark ? "Light" : "Dark";
    apply(currentScheme());
  };
  system.addEventListener("change", () => set(system.matches));
  button.addEventListener("click", () => set(!dark));
  set(dark);
}

/** Gives the stage the focus where it is clicked, and its keys to the page. \param controls togglePlaying, nextColoring */
export function listenToKeys(stage, view, controls, reset) {
  stage.tabIndex = 0;
  stage.setAttribute("aria-label", "Shapes; arrow keys turn, + and - change the size, 0 resets");
  stage.addEventListener("pointerdown", () => stage.focus({ preventScroll: true }));
  const turn = 0.12;
  const anywhere = { " ": controls.togglePlaying, c: controls.nextColoring, d: () => byId("scheme").click(), 0: reset, Escape: reset };
  const onStage = { ArrowLeft: () => view.camera.turn(-turn, 0), ArrowRight: () => view.camera.turn(turn, 0), ArrowUp: () => view.camera.turn(0, -turn),
    ArrowDown: () => view.camera.turn(0, turn), "+": () => view.camera.zoom(0.9), "=": () => view.camera.zoom(0.9), "-": () => view.camera.zoom(1 / 0.9) };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const inControl = event.target.closest?.("input, select, button, summary");
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key; // letters with Shift or Caps Lock as well
    const action = document.activeElement === stage && onStage[key] ? onStage[key] : inControl ? null : anywhere[key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}

/** Runs the page, and tells when it is ready or has failed. */
export function begin(main) {
  main().then(() => { document.documentElement.dataset.ready = "true"; }).catch((error) => {
    document.querySelector("main").replaceChildren(element("p", { class: "message" }, `This report cannot be shown: ${error.message}`));
    document.documentElement.dataset.ready = "failed";
    throw error;
  });
}
