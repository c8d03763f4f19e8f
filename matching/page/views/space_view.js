// Three views of surfaces with one camera: reference, template and result.

import { BufferAttribute, BufferGeometry, LineSegments, Mesh, Scene, Vector3 } from "three";
import { sliceOfSpace } from "../data/octree.js";
import { ghost, normalsOf, SpaceStage, surfaceGeometry } from "./space_stage.js";
import { lineMaterial, surfaceMaterial } from "./surface_material.js";

export class SpaceView extends SpaceStage {
  constructor(stage, panes, model, colorings) {
    super(stage, panes, model);
    this.colorings = colorings;
    this.own = surfaceGeometry(model.reference.positions, model.reference.facets, model.onGrid());
    this.other = surfaceGeometry(model.template.positions, model.template.facets);
    this.lines = new BufferGeometry();
    for (const name of ["reference", "template", "result"]) {
      const mesh = new Mesh(name === "template" ? this.other : this.own, surfaceMaterial(model.referenceBounds));
      const grid = new LineSegments(this.lines, lineMaterial());
      const scene = new Scene();
      scene.add(mesh, grid);
      mesh.frustumCulled = grid.frustumCulled = grid.visible = false;
      grid.renderOrder = 1;
      this.views[name] = { mesh, grid, scene };
    }
    this.overlay = ghost(this.other, model.referenceBounds);
    this.views.result.scene.add(this.overlay);
  }

  setScheme(scheme) {
    for (const { grid } of Object.values(this.views)) grid.material.uniforms.color.value = scheme.line;
    this.invalidate();
  }

  /** \param state coloring, t in [0, 1], level (number in model.levels), overlay, grid ("none" or an axis), place in [0, 1], cut */
  show(state) {
    const level = this.model.levels[state.level], coloring = this.colorings[state.coloring];
    if (this.shownLevel !== level) {
      this.own.setAttribute("end", new BufferAttribute(level.positions, 3));
      this.own.setAttribute("normalEnd", normalsOf(level.positions, this.model.reference.facets));
      this.shownLevel = level;
    }
    if (this.shownColoring !== coloring) {
      this.own.setAttribute("color", new BufferAttribute(coloring.reference(), 3, true));
      this.other.setAttribute("color", new BufferAttribute(coloring.template(), 3, true));
      this.shownColoring = coloring;
    }
    this.showSlice(state);
    for (const [name, { mesh, grid }] of Object.entries(this.views)) {
      const t = name === "result" ? state.t : 0, u = mesh.material.uniforms;
      u.t.value = grid.material.uniforms.t.value = t;
      u.checker.value = coloring.checker && name !== "template" ? 1 : 0;
      if (name !== "template") this.setCut(u.cut.value, state);
    }
    this.overlay.visible = state.overlay;
    this.invalidate();
  }

  setCut(plane, { grid, place, cut }) {
    if (!cut || grid === "none") plane.set(0, 0, 0, 1);
    else plane.set(...[0, 1, 2].map((k) => (k === +grid ? 1 : 0)), place);
  }

  showSlice({ grid, place }) {
    const key = `${grid} ${place}`;
    if (key === this.shownSlice) return;
    this.shownSlice = key;
    const { from, to } = this.model.grid(), ends = grid === "none" ? [] : sliceOfSpace(this.model.grid(), +grid, Math.min(place, 0.9999));
    const points = (positions) => {
      const list = new Float32Array(3 * ends.length);
      ends.forEach(([a, b, w], i) => { for (let k = 0; k < 3; ++k) list[3 * i + k] = (1 - w) * positions[3 * a + k] + w * positions[3 * b + k]; });
      return new BufferAttribute(list, 3);
    };
    this.lines.setAttribute("position", points(from));
    this.lines.setAttribute("end", points(to));
    this.views.reference.grid.visible = this.views.result.grid.visible = ends.length > 0;
  }

  /** Goes to a place of the shape "deformed" or "template", and marks it. */
  flyTo(place, shape) {
    const geometry = shape === "template" ? this.other : this.own, ends = geometry.attributes.end.array;
    let nearest = 0, least = Infinity;
    for (let i = 0; i < ends.length; i += 3) {
      const d = (ends[i] - place[0]) ** 2 + (ends[i + 1] - place[1]) ** 2 + (ends[i + 2] - place[2]) ** 2;
      if (d < least) [nearest, least] = [i, d];
    }
    this.mark = place;
    this.camera.flyTo(place, Array.from(geometry.attributes.normalEnd.array.subarray(nearest, nearest + 3)));
  }

  reset() {
    this.mark = null;
    this.camera.reset();
  }

  placeMark(pane, { width, height }, camera, name) {
    const mark = pane.querySelector(".mark");
    mark.hidden = !this.mark || name === "reference";
    if (mark.hidden) return;
    const p = new Vector3().fromArray(this.mark).project(camera);
    mark.style.transform = `translate(${((p.x + 1) / 2) * width}px, ${((1 - p.y) / 2) * height}px)`;
  }
}
