// node same_digits.mjs ENGINE PROGRAM [SEED]: the JSON of the page's engine is that of the program, in every digit but
// the times, for random tasks; so are its refusals of wrong input.
import { execFileSync, spawnSync } from "node:child_process";
import { load_engine } from "../../../cli/explorer/load.mjs";
import { random_from } from "../explorer/random.mjs";

const [script, program, seed = "20081"] = process.argv.slice(2);
const tasks = 200;

const engine = await load_engine(script);

const random = random_from(Number(seed));
const between = (/** @type {number} */ low, /** @type {number} */ high) =>
  low + (high - low) * random();
/** @template T @param {T[]} list @returns {T} */
const one_of = (list) => list[Math.floor(random() * list.length)];

/** @typedef {Record<string, any>} Task the options of a command */

/** @returns {Task} */
const hit = () =>
  random() < 0.5
    ? { v0: between(0.1, 3), p: between(0.3, 3) }
    : { velocity: `${between(0.05, 2)}`, period: `${between(0.3, 5)}s` };
/** @param {Task} task @returns {Task} */
const stroke = (task) =>
  task.v0 === undefined
    ? {
        "max-displacement": `${(between(0.5, 1.1) * task.velocity * parseFloat(task.period) * 1000) / 6.28}mm`,
      }
    : { beta: (between(0.5, 1.1) * task.v0) / task.p };
const now_and_then = (/** @type {Task} */ options) => (random() < 0.2 ? options : {});

/** A task of each command in turn. @param {number} number @returns {[string, Task]} */
function task(number) {
  const options = hit();
  if (number % 3 === 2) {
    Object.assign(options, { f: between(0, 0.5), delta: between(0, 0.3) });
    if (options.v0 !== undefined && random() < 0.4) {
      Object.assign(options, {
        excitation: one_of(["harmonic", "half-sine", "full-sine"]),
        k: between(0.2, 2),
        lambda: between(0.3, 3),
      });
      if (options.excitation === "harmonic") options["t-end"] = between(5, 60);
    }
    return ["simulate", options];
  }
  Object.assign(
    options,
    stroke(options),
    now_and_then({ arrivals: one_of([1, 2, 3]) }),
    now_and_then({ "tolerance-f": 0.05 }),
    now_and_then({ "acceleration-max": between(0.5, 3) }),
  );
  if (number % 3 === 1) {
    if (random() < 0.5) Object.assign(options, { f: between(0, 0.5), delta: between(0, 0.3) });
    return ["region", options];
  }
  return [
    "design",
    { ...options, ...now_and_then({ objective: one_of(["robust", "time", "peak"]) }) },
  ];
}

/** Without wall times. */
const timeless = (/** @type {string} */ text) =>
  text.replace(/"(wall_time_s|[a-z_]*seconds|[a-z_]*_us)": [-+.e0-9]+/g, '"$1": 0');

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
  const words = Object.entries(options).flatMap(([name, value]) => [`--${name}`, `${value}`]);
  const expected = spawnSync(program, [command, ...words, "--json"], { encoding: "utf8" });
  const found = engine.run(command, options);
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
