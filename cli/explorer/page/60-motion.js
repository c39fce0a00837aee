// SPDX-License-Identifier: MIT
// The mass on its spring, beside x over time; the mass and the curve have the same axis.
"use strict";

/**
 * @typedef {object} DrawnMotion
 * @property {Motion} motion dimensionless
 * @property {number} limit
 * @property {number} p
 * @property {number} width of the notch
 * @property {number} f
 * @property {PlotUnits} units
 */

const seconds_of_play = 3; // where time has no unit
const shown_after_rest = 1.12; // of the time to the rest

class MotionView {
  constructor() {
    this.playing = false;
    this.at = 1; // of the time that is drawn
    this.from = 0;
    /** @type {DrawnMotion | null} */
    this.drawn = null;
    /** @type {((x: number, v: number) => void) | null} */
    this.to_state = null;
    /** @type {((time: number) => void) | null} */
    this.to_time = null;
    const slider = input("time");
    slider.addEventListener("input", () => {
      this.stop();
      this.seek(Number(slider.value) / 1000);
    });
    el("play").addEventListener("click", () => (this.playing ? this.stop() : this.play()));
  }

  /** @param {DrawnMotion} drawn */
  draw(drawn) {
    this.drawn = drawn;
    const { motion, units, p } = drawn;
    const last = motion.t.length - 1;
    const end = motion.t[last] || (2 * Math.PI) / p;
    const rests = motion.v[last] === 0;
    this.most = end * (rests ? shown_after_rest : 1) * units.time;
    this.t = Float64Array.from(motion.t, (t) => t * units.time);
    this.x = Float64Array.from(motion.x, (x) => x * units.length);
    this.v = Float64Array.from(motion.v, (v) => v * units.velocity);
    this.limit = drawn.limit * units.length;
    const peak = this.x.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
    const ghost = ((this.v[0] / units.velocity) * units.length) / p;
    const top =
      1.12 * Math.max(this.limit, peak, Math.min(ghost, 1.35 * Math.max(this.limit, peak)));
    const lowest = this.x.reduce((least, x) => Math.min(least, x), 0);
    const bottom =
      lowest < -0.3 * top
        ? Math.min(1.12 * lowest, lowest < -0.7 * this.limit ? -1.12 * this.limit : 0)
        : -0.34 * top;
    const plot = new Plot(
      { least: 0, most: this.most, label: units.time_label },
      { least: bottom, most: top, label: units.length_label },
      { width: 450, height: 350, left: 172, bottom: 42, name: this.words() },
    );
    this.plot = plot;
    this.draw_limits(plot);
    this.draw_curves(plot);
    this.draw_bench(plot);
    el("motion").replaceChildren(plot.node);
    this.to_state = this.to_time = null;
    this.seek(this.at);
  }

  /** Of the motion that was drawn last. */
  draw_portraits() {
    const { drawn, t, x, v, most = 0, limit = 0 } = this;
    if (!drawn || !t || !x || !v) return;
    const series = { t, x, v, most, limit };
    this.to_state = draw_phase(series, drawn.units);
    this.to_time = draw_energy(series, drawn.motion, drawn, drawn.units);
    this.seek(this.at);
  }

  words() {
    return "The mass on its spring and its displacement over time, with the limit and the motion without friction.";
  }

  /** @param {Plot} plot */
  draw_limits(plot) {
    let path = "";
    const { most = 0, limit = 0 } = this;
    for (const at of [limit, -limit]) path += `M0 ${plot.up(at)}H${plot.across(most)}`;
    plot.add("limit", path);
  }

  /** @param {Plot} plot */
  draw_curves(plot) {
    const {
      t = new Float64Array(),
      x = new Float64Array(),
      v = new Float64Array(),
      most = 0,
    } = this;
    const { p, units } = /** @type {DrawnMotion} */ (this.drawn);
    // Without friction a hit gives V0/p sin(p tau).
    const steps = 160;
    const times = Array.from({ length: steps + 1 }, (_, i) => (i / steps) * most);
    const amplitude = (v[0] / units.velocity / p) * units.length;
    this.ghost = (/** @type {number} */ time) => amplitude * Math.sin((p * time) / units.time);
    plot.add("ghost-curve", plot.line(times, times.map(this.ghost)));
    plot.add("future", plot.line(t, x) + `H${plot.across(most)}`);
    this.past = plot.add("past", "");
    this.now = svg("circle", { class: "now", r: 5 });
    plot.inner.append(this.now);
  }

