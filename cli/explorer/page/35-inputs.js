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

/** @type {Field} */
const arrivals = {
  name: "arrivals",
  label: "returns allowed",
  least: 1,
  most: 6,
  unit: "",
  read: (report) => [report.input.arrivals],
};

/** @type {Field[]} */
const physical_fields = [
  {
    name: "period",
    label: "natural period",
    least: 0.1,
    most: 10,
    log: true,
    unit: "s",
    read: (report) => [report.physical?.period_s],
  },
  {
    name: "mass",
    label: "mass",
    least: 1,
    most: 1e7,
    log: true,
    unit: "kg",
    read: (report) => [report.physical?.mass_kg],
  },
  {
    name: "velocity",
    label: "hit velocity",
    least: 0,
    most: 2,
    two: true,
    unit: "m/s",
    read: (report) => ends(report, report.physical?.velocity_unit_m_per_s),
  },
  {
    name: "max-displacement",
    label: "stroke limit",
    least: 0.001,
    most: 1,
    log: true,
    unit: "m",
    stroke: true,
    read: (report) => [limit_of(report)],
  },
  arrivals,
  {
    name: "residual-m",
    label: "residual allowed",
    least: 0,
    most: 0.1,
    absent_at_least: true,
    unit: "m",
    read: (report) => [(report.input.residual ?? 0) * report.physical?.length_unit_m],
  },
];

/** @type {Field[]} */
const dimensionless_fields = [
  {
    name: "p",
    label: "square root of the stiffness p",
    least: 0.05,
    most: 20,
    log: true,
    unit: "",
    read: (report) => [report.input.p],
  },
  {
    name: "v0",
    label: "velocity of the hit V₀",
    least: 0,
    most: 5,
    two: true,
    unit: "",
    read: (report) => ends(report),
  },
  {
    name: "beta",
    label: "stroke limit β",
    least: 0.01,
    most: 10,
    log: true,
    unit: "",
    stroke: true,
    read: (report) => [report.input.beta],
  },
  arrivals,
  {
    name: "residual",
    label: "residual allowed",
    least: 0,
    most: 1,
    absent_at_least: true,
    unit: "",
    read: (report) => [report.input.residual ?? 0],
  },
];

/** The kinds of notch, each with its own slider. @type {Record<string, (physical: boolean) => Field | null>} */
const notch_fields = {
  "ideal, at x = 0": () => null,
  "with a width": (physical) => ({
    name: physical ? "notch-width-m" : "notch-width",
    label: "width of the notch",
    least: 0,
    most: physical ? 0.1 : 0.5,
    unit: physical ? "m" : "",
    read: () => [],
  }),
  "that lets go": () => ({
    name: "hold",
    label: "hold of the notch",
    least: 0,
    most: 0.5,
    unit: "g",
    read: () => [],
  }),
};
const notch_options = [...rivals("hold"), "hold"];
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
