// SPDX-License-Identifier: MIT
// The region as the engine draws it, and over it the damper as a handle with its tolerance box.
"use strict";

class RegionView {
  /** @param {(f: number, delta: number, done: boolean, source: string) => void} move */
  constructor(move) {
    this.move = move;
    this.place = el("region");
    /** @type {ReturnType<typeof frame_of> | null} */
    this.frame = null;
    /** @type {SVGElement | null} */
    this.handle = null;
    this.f = 0;
    this.delta = 0;
    this.length = 1; // of the axis of Delta
    /** @type {{ pin: Element, at: number[] }[]} */
    this.names = []; // of the sides, which the handle would cover
  }

  /** Another task. @param {Figure | undefined} figure @param {any} report */
  draw(figure, report) {
    const focused = document.activeElement === this.handle && this.handle !== null;
    const node = put_figure(this.place, figure);
    write(el("region-caption"), figure?.caption ?? "");
    this.handle = null;
    this.frame = node && frame_of(node);
    if (!node || !this.frame) return;
    node.setAttribute("role", "group"); // of an image, a screen reader would leave the handle out
    this.names = [...node.querySelectorAll(".plot .pin")].map((pin) => ({
      pin,
      at: (pin.getAttribute("transform") ?? "").match(/-?[\d.]+/g)?.map(Number) ?? [],
    }));
    this.length = plot_units(report.physical).length;
    this.cross = svg("path", { class: "cross" });
    this.box = svg("rect", { class: "allowance" });
    this.handle = svg(
      "g",
      {
        class: "handle",
        tabindex: 0,
        role: "slider",
        "aria-label": "Damper: arrow keys change f and Δ",
      },
      svg("circle", { class: "reach", r: 22 }),
      svg("path", { class: "grip", d: "M0-9L8 0L0 9L-8 0Z" }),
    );
    const { left, top, width, height } = this.frame;
    const clipped = svg("svg", {
      x: left,
      y: top,
      width,
      height,
      viewBox: `0 0 ${width} ${height}`,
    });
    clipped.append(this.box, this.cross);
    this.layer = svg("g", { class: "overlay" }, clipped, this.handle);
    node.append(this.layer);
    this.listen(node, this.handle);
    if (focused) this.handle.focus();
  }

  /** @param {SVGSVGElement} node @param {SVGElement} handle */
  listen(node, handle) {
    /** @type {{ x: number, y: number } | null} from the pointer to the damper */
    let grip = null;
    const place = (/** @type {PointerEvent} */ event) => {
      const matrix = node.getScreenCTM();
      return matrix
        ? new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse())
        : null;
    };
    handle.addEventListener("pointerdown", (event) => {
      const at = place(event);
      if (!at || event.button !== 0) return;
      const [x, y] = this.shown();
      grip = { x: x - at.x, y: y - at.y };
      handle.setPointerCapture(event.pointerId);
      handle.focus();
      event.preventDefault();
    });
    handle.addEventListener("pointermove", (event) => {
      const at = grip && place(event);
      if (grip && at) this.to(at.x + grip.x, at.y + grip.y, false, "");
    });
    const end = () => {
      if (grip) this.move(this.f, this.delta, true, "");
      grip = null;
    };
    handle.addEventListener("pointerup", end);
    handle.addEventListener("lostpointercapture", end);
    handle.addEventListener("keydown", (event) => {
      const step = event.shiftKey ? 0.002 : 0.01;
      const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[
        event.key
      ];
      if (!by || !this.frame) return;
      event.preventDefault();
      const { width, height } = this.frame;
      const [x, y] = this.shown();
      this.to(x + by[0] * step * width, y - by[1] * step * height, true, "keys");
    });
  }

  /** Where the handle is in the figure. */
  shown() {
    const { left, top, width, height, across, up } = /** @type {ReturnType<typeof frame_of>} */ (
      this.frame
    );
    const within = (/** @type {number} */ at, /** @type {number} */ most) =>
      Math.min(most, Math.max(0, at));
    return [
      left + within(across(this.f), width),
      top + within(up(this.delta * this.length), height),
    ];
  }

  /** Takes the handle to a place; out of the frame it stops at the frame. @param {number} x @param {number} y @param {boolean} done @param {string} source */
  to(x, y, done, source) {
    if (!this.frame) return;
    const { left, top, width, height, x_at, y_at, x_range, y_range } = this.frame;
    // As many digits as the figure can show.
    const rounded = (/** @type {number} */ value, /** @type {number} */ range) => {
      const step = 10 ** (Math.floor(Math.log10(range)) - 3);
      return Number((Math.round(value / step) * step).toPrecision(12));
    };
    const f = x_at(Math.min(width, Math.max(0, x - left)));
    const delta = y_at(Math.min(height, Math.max(0, y - top))) / this.length;
    this.move(rounded(f, x_range), rounded(delta, y_range / this.length), done, source);
  }

  /**
   * Shows a damper.
   * @param {{ f: number, delta: number, tolerance: number | null, admissible: boolean }} damper
   */
  show({ f, delta, tolerance, admissible }) {
    this.f = f;
    this.delta = delta;
    if (!this.frame || !this.handle || !this.box || !this.cross || !this.layer) return;
    const { left, top, width, height, across, up } = this.frame;
    const [x, y] = this.shown();
    this.handle.setAttribute("transform", `translate(${x} ${y})`);
    this.handle.setAttribute("aria-valuenow", String(f));
    this.handle.setAttribute(
      "aria-valuetext",
      `f ${digits(f)}, Δ ${digits(delta)}, ${admissible ? "admissible" : "not admissible"}`,
    );
    this.cross.setAttribute("d", `M${x - left} 0V${height}M0 ${y - top}H${width}`);
    const size = tolerance ?? 0;
    const low = up(delta * (1 - size) * this.length);
    const high = up(delta * (1 + size) * this.length);
    const [from, to] = [across(f * (1 - size)), across(f * (1 + size))];
    for (const [name, value] of Object.entries({
      x: from,
      y: high,
      width: to - from,
      height: low - high,
    })) {
      this.box.setAttribute(name, String(Math.max(name === "x" || name === "y" ? -1e5 : 0, value)));
    }
    this.layer.classList.toggle("broken", !admissible);
    for (const { pin, at } of this.names) {
      pin.classList.toggle(
        "covered",
        Math.abs(at[0] - x + left) < 60 && Math.abs(at[1] - y + top) < 24,
      );
    }
    this.light(admissible ? null : new DOMPoint(x - left, y - top));
  }

  /** Lights up the forbidden side that holds the damper. @param {DOMPoint | null} point */
  light(point) {
    for (const side of this.place.querySelectorAll(".plot .hatched, .plot .area:not(.sky)")) {
      const lit = point !== null && /** @type {SVGGeometryElement} */ (side).isPointInFill(point);
      side.classList.toggle("lit", lit);
    }
  }
}
