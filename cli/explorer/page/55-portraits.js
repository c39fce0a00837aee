// SPDX-License-Identifier: MIT
// The phase portrait, and where the energy goes. Each returns what moves its mark.
"use strict";

/**
 * @typedef {object} Series of a motion in the units that are shown
 * @property {Float64Array} t
 * @property {Float64Array} x
 * @property {Float64Array} v
 * @property {number} most of the time
 * @property {number} limit
 */

/**
 * @typedef {object} PlotUnits what one dimensionless unit is in the units that are shown
 * @property {number} length
 * @property {number} time
 * @property {number} velocity
 * @property {number} energy
 * @property {string} length_label
 * @property {string} time_label
 * @property {string} time_unit
 * @property {string} velocity_label
 * @property {string} energy_label
 * @property {string} energy_unit
 * @property {number} energy_si in the SI unit
 */

const portrait = { width: 450, height: 330, left: 60, bottom: 42 };

/** A little more than the range. @param {number} least @param {number} most @param {string} label */
function wider(least, most, label) {
  const room = 0.06 * (most - least || 1);
  return { least: least - room, most: most + room, label };
}

/**
 * @param {Series} series
 * @param {PlotUnits} units
 * @returns {(x: number, v: number) => void}
 */
function draw_phase({ t, x, v, limit }, units) {
  const [least, most] = [Math.min(...x), Math.max(...x)];
  const plot = new Plot(
    wider(
      least < -0.6 * limit ? Math.min(least, -limit) : Math.min(least, 0),
      most > 0.6 * limit || least === most ? Math.max(most, limit) : most,
      units.length_label,
    ),
    wider(Math.min(...v), Math.max(...v), units.velocity_label),
    { ...portrait, title: "Phase portrait", name: "Velocity against displacement." },
  );
  const height = plot.height;
  plot.add("limit", `M${plot.across(limit)} 0V${height}M${plot.across(-limit)} 0V${height}`);
  let motion = "";
  let jumps = "";
  for (let i = 0; i < t.length; i++) {
    const at = `${plot.across(x[i]).toFixed(2)} ${plot.up(v[i]).toFixed(2)}`;
    // At x = 0 the notch takes its energy at once.
    const jump = i > 0 && t[i] === t[i - 1];
    if (jump) jumps += `M${plot.across(x[i - 1])} ${plot.up(v[i - 1])}L${at}`;
    motion += `${i === 0 || jump ? "M" : "L"}${at}`;
  }
  plot.add("past", motion);
  plot.add("jump", jumps);
  const dot = svg("circle", { class: "now", r: 5 });
  plot.inner.append(dot);
  el("phase").replaceChildren(plot.node);
  return (x_now, v_now) =>
    dot.setAttribute("transform", `translate(${plot.across(x_now)} ${plot.up(v_now)})`);
}

/**
 * @param {Series} series
 * @param {Motion} motion dimensionless
 * @param {{ p: number, f: number, zeta: number }} damper
 * @param {PlotUnits} units
 * @returns {(time: number) => void}
 */
function draw_energy({ t, most }, motion, { p, f, zeta }, units) {
  const count = t.length;
  const energy = (/** @type {number} */ i) => (motion.v[i] ** 2 + (p * motion.x[i]) ** 2) / 2;
  const all = energy(0);
  let way = 0;
  const left = new Float64Array(count + 1);
  const with_friction = new Float64Array(count + 1);
  for (let i = 0; i < count; i++) {
    // Turns are among the instants, so the way between two is the difference.
    if (i > 0) way += Math.abs(motion.x[i] - motion.x[i - 1]);
    left[i] = energy(i);
    with_friction[i] = Math.min(all, left[i] + f * way);
  }
  left[count] = left[count - 1];
  with_friction[count] = with_friction[count - 1];
  const times = Float64Array.from({ length: count + 1 }, (_, i) => (i < count ? t[i] : most));
  const scaled = (/** @type {Float64Array} */ list) => list.map((e) => e * units.energy);
  const plot = new Plot(
    { least: 0, most, label: units.time_label },
    { least: 0, most: 1.06 * all * units.energy || 1, label: units.energy_label },
    {
      ...portrait,
      title: "Where the energy goes",
      name: "Energy over time: what is left, and what friction and the notch have taken.",
    },
  );
  const width = plot.width;
  const nothing = [`0 ${plot.height}`, `${width} ${plot.height}`];
  const kept = plot.points(times, scaled(left));
  const not_by_notch = plot.points(times, scaled(with_friction));
  const top = plot.up(all * units.energy).toFixed(2);
  const everything = [`0 ${top}`, `${width} ${top}`];
  for (const [look, lower, upper] of /** @type {const} */ ([
    ["blue", nothing, kept],
    ["orange", kept, not_by_notch],
    ["green", not_by_notch, everything],
  ])) {
    plot.add(`area ${look}`, `M${[...lower, ...[...upper].reverse()].join("L")}Z`);
    plot.add(`curve ${look}`, `M${upper.join("L")}`);
  }
  const now = plot.add("now-line", `M0 0V${plot.height}`);
  // The way is a sum over the instants, so its last digits are wrong: anything below one part in 10^12 counts as 0.
  const by_notch = all - with_friction[count];
  const notch = by_notch > 1e-12 * all ? by_notch : 0;
  const took = all - left[count] - notch;
  const part = (/** @type {number} */ value) => number(value * units.energy_si, units.energy_unit);
  el("energy").replaceChildren(
    plot.node,
    make(
      "p",
      {},
      key("left", "kinetic and spring ", part(left[count])),
      key("friction", "constant friction ", part(took)),
      key("notch", zeta ? "notch and damping " : "notch ", part(notch)),
    ),
  );
  return (time) => now.setAttribute("transform", `translate(${plot.across(time)} 0)`);
}

/** Where a load feeds the motion: what is transmitted, as the engine draws it. @param {() => Figure | undefined} figure @returns {(time: number) => void} */
function draw_load(figure) {
  const drawn = figure();
  const node = put_figure(el("energy"), drawn);
  el("energy").append(make("p", { class: "faint" }, drawn?.caption ?? ""));
  const frame = node && frame_of(node);
  if (!node || !frame) return () => {};
  const { left, top, width, height, across } = frame;
  const mark = svg("path", { class: "now-line", d: `M0 0V${height}` });
  node.append(svg("svg", { x: left, y: top, width, height }, mark));
  return (time) => mark.setAttribute("transform", `translate(${across(time)} 0)`);
}
