// The view of a surface that modes move.

import { BufferAttribute, Mesh, Scene } from "three";
import { ghost, SpaceStage, surfaceGeometry } from "../views/space_stage.js";
import { surfaceMaterial } from "../views/surface_material.js";

export class CohortSpaceView extends SpaceStage {
  constructor(stage, panes, model, colorings) {
    super(stage, panes, model);
    this.colorings = colorings;
    this.geometry = surfaceGeometry(Float32Array.from(model.mean), model.facets);
    this.geometry.setAttribute("color", new BufferAttribute(new Uint8Array(model.mean.length), 3, true));
    const mean = surfaceGeometry(model.mean, model.facets);
    mean.setAttribute("color", new BufferAttribute(new Uint8Array(model.mean.length).fill(150), 3, true));
    const mesh = new Mesh(this.geometry, surfaceMaterial(model.bounds)), scene = new Scene();
    this.mean = ghost(mean, model.bounds);
    mesh.frustumCulled = false;
    scene.add(mesh, this.mean);
    this.views.shape = { scene };
  }

  setScheme() {
    this.invalidate();
  }

  /** \param state positions, coloring, overlay */
  show({ positions, coloring, overlay }) {
    const { position, color } = this.geometry.attributes;
    if (positions !== this.shown) {
      position.array.set(positions);
      position.needsUpdate = true;
      this.geometry.computeVertexNormals();
      this.shown = positions;
    }
    color.array.set(this.colorings[coloring].colors(positions));
    color.needsUpdate = true;
    this.mean.visible = overlay;
    this.invalidate();
  }

  reset() {
    this.camera.reset();
  }
}
