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
const duration_of = (/** @type {any} */ { physical }) => [physical?.excitation_duration_s];
const absent = { absent_at_least: true };
const arrivals = field("arrivals", "returns allowed", [1, 6], "", (of) => [of.input.arrivals]);

/** In per cent, as it is given; no report of the undamped mass returns it. */
const damping = field("damping", "damping", [0, 30], "%", () => [], absent);

/** What gives the load, and how strong it is. @type {Record<string, (physical: boolean) => Field[]>} */
const load_fields = {
  hit: (physical) => [
    physical
      ? field("velocity", "hit velocity", [0, 2], "m/s", strengths_of, two)
      : field("v0", "velocity of the hit V₀", [0, 5], "", strengths_of, two),
  ],
  pulse: (physical) => [
    field("k", "pulse peak", [0.05, 100], "g", strengths_of, { two: true, log: true }),
    physical
      ? field("pulse-duration", "pulse duration", [0.001, 10], "s", duration_of, log)
      : field("lambda", "angular frequency λ", [0.1, 1000], "", (of) => [of.input.lambda], log),
  ],
  record: () => [],
};
const pulse_kinds = option_rows.find(({ name }) => name === "pulse")?.values ?? [];
const records_kind = "records";
/** The standard shock's length, and in natural periods the most. */
const [shock_s, shock_periods] = [0.005, 0.02];

/** The load of a kind, as strong as the one of the report. @param {string} kind @param {any} report @returns {Options} */
function load_like(kind, { input, physical }) {
  const short = (/** @type {number} */ value) => String(Number(value.toPrecision(3)));
  const v0 = input.v0 ?? 0.9 * input.p * input.beta;
  const velocity = v0 * (physical?.velocity_unit_m_per_s ?? 1);
  if (!pulse_kinds.includes(kind)) {
    return physical ? { velocity: `${short(velocity)}m/s` } : { v0: short(v0) };
  }
  // A half-sine of peak k changes the velocity by 2 k duration/pi.
  if (!physical) {
    const lambda = (0.5 * input.p) / shock_periods;
    return { pulse: kind, k: short((v0 * lambda) / 2), lambda: short(lambda) };
  }
  const duration = Math.min(shock_s, shock_periods * physical.period_s);
  const k = (velocity * Math.PI) / 2 / duration / physical.gravity_m_per_s2;
  return { pulse: kind, k: `${short(k)}g`, "pulse-duration": `${short(1000 * duration)}ms` };
}

/** What may be required besides the stroke, without a slider: of each line the one in the units of the task. */
const requirements = [
  ["tolerance-f"],
  ["tolerance-delta"],
  ["tolerance-period"],
  ["tolerance-width"],
  ["acceleration-max"],
  ["f-max"],
  ["delta-max-m", "delta-max"],
  ["jump-max", "jump-max-v"],
  ["objective"],
  ["combine"],
].map(([first, other]) => [first, other ?? first]);

/** The requirements that this task can have. @param {Options} options */
function requirements_of(options) {
  const under_records = load_of(options) === "record";
  const has_width = ["notch-width", "notch-width-m"].some((name) => name in options);
  return requirements
    .map(([first, other]) => (is_physical(options) ? first : other))
    .filter((name) => name !== "tolerance-width" || (under_records && has_width))
    .filter((name) => name !== "combine" || under_records)
    .map((name) => option_rows.find((row) => row.name === name))
    .flatMap((row) => row ?? []);
}

const physical_fields = [
  field("period", "natural period", [0.1, 10], "s", (of) => [of.physical?.period_s], log),
  field("mass", "mass", [1, 1e7], "kg", (of) => [of.physical?.mass_kg], log),
  field("max-displacement", "stroke limit", [0.001, 1], "m", (of) => [limit_of(of)], stroke),
  arrivals,
  field("residual-m", "residual allowed", [0, 0.1], "m", (of) => [residual_of(of)], absent),
  damping,
];

const dimensionless_fields = [
  field("p", "square root of the stiffness p", [0.05, 20], "", (of) => [of.input.p], log),
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
  if (field.unit === "s" && value < 0.1) return `${short(value * 1000)}ms`;
  return short(value) + field.unit;
}
