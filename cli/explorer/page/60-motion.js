// SPDX-License-Identifier: MIT
// The mass on its spring, beside x over time; the mass and the curve have the same axis.
"use strict";

/**
 * @typedef {object} DrawnMotion
 * @property {Motion} motion dimensionless
 * @property {Motion} free the same without friction
 * @property {number} limit
 * @property {number} p
 * @property {number} zeta of the damping
 * @property {number} width of the notch
 * @property {number} f
 * @property {PlotUnits} units
 * @property {(() => Figure | undefined) | null} load a figure of what is transmitted under a pulse, whose energy is not there at once
 */

const seconds_of_play = 3; // where time has no unit
const shown_after_rest = 1.12; // of the time to the rest

/** How much of a motion is shown: a little more than until it rests. @param {Motion} motion @param {number} p */
function shown_time({ t, v }, p) {
  const last = t.length - 1;
  return (t[last] || (2 * Math.PI) / p) * (v[last] === 0 ? shown_after_rest : 1);
}

/** In the units that are shown. @param {DrawnMotion} drawn @returns {Series} */
function series_of({ motion, limit, p, units }) {
  return {
    t: Float64Array.from(motion.t, (t) => t * units.time),
    x: Float64Array.from(motion.x, (x) => x * units.length),
    v: Float64Array.from(motion.v, (v) => v * units.velocity),
    most: shown_time(motion, p) * units.time,
    limit: limit * units.length,
  };
}

/** Room for the motion, the limit and, if it is not too far, the motion without friction. @param {Series} series @param {number} ghost */
function displacement_axis({ x, limit }, ghost) {
  const peak = Math.max(
    limit,
    x.reduce((most, now) => Math.max(most, Math.abs(now)), 0),
  );
  const top = 1.12 * Math.max(peak, Math.min(ghost, 1.35 * peak));
  const lowest = x.reduce((least, now) => Math.min(least, now), 0);
  const bottom =
    lowest < -0.3 * top
      ? Math.min(1.12 * lowest, lowest < -0.7 * limit ? -1.12 * limit : 0)
      : -0.34 * top;
  return { least: bottom, most: top };
}

/**
 * The bench to the left of the plot.
 * @param {Plot} plot
 * @param {number} limit
 * @param {number} width of the notch
 * @returns {(mass: number, ghost: number) => void} moves the mass and the one without friction
 */
function draw_bench(plot, limit, width) {
  const zero = plot.up(0);
  const rail = 104;
  // The rail with the notch at x = 0: as wide as it is, or a mark where it has no width.
  const half = Math.max(4, (zero - plot.up(width)) / 2);
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
  for (const at of [limit, -limit]) {
    bench.append(svg("path", { class: "limit", d: `M14 ${plot.up(at)}H${rail + 12}` }));
  }
  const spring = svg("path", { class: "spring" });
  const ghost = svg("rect", { class: "ghost", x: 28, width: 68, height: 34, rx: 3 });
  const mass = svg(
    "g",
    {},
    svg("rect", { class: "mass", x: 28, y: -17, width: 68, height: 34, rx: 3 }),
    svg("path", { class: "mass", d: "M96-5l11 5l-11 5z" }),
    svg("path", { class: "mass-mark", d: "M36 0h52" }),
  );
  bench.append(spring, ghost, mass);
  plot.node.append(bench);
  const [foot, turns] = [plot.height - 1, 9];
  return (x, x_ghost) => {
    const up = plot.up(x);
    mass.setAttribute("transform", `translate(0 ${up})`);
    ghost.setAttribute("y", String(plot.up(x_ghost) - 17));
    let path = `M62 ${foot}`;
    for (let i = 0; i < turns; i++) {
      path += `L${i % 2 ? 50 : 74} ${foot + ((up + 17 - foot) * (i + 0.5)) / turns}`;
    }
    spring.setAttribute("d", `${path}L62 ${up + 17}`);
  };
}

