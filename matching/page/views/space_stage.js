// What all views of surfaces do: one camera for all panes, drawn again when something has changed.

import { BufferAttribute, BufferGeometry, Mesh, WebGLRenderer } from "three";
import { SharedCamera } from "./camera.js";
import { surfaceMaterial } from "./surface_material.js";

/** Normals at the vertices, as an attribute. */
export function normalsOf(positions, facets) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(facets, 1));
  geometry.computeVertexNormals();
  return geometry.attributes.normal;
}

/** \param onGrid where the vertices are on a grid, by which they can be cut */
export function surfaceGeometry(positions, facets, onGrid) {
  const geometry = new BufferGeometry(), position = new BufferAttribute(positions, 3), normal = normalsOf(positions, facets);
  const attributes = { position, end: position, normal, normalEnd: normal, onGrid: new BufferAttribute(onGrid ?? positions, 3) };
  for (const [name, attribute] of Object.entries(attributes)) geometry.setAttribute(name, attribute);
  geometry.setIndex(new BufferAttribute(facets, 1));
  return geometry;
}

/** A translucent surface over another one. */
export function ghost(geometry, bounds) {
  const mesh = new Mesh(geometry, surfaceMaterial(bounds));
  Object.assign(mesh.material, { transparent: true, depthWrite: false });
  mesh.material.uniforms.opacity.value = 0.3;
  mesh.frustumCulled = false;
  return mesh;
}

export class SpaceStage {
  /** \param panes elements over which the views lie, by name; a view is { scene } in `views` \throws Error without WebGL */
  constructor(stage, panes, model) {
    Object.assign(this, { stage, panes, model, views: {} });
    if (!document.createElement("canvas").getContext("webgl")) throw new Error("it is switched off, or there is no driver");
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.autoClear = false;
    this.renderer.domElement.className = "surfaces";
    stage.prepend(this.renderer.domElement);
    this.camera = new SharedCamera(stage, model, () => this.invalidate());
    // The controls take their events further down; what they have understood is asked for before the next frame.
    for (const event of ["mousemove", "wheel", "touchmove", "mouseup"])
      window.addEventListener(event, () => this.invalidate(), { capture: true, passive: true });
    for (const event of ["mousedown", "wheel", "touchstart"])
      stage.addEventListener(event, () => this.camera.stop(), { capture: true, passive: true });
    new ResizeObserver(() => this.resize()).observe(stage);
    this.resize();
  }

  resize() {
    this.renderer.setSize(this.stage.clientWidth, this.stage.clientHeight);
    this.invalidate();
  }

  invalidate() {
    this.frame ??= requestAnimationFrame(() => {
      this.frame = null;
      this.draw();
    });
  }

  draw() {
    this.camera.follow();
    const stage = this.stage.getBoundingClientRect(), { camera } = this.camera, { renderer } = this;
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.setScissorTest(true);
    for (const [name, { scene }] of Object.entries(this.views)) {
      const pane = this.panes[name].getBoundingClientRect();
      if (pane.width < 2 || pane.height < 2) continue;
      const box = [pane.left - stage.left, stage.bottom - pane.bottom, pane.width, pane.height];
      renderer.setViewport(...box);
      renderer.setScissor(...box);
      camera.aspect = pane.width / pane.height;
      // A narrow view shows as much to the sides as a square one.
      camera.zoom = Math.min(1, camera.aspect);
      camera.updateProjectionMatrix();
      renderer.render(scene, camera);
      this.placeMark?.(this.panes[name], pane, camera, name);
    }
  }
}
