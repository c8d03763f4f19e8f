// The view of a curve that modes move.

import { PlanarStage } from "../views/planar_stage.js";

export class CohortPlanarView extends PlanarStage {
  drawPane(context, name, x, y, scale) {
    const { model, state, frame } = this;
    const at = (positions) => (i) => [x + scale * (positions[3 * i] - frame.centre[0]), y - scale * (positions[3 * i + 1] - frame.centre[1])];
    if (state.overlay) this.drawFilled(context, model.facets, at(model.mean));
    this.drawCurve(context, model.facets, at(state.positions), this.colorings[state.coloring].colors(state.positions), 4);
  }
}
