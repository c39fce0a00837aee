// SPDX-License-Identifier: MIT
// The plots that move. Those that stand still are drawn by the engine; these look like them.
"use strict";

/** @typedef {{ least: number, most: number, label: string }} Axis */

/** @param {Axis} axis @param {number} count about this many */
function ticks(axis, count) {
  const rough = (axis.most - axis.least) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * (rough / power > 5 ? 10 : rough / power > 2 ? 5 : rough / power > 1 ? 2 : 1);
  const list = [];
  for (let i = Math.ceil(axis.least / step); i * step <= axis.most; i++) list.push(i * step);
  return list;
}

class Plot {
  /**
   * @param {Axis} x
   * @param {Axis} y
   * @param {{ width: number, height: number, left: number, bottom: number, name: string, title?: string }} frame
   */
  constructor(x, y, frame) {
    this.x = x;
    this.y = y;
    this.left = frame.left;
    this.top = frame.title ? 28 : 10;
    this.width = frame.width - frame.left - 10;
    this.height = frame.height - frame.bottom - this.top;
    this.node = svg("svg", {
      class: "figure",
      viewBox: `0 0 ${frame.width} ${frame.height}`,
      role: "img",
      "aria-label": frame.name,
    });
    if (frame.title)
      this.node.append(svg("text", { class: "title", x: this.left, y: 18 }, frame.title));
    this.grid(frame);
    this.inner = svg("svg", {
      x: this.left,
      y: this.top,
      width: this.width,
      height: this.height,
      viewBox: `0 0 ${this.width} ${this.height}`,
    });
    this.node.append(
      this.inner,
      svg("rect", {
        class: "frame",
        x: this.left,
        y: this.top,
        width: this.width,
        height: this.height,
      }),
    );
  }

  /** @param {{ width: number, height: number }} frame */
  grid(frame) {
    const base = this.top + this.height;
    let lines = "";
    for (const value of ticks(this.x, this.width / 60)) {
      const at = this.left + this.across(value);
      lines += `M${at} ${this.top}v${this.height}`;
      const label = digits(value);
      const half = 4 * label.length; // of its width; the last one stays in the frame
      const x = Math.min(at, frame.width - half);
      this.node.append(svg("text", { x, y: base + 17, "text-anchor": "middle" }, label));
    }
    for (const value of ticks(this.y, this.height / 45)) {
      const at = this.top + this.up(value);
      lines += `M${this.left} ${at}h${this.width}`;
      this.node.append(
        svg("text", { x: this.left - 6, y: at + 4, "text-anchor": "end" }, digits(value)),
      );
    }
    this.node.prepend(svg("path", { class: "grid", d: lines }));
    const middle = this.top + this.height / 2;
    this.node.append(
      svg(
        "text",
        { x: this.left + this.width / 2, y: frame.height - 4, "text-anchor": "middle" },
        this.x.label,
      ),
      svg(
        "text",
        { transform: `translate(13 ${middle}) rotate(-90)`, "text-anchor": "middle" },
        this.y.label,
      ),
    );
  }

  /** @param {number} value */
  across(value) {
    return ((value - this.x.least) / (this.x.most - this.x.least)) * this.width;
  }

  /** @param {number} value */
  up(value) {
    return (1 - (value - this.y.least) / (this.y.most - this.y.least)) * this.height;
  }

  /** As a path writes them. @param {ArrayLike<number>} xs @param {ArrayLike<number>} ys */
  points(xs, ys) {
    return Array.from(xs, (x, i) => `${this.across(x).toFixed(2)} ${this.up(ys[i]).toFixed(2)}`);
  }

  /** @param {ArrayLike<number>} xs @param {ArrayLike<number>} ys */
  line(xs, ys) {
    return `M${this.points(xs, ys).join("L")}`;
  }

  /** @param {string} look @param {string} path */
  add(look, path) {
    const node = svg("path", { class: look, d: path });
    this.inner.append(node);
    return node;
  }
}

/**
 * Puts a figure of the engine on the page.
 * @param {HTMLElement} place
 * @param {Figure | undefined} figure
 * @returns {SVGSVGElement | null}
 */
function put_figure(place, figure) {
  place.innerHTML = figure?.svg ?? "";
  return place.querySelector("svg");
}

/**
 * The axes and the plot of a figure of the engine.
 * @param {SVGElement} node
 */
function frame_of(node) {
  /** @param {string} name */
  const numbers = (name) => (node.dataset[name] ?? "").split(" ").map(Number);
  const [left, top, width, height] = numbers("plot");
  const [x_least, x_most] = numbers("x");
  const [y_least, y_most] = numbers("y");
  return {
    left,
    top,
    width,
    height,
    /** @param {number} value */
    across: (value) => ((value - x_least) / (x_most - x_least)) * width,
    /** @param {number} value */
    up: (value) => (1 - (value - y_least) / (y_most - y_least)) * height,
    /** @param {number} at */
    x_at: (at) => x_least + (at / width) * (x_most - x_least),
    /** @param {number} at */
    y_at: (at) => y_least + (1 - at / height) * (y_most - y_least),
    x_range: x_most - x_least,
    y_range: y_most - y_least,
  };
}

/**
 * The units of the figures that the engine draws: metres instead of millimetres where H is large.
 * @param {any} physical of a report
 */
function plot_units(physical) {
  if (!physical) {
    return {
      ...{ length: 1, time: 1, velocity: 1, energy: 1, energy_si: 1 },
      ...{ time_unit: "", energy_unit: "" },
      length_label: "displacement x",
      time_label: "time τ",
      velocity_label: "velocity x′",
      energy_label: "energy",
    };
  }
  const { length_unit_m, time_unit_s, velocity_unit_m_per_s, mass_kg } = physical;
  const large = length_unit_m > 10;
  const energy_si = velocity_unit_m_per_s ** 2 * (mass_kg ?? 1);
  return {
    length: length_unit_m * (large ? 1 : 1000),
    time: time_unit_s,
    velocity: velocity_unit_m_per_s,
    energy: energy_si * (mass_kg ? 1e-3 : 1),
    energy_si,
    time_unit: "s",
    energy_unit: mass_kg ? "J" : "J/kg",
    length_label: `displacement x, ${large ? "m" : "mm"}`,
    time_label: "time, s",
    velocity_label: "velocity, m/s",
    energy_label: `energy, ${mass_kg ? "kJ" : "J/kg"}`,
  };
}
