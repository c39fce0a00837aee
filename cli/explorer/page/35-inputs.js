// SPDX-License-Identifier: MIT
// The inputs of the task: what each slider writes, and where it stands.
"use strict";

/**
 * @typedef {object} Field
 * @property {string} name the option that the slider writes
 * @property {string} label
 * @property {number} least
 * @property {number} most
 * @property {boolean} [log]
 * @property {boolean} [two] a range
 * @property {boolean} [absent_at_least] the slider at its lower end removes the option
 * @property {boolean} [stroke] below some value designs end
 * @property {string} unit what the slider writes behind the number
 * @property {(report: any) => Array<number | null | undefined>} read its value, or both ends
 */

/**
 * @param {string} name @param {string} label @param {number[]} range @param {string} unit
 * @param {(report: any) => Array<number | null | undefined>} read
 * @param {Partial<Field>} more
 * @returns {Field}
 */
function field(name, label, [least, most], unit, read, more = {}) {
  return { name, label, least, most, unit, read, ...more };
}

const log = { log: true };
const stroke = { log: true, stroke: true };
const two = { two: true };
const absent = { absent_at_least: true };
const arrivals = field("arrivals", "returns allowed", [1, 6], "", (of) => [of.input.arrivals]);

/** In per cent, as it is given; no report of the undamped mass returns it. */
const damping = field("damping", "damping", [0, 30], "%", () => [], absent);

const physical_fields = [
  field("period", "natural period", [0.1, 10], "s", (of) => [of.physical?.period_s], log),
  field("mass", "mass", [1, 1e7], "kg", (of) => [of.physical?.mass_kg], log),
  field("velocity", "hit velocity", [0, 2], "m/s", velocities_of, two),
  field("max-displacement", "stroke limit", [0.001, 1], "m", (of) => [limit_of(of)], stroke),
  arrivals,
  field("residual-m", "residual allowed", [0, 0.1], "m", (of) => [residual_of(of)], absent),
  damping,
];

const dimensionless_fields = [
  field("p", "square root of the stiffness p", [0.05, 20], "", (of) => [of.input.p], log),
  field("v0", "velocity of the hit V₀", [0, 5], "", velocities_of, two),
  field("beta", "stroke limit β", [0.01, 10], "", (of) => [limit_of(of)], stroke),
  arrivals,
  field("residual", "residual allowed", [0, 1], "", (of) => [residual_of(of)], absent),
  damping,
];

/** The kinds of notch, each with its own slider. @type {Record<string, (physical: boolean) => Field | null>} */
const notch_fields = {
  "ideal, at x = 0": () => null,
  "with a width": (physical) =>
    physical
      ? field("notch-width-m", "width of the notch", [0, 0.1], "m", () => [])
      : field("notch-width", "width of the notch", [0, 0.5], "", () => []),
  "that lets go": () => field("hold", "hold of the notch", [0, 0.5], "g", () => []),
};
const notch_options = [...rivals("hold"), "hold"];
const unreturned = [...notch_options, damping.name]; // by the report of the task
const slider_steps = 1000;

/** @param {Field} field @param {number} at of the slider, from 0 to 1 */
function slider_value({ least, most, log }, at) {
  return log ? least * (most / least) ** at : least + at * (most - least);
}

/** @param {Field} field @param {number} value */
function slider_place({ least, most, log }, value) {
  const at = log
    ? Math.log(value / least) / Math.log(most / least)
    : (value - least) / (most - least);
  return Math.min(1, Math.max(0, at));
}

/** The number that a slider writes: short, and in the usual unit. @param {Field} field @param {number} value */
function slider_text(field, value) {
  if (field.name === "arrivals") return String(Math.round(value));
  const short = (/** @type {number} */ x) => String(Number(x.toPrecision(3)));
  if (field.unit === "m") return `${short(value * 1000)}mm`;
  if (field.unit === "kg" && value >= 1000) return `${short(value / 1000)}t`;
  return short(value) + field.unit;
}
