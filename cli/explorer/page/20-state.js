// SPDX-License-Identifier: MIT
// The state of the page is a set of options, named as the program names them, and nothing else: the
// link, the command and the scene are three ways to write it.
"use strict";

/** @param {(row: OptionRow) => boolean} holds */
const names_where = (holds) => option_rows.filter(holds).map(({ name }) => name);
const known = names_where(() => true);
const physical_only = names_where(({ units }) => units === "physical");
const dimensionless_only = names_where(({ units }) => units === "dimensionless");
/** What a design finds. */
const damper_options = names_where(({ commands }) => !commands.includes("design"));

/** What gives the load and shapes it. */
const load_options = names_where(({ load }) => load !== "");

/** @param {Options} options @returns {"hit" | "pulse" | "record"} */
function load_of(options) {
  return "record" in options ? "record" : "pulse" in options ? "pulse" : "hit";
}

/**
 * A task that closed forms know, with the same units: with damping, say, a damper is judged and its region found by
 * simulation, and under records there is no region.
 * @param {Options} options
 */
function plain_task(options) {
  const beyond = names_where(({ simulated }) => simulated);
  const load = load_of(options);
  const left_out = [...beyond, "damping", "breakaway", "objective", "criterion"];
  if (load === "pulse") left_out.push("residual", "residual-m", "arrivals");
  if (load !== "record") return without(options_of("design", options), left_out);
  const [hit, stroke] = is_physical(options) ? ["velocity", "max-displacement"] : ["v0", "beta"];
  const kept = [stroke, "period", ...rivals("period"), "mass", "gravity"];
  const others = Object.keys(options).filter((name) => !kept.includes(name));
  return { [stroke]: "1", ...without(options, others), [hit]: "1" };
}

/** The others of a set from which only one may be given. @param {string} name */
function rivals(name) {
  const set = option_rows.find((row) => row.name === name)?.set;
  return names_where((row) => Boolean(set) && row.set === set && row.name !== name);
}

/** @param {Options} options */
function is_physical(options) {
  const has = (/** @type {string} */ name) => name in options;
  return physical_only.some(has) || !dimensionless_only.some(has);
}

/** @param {Options} options */
function has_damper(options) {
  const has = (/** @type {string[]} */ ...names) => names.some((name) => name in options);
  return has("f", "friction-force") && has("delta", "delta-m");
}

/**
 * @param {Options} options
 * @param {string[]} names
 */
function without(options, names) {
  return Object.fromEntries(Object.entries(options).filter(([name]) => !names.includes(name)));
}

/**
 * The part of the state that a command takes.
 * @param {"design" | "region" | "simulate"} command
 * @param {Options} options
 */
function options_of(command, options) {
  const records = load_of(options) === "record";
  return without(
    options,
    names_where(
      ({ commands, load }) => !commands.includes(command) || (load === "record" && !records),
    ),
  );
}

/**
 * A motion of this damper. It has one hit and one spring: of ranges, those that the report names.
 * @param {Options} options
 * @param {any} report of design or region
 * @param {{ f: number, delta: number, hit: number | null }} damper hit: another strength than the task's
 */
function motion_options(options, report, damper) {
  const { physical, input } = report;
  const result = /** @type {Options} */ ({
    f: String(damper.f),
    delta: String(damper.delta),
    ...without(options_of("simulate", options), ["title", ...damper_options]),
  });
  if ("pulse" in options) result.excitation = options.pulse;
  const shown = /** @type {Record<string, number | undefined>} */ ({
    v0: input.v0,
    k: input.k,
    lambda: input.lambda,
    p: input.p,
    velocity: physical?.velocity_m_per_s,
    period: physical?.period_s,
    damping: input.damping,
  });
  for (const [name, text] of Object.entries(result)) {
    if (!text.includes(":")) continue;
    delete result[name];
    // For a spring or a length of a pulse that are given in another way.
    const one = name in shown ? name : load_options.includes(name) ? "lambda" : "period";
    result[one] = String(shown[one]);
  }
  if (damper.hit !== null && "pulse" in options) result.k = String(damper.hit);
  else if (damper.hit !== null && !physical) result.v0 = String(damper.hit);
  else if (damper.hit !== null) {
    // The length unit depends on the velocity, so a damper that is already built is given in metres.
    delete result.delta;
    result["delta-m"] = String(physical.delta_m);
    result.velocity = String(damper.hit);
  }
  return result;
}

/**
 * The same task without units.
 * @param {Options} options
 * @param {any} report of the task
 * @param {{ f: number, delta: number } | null} damper
 */
