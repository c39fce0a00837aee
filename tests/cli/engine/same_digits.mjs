// node same_digits.mjs ENGINE PROGRAM [SEED]: the JSON of the page's engine is that of the program, in every digit but
// the times, for random tasks; so are its refusals of wrong input.
import { execFileSync, spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { load_engine } from "../../../cli/explorer/load.mjs";
import { random_from, random_task } from "../explorer/random.mjs";

const [script, program, seed = "20081"] = process.argv.slice(2);
const tasks = 200;

const engine = await load_engine(script);
const records = new URL("../../../data/records/", import.meta.url).pathname;
/** What the pulses of the option table are called. @type {string[]} */
const pulses = engine.options.find(({ name }) => name === "pulse")?.values ?? [];

const random = random_from(Number(seed));
const between = (/** @type {number} */ low, /** @type {number} */ high) =>
  low + (high - low) * random();
/** @template T @param {T[]} list @returns {T} */
const one_of = (list) => list[Math.floor(random() * list.length)];

/** @typedef {Record<string, any>} Task the options of a command */

const now_and_then = (/** @type {Task} */ options) => (random() < 0.2 ? options : {});

/** @returns {Task} */
function pulse() {
  const period = between(0.3, 3);
  const duration = period * between(0.01, 0.6);
  const k = Math.min(100, between(0.3, 1.5) / duration);
  return {
    pulse: one_of(pulses),
    k: random() < 0.3 ? `${0.8 * k}:${k}` : `${k}g`,
    "pulse-duration": `${duration}s`,
    period: `${period}s`,
    // Of a half-sine: near the peak without friction.
    "max-displacement": `${((2 * k * 9.8 * duration * period) / 6.28 / 3.14) * between(0.5, 1.2)}m`,
    ...now_and_then({ "delta-max-m": `${between(1, 60)}mm` }),
    ...now_and_then({ "acceleration-max": `${between(0.5, 3)}` }),
    ...now_and_then({ "residual-m": "4mm" }),
  };
}

/** Of two records, each with a factor; both commands simulate them. @returns {Task} */
function suite() {
  return {
    record: ["near_fault_pulse.txt", "strong_motion.AT2"].map((name) => records + name).join("\n"),
    period: `${between(1, 3)}s`,
    "max-displacement": `${between(100, 400)}mm`,
    "record-scale": `${between(0.5, 1.5)}`,
    ...now_and_then({ "jump-max": 1 }),
    ...now_and_then({ "residual-m": "30mm" }),
    ...now_and_then({ combine: "mean" }),
    ...now_and_then({ mass: "1200t" }),
  };
}

/** A task under a pulse or under records. @param {number} number @returns {[string, Task]} */
function shaken(number) {
  const options = number % 4 ? pulse() : suite();
  const forced = options.mass ? { "friction-force": "500kN" } : { f: between(0, 0.3) };
  if (random() < 0.5)
    return ["region", { ...options, ...forced, "delta-m": `${between(0, 40)}mm` }];
  return ["design", options];
}

/** A task of each command in turn. @param {number} number @returns {[string, Task]} */
function task(number) {
  if (number % 5 === 4) return shaken(number);
  /** @type {Task} */
  const options = Object.fromEntries(new URLSearchParams(random_task(random)));
  if (number % 3 === 2) {
    /** @type {Task} */
    const motion = { f: between(0, 0.5), delta: between(0, 0.3) };
    for (const name of ["v0", "p", "velocity", "period", "natural-frequency", "mass"]) {
      if (options[name]) motion[name] = options[name].split(":")[0]; // of one hit
    }
    if (motion.v0 !== undefined && random() < 0.4) {
      const waves = [...pulses.filter((name) => name !== "rectangle"), "harmonic"];
      Object.assign(motion, {
        excitation: one_of(waves),
        k: between(0.2, 2),
        lambda: between(0.3, 3),
      });
      if (motion.excitation === "harmonic") motion["t-end"] = between(5, 60);
    }
    return ["simulate", motion];
  }
  Object.assign(options, now_and_then({ "tolerance-f": 0.05 }));
  Object.assign(options, now_and_then({ "acceleration-max": between(0.5, 3) }));
  if (number % 3 === 1) {
    delete options.objective;
    if (random() < 0.5) Object.assign(options, { f: between(0, 0.5), delta: between(0, 0.3) });
    return ["region", options];
  }
  return ["design", options];
}

/** Without wall times, folders, and what the integrator of the check says of a pulse: its last digits differ. */
const timeless = (/** @type {string} */ text = "") =>
  text
    .replaceAll(records, "")
    .replace(/"(wall_time_s|[a-z_]*seconds|[a-z_]*_us)": [-+.e0-9]+/g, '"$1": 0')
    .replace(/(?<="pulse": ".*)\{\s*"name": "runge_kutta"[^}]*\}/s, "{}");

/** The places where two reports differ. @param {any} a @param {any} b @returns {string[]} */
function differences(a, b, place = "") {
  if (a !== null && b !== null && typeof a === "object" && typeof b === "object") {
    return [...new Set([...Object.keys(a), ...Object.keys(b)])].flatMap((key) =>
      differences(a[key], b[key], Array.isArray(a) ? `${place}[]` : `${place}.${key}`),
    );
  }
  return Object.is(a, b) ? [] : [place];
}

let wrong = 0;
const fields = new Map();
for (let number = 0; number < tasks; ++number) {
  const [command, options] = task(number);
  const words = Object.entries(options).flatMap(([name, value]) =>
    String(value)
      .split("\n")
      .flatMap((one) => [`--${name}`, one]),
  );
  const expected = spawnSync(program, [command, ...words, "--json"], { encoding: "utf8" });
  const named = options.record?.split("\n") ?? [];
  const short = (/** @type {string} */ path) => path.slice(records.length);
  const here = named.length ? { ...options, record: named.map(short).join("\n") } : options;
  const files = Object.fromEntries(
    named.map((/** @type {string} */ path) => [short(path), readFileSync(path)]),
  );
  const found = engine.run(command, here, {}, files);
  const refusal = "error" in found ? found.error : undefined;
  const answer = "error" in found ? undefined : found;
  if (expected.status === 2) {
    const said = expected.stderr.trim().replace(/^stillpoint: /, "");
    if (refusal !== said) {
      ++wrong;
      console.error(`${command} ${words.join(" ")}\n  program: ${said}\n  engine:  ${refusal}`);
    }
  } else if (
    answer?.exit !== expected.status ||
    timeless(answer.json) !== timeless(expected.stdout)
  ) {
    ++wrong;
    const places =
      answer === undefined
        ? [refusal]
        : differences(JSON.parse(timeless(expected.stdout)), JSON.parse(timeless(answer.json)));
    for (const place of new Set(places)) fields.set(place, (fields.get(place) ?? 0) + 1);
    if (wrong <= 3)
      console.error(
        `${command} ${words.join(" ")}\n  differs in ${[...new Set(places)].join(", ")}`,
      );
  }
}
for (const [place, count] of [...fields].sort((a, b) => b[1] - a[1]))
  console.error(`${count} ${place}`);
console.log(
  `${wrong} of ${tasks} tasks differ (seed ${seed}, ${execFileSync(program, ["--version"]).toString().trim()})`,
);
process.exit(wrong === 0 ? 0 : 1);
