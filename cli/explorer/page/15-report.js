// SPDX-License-Identifier: MIT
// What a report says, in metres and seconds if the task has units.
"use strict";

const ends_words = /** @type {Record<string, string>} */ ({
  held: "held",
  centred: "centred",
  within_residual: "within the residual",
  off_centre: "off centre",
  alternating: "alternately centred and off centre",
  passes: "passes x = 0",
  too_far: "too far",
  never_stops: "never stops",
});

/** @param {any} physical of a report */
function units_of(physical) {
  return physical
    ? { length: "m", time: "s", velocity: "m/s" }
    : { length: "", time: "", velocity: "" };
}

/** The motion of a design, a given damper or a run. @param {any} report */
function response_of(report) {
  return report.response ?? report.cases[0].motions[0]?.response;
}

/** The largest acceleration that the structure feels, as reports call it. */
const felt_name = "peak_absolute_acceleration";
/** @param {any} response */
const felt_of = (response) => response[felt_name];

/** The figures of a motion. @param {any} report of design or simulate */
function motion_of(report) {
  const { physical, input } = report;
  const response = response_of(report);
  return {
    peak: physical ? physical.peak_m : response.peak_amplitude,
    rest: physical ? physical.stop_position_m : response.stop_position,
    stop_time: physical ? physical.stop_time_s : response.stop_time,
    acceleration: felt_of(response),
    felt: input.notch_width ? "the notch included" : "outside the notch",
  };
}

/** Whether a damper fails or must be warned of. @param {any} report @returns {boolean} */
function alarms_of({ admissible, findings }) {
  return admissible === false || findings.some((/** @type {any} */ now) => now.severity !== "info");
}

/** The worst figures of a suite. @param {any} report of design or region under records */
function suite_of({ cases: [{ worst }] }) {
  return {
    peak: worst.peak_m ?? worst.peak_amplitude,
    rest: worst.residual_m ?? worst.residual,
    stop_time: null,
    acceleration: felt_of(worst),
    felt: "the worst within the tolerance",
  };
}

/** What is to be known beyond the numbers. @param {any} report @returns {string} */
function remarks_of({ findings }) {
  return findings.map((/** @type {any} */ now) => now.text).join(" ");
}

/** The largest displacement allowed. @param {any} report of design or region */
function limit_of({ input, physical }) {
  return input.beta * (physical?.length_unit_m ?? 1);
}

/** The largest rest allowed off x = 0. @param {any} report */
function residual_of({ input, physical }) {
  return (input.residual ?? 0) * (physical?.length_unit_m ?? 1);
}

/** The weakest and the strongest hit of the task, or the peaks of its pulse in g. @param {any} report @param {number} unit */
function ends({ input }, unit = 1) {
  const { k, k_range, v0, v0_range, pulse } = input;
  if (pulse) return k_range ?? [k, k];
  const [low, high] = v0_range ?? [v0, v0];
  return [low * unit, high * unit];
}

/** The same in the unit of the task. @param {any} report */
function strengths_of(report) {
  return ends(report, report.physical?.velocity_unit_m_per_s);
}

/** How hits of each strength end. @param {any} report */
function hits_of({ hits, physical }) {
  const suffix = physical?.hits ? "_m_per_s" : "";
  const parts = /** @type {{ ends: string, from: number, to: number }[]} */ ([]);
  (hits ?? []).forEach((/** @type {any} */ hit, /** @type {number} */ i) => {
    const { [`from${suffix}`]: from, [`to${suffix}`]: to } = physical?.hits?.[i] ?? hit;
    const last = parts[parts.length - 1];
    // Of a range of springs two neighbours may end alike.
    if (last?.ends === hit.ends) last.to = to;
    else parts.push({ ends: hit.ends, from, to });
  });
  return parts;
}
