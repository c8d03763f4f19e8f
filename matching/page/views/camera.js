// One camera for all views: turned by mouse and keys, sent to places.

import { PerspectiveCamera, Vector3 } from "three";
import { TrackballControls } from "trackball-controls";
import { fly } from "./flight.js";

const fieldOfView = 24;

/** \param element takes the mouse  \param changed is called when the camera has moved */
export class SharedCamera {
  constructor(element, model, changed) {
    this.model = model;
    this.changed = changed;
    this.camera = new PerspectiveCamera(fieldOfView, 1, 0.001 * model.bounds.diagonal, 50 * model.bounds.diagonal);
    this.controls = new TrackballControls(this.camera, element);
    Object.assign(this.controls, { staticMoving: true, rotateSpeed: 3, zoomSpeed: 1.2, panSpeed: 0.6, keys: [],
      minDistance: 0.02 * model.bounds.diagonal, maxDistance: 20 * model.bounds.diagonal });
    this.reset();
  }

  get position() { return this.camera.position; }

  /** Distance from which `size` fills the height of a view. */
  distanceFor(size) {
    return size / 2 / Math.tan((fieldOfView / 2 / 180) * Math.PI);
  }

  reset() {
    const { camera, bounds } = this.model;
    this.stop();
    this.controls.target.fromArray(camera.target);
    this.camera.up.fromArray(camera.up);
    this.camera.position.fromArray(camera.backward).multiplyScalar(this.distanceFor(1.06 * Math.max(2 * camera.half_height, 0.2 * bounds.diagonal)))
      .add(this.controls.target);
    this.changed();
  }

  /** Does what the mouse has asked for since the last time. */
  follow() {
    this.controls.handleResize();
    this.controls.update();
  }

  /** Turns by angles around the up axis and the one to the right. */
  turn(right, up) {
    const eye = this.camera.position.clone().sub(this.controls.target);
    const axis = new Vector3().crossVectors(this.camera.up, eye).normalize();
    eye.applyAxisAngle(this.camera.up.clone().normalize(), right).applyAxisAngle(axis, up);
    this.camera.up.applyAxisAngle(axis, up);
    this.camera.position.copy(this.controls.target).add(eye);
    this.changed();
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.changed();
  }

  stop() {
    this.endFlight?.();
  }

  /** Goes to where the place is seen from the direction `normal`, a quarter of the shapes filling the view. */
  flyTo(place, normal) {
    this.stop();
    const target = new Vector3().fromArray(place), { controls, camera } = this;
    const from = { target: controls.target.clone(), eye: camera.position.clone().sub(controls.target) };
    const direction = new Vector3().fromArray(normal).addScaledVector(from.eye.clone().normalize(), 0.35).normalize();
    const far = from.eye.length(), near = Math.min(far, this.distanceFor(0.3 * this.model.bounds.diagonal));
    const start = from.eye.clone().normalize();
    const move = (s) => {
      const turn = start.clone().lerp(direction, s);
      if (turn.lengthSq() < 1e-6) turn.copy(camera.up);
      controls.target.lerpVectors(from.target, target, s);
      camera.position.copy(controls.target).addScaledVector(turn.normalize(), far * (near / far) ** s);
      this.changed();
    };
    this.endFlight = fly(move);
  }
}
