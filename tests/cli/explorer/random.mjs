// SPDX-License-Identifier: MIT

/** @typedef {() => number} Random in [0, 1) */

/** Evenly, from a seed (mulberry32). @param {number} seed @returns {Random} */
export function random_from(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/**
 * A task as a fragment: with units or without, one hit or a range.
 * @param {Random} random
 */
export function random_task(random) {
  const between = (/** @type {number} */ low, /** @type {number} */ high) =>
    low * (high / low) ** random();
  const now_and_then = (/** @type {number} */ chance, /** @type {() => string} */ text) =>
    random() < chance ? `&${text()}` : "";
  const digits = (/** @type {number} */ value) =>
    String(Number(value.toPrecision(1 + Math.floor(16 * random()))));
  const p = between(0.05, 5);
  const v0 = between(0.01, 10);
  const beta = (v0 / p) * between(0.65, 1.5);
  const range = (/** @type {number} */ value) =>
    random() < 0.2 ? `${digits(0.8 * value)}:${digits(1.05 * value)}` : digits(value);
  let task;
  if (random() < 0.5) {
    task = `v0=${range(v0)}&p=${digits(p)}&beta=${digits(beta)}`;
    task += now_and_then(0.2, () => `residual=${digits(beta * 0.02)}`);
  } else {
    const period = between(0.1, 8);
    const velocity = between(0.01, 2);
    const stroke = (velocity * period * between(0.65, 1.5)) / (2 * Math.PI);
    task = `velocity=${range(velocity)}&max-displacement=${digits(stroke * 1000)}mm`;
    task +=
      random() < 0.5 ? `&period=${digits(period)}s` : `&natural-frequency=${digits(1 / period)}Hz`;
    task += now_and_then(0.5, () => `mass=${digits(between(1, 1e4))}t`);
    task += now_and_then(0.2, () => `residual-m=${digits(stroke * 20)}mm`);
  }
  task += now_and_then(0.4, () => `arrivals=${1 + Math.floor(4 * random())}`);
  task += now_and_then(0.3, () => "criterion=exact");
  task += now_and_then(0.2, () => `tolerance=${digits(0.2 * random())}`);
  task += now_and_then(
    0.2,
    () => `objective=${["amplitude", "time", "acceleration"][Math.floor(3 * random())]}`,
  );
  return task;
}