/** The last of the instants up to this time. @param {Float64Array} t @param {number} time */
function instant(t, time) {
  let low = 0;
  let high = t.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (t[middle] <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** Between two instants. @param {Float64Array} list @param {Float64Array} t @param {number} time */
function between(list, t, time) {
  const i = instant(t, time);
  if (i + 1 >= t.length) return list[t.length - 1];
  const gap = t[i + 1] - t[i];
  return gap > 0 ? list[i] + ((time - t[i]) / gap) * (list[i + 1] - list[i]) : list[i + 1];
}

/**
 * @param {DrawnMotion} drawn
 * @param {Series} series
 * @returns {(time: number) => void} moves the mass and the mark on the curve
 */
function draw_motion({ free, units, width }, series) {
  const { t, x, most, limit } = series;
  const free_t = free.t.map((tau) => tau * units.time);
  const free_x = free.x.map((of) => of * units.length);
  const ghost = (/** @type {number} */ time) => between(free_x, free_t, time);
  const ghost_peak = Math.max(...free_x);
  const plot = new Plot(
    { least: 0, most, label: units.time_label },
    { ...displacement_axis(series, ghost_peak), label: units.length_label },
    {
      ...{ width: 450, height: 350, left: 172, bottom: 42 },
      name: "The mass on its spring and its displacement over time, with the limit and the motion without friction.",
    },
  );
  const end = plot.across(most);
  plot.add("limit", `M0 ${plot.up(limit)}H${end}M0 ${plot.up(-limit)}H${end}`);
  const steps = 160;
  const times = Array.from({ length: steps + 1 }, (_, i) => (i / steps) * most);
  plot.add("ghost-curve", plot.line(times, times.map(ghost)));
  const points = plot.points(t, x);
  plot.add("future", `M${points.join("L")}H${end}`);
  const past = plot.add("past", "");
  const now = svg("circle", { class: "now", r: 5 });
  plot.inner.append(now);
  const move_bench = draw_bench(plot, limit, width * units.length);
  el("motion").replaceChildren(plot.node);
  return (time) => {
    const here = between(x, t, time);
    const [across, up] = [plot.across(time), plot.up(here)];
    past.setAttribute("d", `M${points.slice(0, instant(t, time) + 1).join("L")}L${across} ${up}`);
    now.setAttribute("transform", `translate(${across} ${up})`);
    move_bench(here, ghost(time));
  };
}

class MotionView {
  constructor() {
    this.playing = false;
    this.at = 1; // of the time that is drawn
    this.from = 0;
    /** @type {{ drawn: DrawnMotion, series: Series, marks: ((time: number) => void)[] } | null} */
    this.shown = null;
    const slider = input("time");
    slider.addEventListener("input", () => {
      this.stop();
      this.seek(Number(slider.value) / 1000);
    });
    el("play").addEventListener("click", () => (this.playing ? this.stop() : this.play()));
  }

  /** @param {DrawnMotion} drawn */
  draw(drawn) {
    const series = series_of(drawn);
    this.shown = { drawn, series, marks: [draw_motion(drawn, series)] };
    el("motion-caption").hidden = false;
    this.seek(this.at);
  }

  /** Of the motion that was drawn last. */
  draw_portraits() {
    if (!this.shown) return;
    const { drawn, series, marks } = this.shown;
    const { t, x, v } = series;
    const to_state = draw_phase(series, drawn.units);
    const to_time = drawn.load
      ? draw_load(drawn.load)
      : draw_energy(series, drawn.motion, drawn, drawn.units);
    marks.push((time) => to_state(between(x, t, time), between(v, t, time)), to_time);
    this.seek(this.at);
  }

  /** Shows an instant. @param {number} at from 0 to 1 */
  seek(at) {
    this.at = at;
    if (!this.shown) return;
    const { drawn, series, marks } = this.shown;
    const time = at * series.most;
    for (const move of marks) move(time);
    const slider = input("time");
    write(slider, String(Math.round(at * 1000)));
    slider.setAttribute("aria-valuetext", words(time, drawn.units.time_unit, 4));
    show(el("clock"), time, drawn.units.time_unit);
  }

  /** Nothing, and why. @param {Part[]} why */
  draw_nothing(...why) {
    this.stop();
    this.shown = null;
    fill(el("motion"), ...why);
    el("motion-caption").hidden = true;
    clear("phase", "energy");
  }

  play() {
    if (!this.shown) return;
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
    if (!this.playing || !this.shown) return;
    const { drawn, series } = this.shown;
    const passed = this.from ? (now - this.from) / 1000 : 0;
    this.from = now;
    const whole = drawn.units.time_unit ? series.most : seconds_of_play;
    const at = Math.min(1, this.at + passed / whole);
    this.seek(at);
    if (at >= 1) this.stop();
    else requestAnimationFrame((next) => this.step(next));
  }
}
