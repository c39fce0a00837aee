// SPDX-License-Identifier: MIT
// Dampers as they are built: f and Delta within a tolerance, hits within their range.
"use strict";

const dampers = 500;
const looks = ["held", "centred", "off_centre", "too_far"];

/**
 * The i-th of Halton's points: evenly spread, without gaps, and the same each time.
 * @param {number} i
 * @param {number} base
 */
function spread_place(i, base) {
  let place = 0;
  let part = 1;
  for (let rest = i + 1; rest > 0; rest = Math.floor(rest / base)) {
    part /= base;
    place += part * (rest % base);
  }
  return place;
}

/**
 * @param {Engine} engine
 * @param {any} report
 * @param {{ f: number, delta: number }} damper
 * @param {Options} motion the options of one motion, dimensionless
 */
function draw_cloud(engine, report, damper, motion) {
  const off = Number(input("spread").value) / 100;
  show(el("spread-value"), off, "%", "±");
  const f = new Float64Array(dampers);
  const delta = new Float64Array(dampers);
  const v0 = new Float64Array(dampers);
  const [low, high] = ends(report);
  for (let i = 0; i < dampers; i++) {
    f[i] = damper.f * (1 + off * (2 * spread_place(i, 2) - 1));
    delta[i] = damper.delta * (1 + off * (2 * spread_place(i, 3) - 1));
    v0[i] = low + (high - low) * spread_place(i, 5);
  }
  const result = engine.batch(without(motion, ["v0", "f", "delta"]), f, delta, v0);
  if ("error" in result) {
    el("cloud").replaceChildren();
    el("cloud-words").textContent = result.error;
    return;
  }
  const { beta, residual } = report.input;
  const plot = new Plot(
    { least: -100 * off, most: 100 * off, label: "f, off by %" },
    { least: -100 * off, most: 100 * off, label: "Δ, off by %" },
    {
      width: 450,
      height: 330,
      left: 56,
      bottom: 42,
      name: "Dampers within the tolerance, by how each ends",
    },
  );
  const paths = looks.map(() => "");
  const counts = looks.map(() => 0);
  for (let i = 0; i < dampers; i++) {
    const kind = ending(result, i, engine.outcomes, beta, residual ?? 0);
    counts[kind]++;
    const x = plot.across(100 * (f[i] / damper.f - 1) || 0);
    const y = plot.up(100 * (delta[i] / damper.delta - 1) || 0);
    paths[kind] += `M${x.toFixed(1)} ${y.toFixed(1)}h0`;
  }
  looks.forEach((look, kind) => plot.add(`dots ink-${look}`, paths[kind]));
  el("cloud").replaceChildren(plot.node);
  const keys = looks.flatMap((look, kind) =>
    counts[kind] ? [key(look, `${ends_words[look]} `, number(counts[kind]))] : [],
  );
  fill(el("cloud-words"), ...keys);
}

/**
 * How one ends, as an index of looks.
 * @param {Batch} batch @param {number} i @param {string[]} outcomes @param {number} beta @param {number} residual
 */
function ending({ peak, rest, outcome }, i, outcomes, beta, residual) {
  const name = outcomes[outcome[i]];
  if (name === "caught_at_start") return 0;
  if (!(peak[i] <= beta * (1 + 1e-12))) return 3;
  if (name === "never_stops" || name === "running") return 2;
  if (name === "stopped_in_notch") return 1;
  return Math.abs(rest[i]) <= residual ? 1 : 2;
}
