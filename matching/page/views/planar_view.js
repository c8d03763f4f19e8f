// Three views of curves in the plane with one frame: reference, template and result.

import { edgesOfPlane } from "../data/octree.js";
import { fly } from "./flight.js";
import { PlanarStage } from "./planar_stage.js";

export class PlanarView extends PlanarStage {
  flyTo(place) {
    this.mark = place;
    const from = this.frame, to = { centre: place.slice(0, 2), size: Math.min(from.size, 0.25 * this.model.bounds.diagonal) };
    this.endFlight?.();
    this.endFlight = fly((s) => this.moveTo({ centre: from.centre.map((x, k) => x + s * (to.centre[k] - x)), size: from.size * (to.size / from.size) ** s }));
  }

  drawPane(context, name, x, y, scale) {
    const { model, state, frame } = this, level = model.levels[state.level].positions, coloring = this.colorings[state.coloring];
    const at = (from, to, t) => (i) => [0, 1].map((k) => (k ? y - scale * (mix(from, to, t, i, 1) - frame.centre[1]) : x + scale * (mix(from, to, t, i, 0) - frame.centre[0])));
    const t = name === "result" ? state.t : 0, { reference, template } = model;
    if (state.grid !== "none" && name !== "template") {
      const grid = model.grid();
      this.drawGrid(context, at(grid.from, grid.to, t), scale);
    }
    if (name === "result" && state.overlay) this.drawFilled(context, template.facets, at(template.positions, template.positions, 0));
    if (name === "template") this.drawCurve(context, template.facets, at(template.positions, template.positions, 0), coloring.template(), 3.5);
    else this.drawCurve(context, reference.facets, at(reference.positions, level, t), coloring.reference(), 3.5, coloring.checker && reference.positions);
  }

  drawGrid(context, at) {
    this.edges ??= edgesOfPlane(this.model.grid());
    context.strokeStyle = this.scheme.lineText;
    context.lineWidth = 0.6;
    context.beginPath();
    for (const [a, b] of this.edges) {
      context.moveTo(...at(a));
      context.lineTo(...at(b));
    }
    context.stroke();
  }

  placeMark(name, { width, height }, scale) {
    const mark = this.panes[name].querySelector(".mark");
    mark.hidden = !this.mark || name === "reference";
    if (mark.hidden) return;
    mark.style.transform = `translate(${width / 2 + scale * (this.mark[0] - this.frame.centre[0])}px, ${height / 2 - scale * (this.mark[1] - this.frame.centre[1])}px)`;
  }
}

function mix(from, to, t, i, k) {
  return (1 - t) * from[3 * i + k] + t * to[3 * i + k];
}
