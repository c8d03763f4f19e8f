// What all views of curves in the plane do: one frame for all panes, drawn again when something has changed.

export class PlanarStage {
  /** \param panes elements over which the views lie, by name; drawPane draws one */
  constructor(stage, panes, model, colorings) {
    Object.assign(this, { stage, panes, model, colorings });
    this.canvas = document.createElement("canvas");
    this.canvas.className = "surfaces";
    stage.prepend(this.canvas);
    // The same as for surfaces, as far as it has a meaning here.
    this.camera = {
      turn: (right, up) => this.moveTo({ ...this.frame, centre: [this.frame.centre[0] - 0.5 * right * this.frame.size, this.frame.centre[1] - 0.5 * up * this.frame.size] }),
      zoom: (factor) => this.moveTo({ ...this.frame, size: this.frame.size * factor }),
    };
    this.reset();
    this.listen();
    new ResizeObserver(() => this.invalidate()).observe(stage);
  }

  reset() {
    const { bounds } = this.model;
    this.mark = null;
    this.moveTo({ centre: bounds.centre.slice(0, 2), size: 1.2 * Math.max(...bounds.high.map((x, k) => x - bounds.low[k])) });
  }

  /** \param frame centre, and the side of the square that a view shows at least */
  moveTo(frame) {
    this.endFlight?.();
    this.frame = frame;
    this.invalidate();
  }

  setScheme(scheme) {
    this.scheme = scheme;
    this.invalidate();
  }

  show(state) {
    this.state = { ...state };
    this.invalidate();
  }

  listen() {
    let last = null;
    this.stage.addEventListener("pointerdown", (e) => { last = [e.clientX, e.clientY]; });
    window.addEventListener("pointerup", () => { last = null; });
    window.addEventListener("pointermove", (e) => {
      if (!last) return;
      const scale = this.frame.size / this.smallest;
      this.moveTo({ ...this.frame, centre: [this.frame.centre[0] - (e.clientX - last[0]) * scale, this.frame.centre[1] + (e.clientY - last[1]) * scale] });
      last = [e.clientX, e.clientY];
    });
    this.stage.addEventListener("wheel", (e) => {
      e.preventDefault();
      this.camera.zoom(Math.exp(Math.sign(e.deltaY) * 0.12));
    }, { passive: false });
  }

  invalidate() {
    this.pending ??= requestAnimationFrame(() => {
      this.pending = null;
      if (this.state && this.scheme) this.draw();
    });
  }

  draw() {
    const ratio = window.devicePixelRatio || 1, { canvas, stage } = this, box = stage.getBoundingClientRect();
    canvas.width = box.width * ratio;
    canvas.height = box.height * ratio;
    Object.assign(canvas.style, { width: `${box.width}px`, height: `${box.height}px` });
    const context = canvas.getContext("2d");
    for (const name of Object.keys(this.panes)) {
      const pane = this.panes[name].getBoundingClientRect(), side = Math.min(pane.width, pane.height);
      this.smallest = side;
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      context.save();
      context.beginPath();
      context.rect(pane.left - box.left, pane.top - box.top, pane.width, pane.height);
      context.clip();
      this.drawPane(context, name, pane.left - box.left + pane.width / 2, pane.top - box.top + pane.height / 2, side / this.frame.size);
      context.restore();
      this.placeMark?.(name, pane, side / this.frame.size);
    }
  }

  drawFilled(context, facets, at) {
    context.beginPath();
    let end = -1;
    // Rings come facet after facet; where they do not, each begins a new one, which fills less and harms nothing.
    for (let i = 0; i < facets.length; i += 2) {
      if (facets[i] !== end) context.moveTo(...at(facets[i]));
      context.lineTo(...at((end = facets[i + 1])));
    }
    context.fillStyle = "rgb(122 152 190 / 0.35)";
    context.fill("evenodd");
  }

  drawCurve(context, facets, at, colors, width, pattern) {
    context.lineWidth = width;
    context.lineCap = "round";
    const cell = this.model.referenceBounds.diagonal / 28;
    for (let i = 0; i < facets.length; i += 2) {
      const a = facets[i], b = facets[i + 1];
      const dark = pattern && (Math.floor(pattern[3 * a] / cell) + Math.floor(pattern[3 * a + 1] / cell)) & 1 ? 0.55 : 1;
      context.strokeStyle = `rgb(${[0, 1, 2].map((k) => Math.round((dark * (colors[3 * a + k] + colors[3 * b + k])) / 2)).join(" ")})`;
      context.beginPath();
      context.moveTo(...at(a));
      context.lineTo(...at(b));
      context.stroke();
    }
  }
}
