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