  /** The bench to the left of the plot. @param {Plot} plot */
  draw_bench(plot) {
    const { width } = /** @type {DrawnMotion} */ (this.drawn);
    const { length } = /** @type {DrawnMotion} */ (this.drawn).units;
    const zero = plot.up(0);
    const rail = 104;
    // The rail with the notch at x = 0: as wide as it is, or a mark where it has no width.
    const half = Math.max(4, (plot.up(0) - plot.up(width * length)) / 2);
    const bench = svg("svg", {
      x: 0,
      y: plot.top,
      width: plot.left - 54,
      height: plot.height,
      viewBox: `0 0 ${plot.left - 54} ${plot.height}`,
    });
    bench.append(
      svg("path", {
        class: "bench-line",
        d: `M${rail} 0V${zero - half}l9 ${half}l-9 ${half}V${plot.height}M34 ${plot.height - 1}h56`,
      }),
    );
    for (const at of [this.limit ?? 0, -(this.limit ?? 0)]) {
      bench.append(svg("path", { class: "limit", d: `M14 ${plot.up(at)}H${rail + 12}` }));
    }
    this.spring = svg("path", { class: "spring" });
    this.ghost_mass = svg("rect", { class: "ghost", x: 28, width: 68, height: 34, rx: 3 });
    this.mass = svg(
      "g",
      {},
      svg("rect", { class: "mass", x: 28, y: -17, width: 68, height: 34, rx: 3 }),
      svg("path", { class: "mass", d: "M96-5l11 5l-11 5z" }),
      svg("path", { class: "mass-mark", d: "M36 0h52" }),
    );
    bench.append(this.spring, this.ghost_mass, this.mass);
    plot.node.append(bench);
  }

  time_now() {
    return this.at * (this.most ?? 0);
  }

  /** @param {Float64Array} list */
  between(list) {
    const { t } = this;
    if (!t) return 0;
    const time = this.time_now();
    let i = this.index();
    if (i + 1 >= t.length) return list[t.length - 1];
    const gap = t[i + 1] - t[i];
    return gap > 0 ? list[i] + ((time - t[i]) / gap) * (list[i + 1] - list[i]) : list[i + 1];
  }

  /** The last of the instants up to now. */
  index() {
    const t = /** @type {Float64Array} */ (this.t);
    const time = this.time_now();
    let low = 0;
    let high = t.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (t[middle] <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  x_now() {
    return this.x ? this.between(this.x) : 0;
  }

  v_now() {
    return this.v ? this.between(this.v) : 0;
  }

  /** Shows an instant. @param {number} at from 0 to 1 */
  seek(at) {
    this.at = at;
    const { plot, t, x, past, now, mass, spring, ghost_mass, ghost, drawn } = this;
    if (!plot || !t || !x || !past || !now || !mass || !spring || !ghost_mass || !ghost || !drawn)
      return;
    const time = this.time_now();
    const here = this.x_now();
    const [across, up] = [plot.across(time), plot.up(here)];
    past.setAttribute("d", `${plot.line(t, x, this.index() + 1)}L${across} ${up}`);
    now.setAttribute("transform", `translate(${across} ${up})`);
    mass.setAttribute("transform", `translate(0 ${up})`);
    ghost_mass.setAttribute("y", String(plot.up(ghost(time)) - 17));
    const [foot, turns] = [plot.height - 1, 9];
    let path = `M62 ${foot}`;
    for (let i = 0; i < turns; i++) {
      path += `L${i % 2 ? 50 : 74} ${foot + ((up + 17 - foot) * (i + 0.5)) / turns}`;
    }
    spring.setAttribute("d", `${path}L62 ${up + 17}`);
    this.to_state?.(here, this.v_now());
    this.to_time?.(time);
    const slider = input("time");
    write(slider, String(Math.round(at * 1000)));
    slider.setAttribute("aria-valuetext", words(time, drawn.units.time_unit, 4));
    show(el("clock"), time, drawn.units.time_unit);
    el("clock").dataset.value = String(time);
  }

  /** Nothing, and why. @param {Part[]} why */
  draw_nothing(...why) {
    this.stop();
    this.drawn = null;
    fill(el("motion"), ...why);
    for (const id of ["phase", "energy"]) el(id).replaceChildren();
  }

  play() {
    if (!this.drawn) return;
    this.playing = true;
    el("play").textContent = "Pause";
    if (this.at >= 1) this.at = 0;
    this.from = 0;
    requestAnimationFrame((now) => this.step(now));
  }

  stop() {
    this.playing = false;
    el("play").textContent = "Play";
  }

  /** In real seconds; without units, the whole motion in a few seconds. @param {number} now */
  step(now) {
    if (!this.playing || !this.drawn) return;
    const passed = this.from ? (now - this.from) / 1000 : 0;
    this.from = now;
    const whole = this.drawn.units.time_unit ? (this.most ?? 1) : seconds_of_play;
    const at = Math.min(1, this.at + passed / whole);
    this.seek(at);
    if (at >= 1) this.stop();
    else requestAnimationFrame((next) => this.step(next));
  }
}