function to_plain(options, { input }, damper) {
  /** @param {number} value @param {number[] | null} range */
  const text = (value, range) => (range ?? [value]).join(":");
  const result = without(options, [...physical_only, ...damper_options]);
  const load = load_of(options);
  if (load === "hit") result.v0 = text(input.v0, input.v0_range);
  if (load === "pulse") result.lambda = text(input.lambda, input.lambda_range);
  result.p = text(input.p, input.p_range);
  result.beta = String(input.beta);
  if (input.residual !== null) result.residual = String(input.residual);
  if (input.delta_max !== null) result["delta-max"] = String(input.delta_max);
  if (damper && has_damper(options)) {
    result.f = String(damper.f);
    result.delta = String(damper.delta);
  }
  return result;
}

/**
 * The same task with units. Any length unit gives the same motion; this one has the period of a
 * building on isolators.
 * @param {Options} options
 * @param {any} report of the task
 */
function to_physical(options, { input }) {
  const period = 2.8;
  const gravity = 9.80665;
  const length = gravity * (input.p / ((2 * Math.PI) / period)) ** 2;
  const short = (/** @type {number} */ value) => String(Number(value.toPrecision(6)));
  const velocities = (input.v0_range ?? [input.v0]).map((/** @type {number} */ v) =>
    short(v * Math.sqrt(gravity * length)),
  );
  const dropped = [...dimensionless_only, ...damper_options, "delta-max", "lambda"];
  const frequencies = (input.lambda_range ?? [input.lambda]).map((/** @type {number} */ lambda) =>
    short(lambda / input.p / period),
  );
  const load = load_of(options);
  return {
    ...without(options, dropped),
    ...(load === "hit" ? { velocity: velocities.join(":") } : {}),
    ...(load === "pulse" ? { "excitation-frequency": `${frequencies.join("Hz:")}Hz` } : {}),
    period: `${period}s`,
    "max-displacement": `${short(input.beta * length * 1000)}mm`,
  };
}

/** @param {Options} options */
function to_fragment(options) {
  return known
    .filter((name) => name in options)
    .map(
      (name) =>
        `${name}=${encodeURIComponent(options[name]).replaceAll("%2F", "/").replaceAll("%3A", ":")}`,
    )
    .join("&");
}

/**
 * @param {string} fragment
 * @returns {{ options: Options, unknown: string[] }}
 */
function from_fragment(fragment) {
  const options = /** @type {Options} */ ({});
  const unknown = [];
  for (const part of fragment.replace(/^#/, "").split("&").filter(Boolean)) {
    const at = part.indexOf("=");
    let [name, value] = at < 0 ? [part, ""] : [part.slice(0, at), part.slice(at + 1)];
    try {
      name = decodeURIComponent(name);
      value = decodeURIComponent(value);
    } catch {
      // Not encoded, or badly: taken as it is.
    }
    name = name.replaceAll("_", "-");
    if (known.includes(name) && (value !== "" || name === "record")) options[name] = value;
    else unknown.push(part);
  }
  return { options, unknown };
}

/**
 * A scene of data/scenes as options; nothing if it is about something that this page does not show.
 * @param {Record<string, string | number | Array<string | number>>} scene
 */
function from_scene(scene) {
  const options = /** @type {Options} */ ({});
  for (const [key, value] of Object.entries(scene)) {
    const name = key.replaceAll("_", "-");
    if (!known.includes(name)) return null;
    options[name] = Array.isArray(value) ? value.join(":") : String(value);
  }
  return ["v0", "velocity", "pulse"].some((name) => name in options) ? options : null;
}

/** @param {string} text */
function shell_word(text) {
  return /^[\w./:+,-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;
}

/**
 * @param {string} command
 * @param {Options} options
 */
function command_line(command, options) {
  const flags = Object.entries(options).flatMap(([name, value]) =>
    value.split("\n").map((one) => ` --${name} ${shell_word(one)}`),
  );
  return `stillpoint ${command}${flags.join("")}`;
}

/** @param {Options} options */
function to_scene(options) {
  const numeric = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i;
  const entries = Object.entries(options).map(([name, value]) => {
    if (name === "record") return [name, value.split("\n")];
    const ends = value.split(":");
    if (ends.length === 2 && ends.every((end) => numeric.test(end)))
      return [name, ends.map(Number)];
    return [name, name !== "title" && numeric.test(value) ? Number(value) : value];
  });
  return JSON.stringify(Object.fromEntries(entries), null, 2) + "\n";
}
