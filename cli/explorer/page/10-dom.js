// SPDX-License-Identifier: MIT
// Elements, and numbers as they are shown: rounded to read, in full in data-value.
"use strict";

/**
 * @param {string} id
 * @returns {HTMLElement}
 */
function el(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`no element ${id}`);
  return found;
}

/**
 * @param {string} id
 * @returns {HTMLInputElement}
 */
function input(id) {
  return /** @type {HTMLInputElement} */ (el(id));
}

/** @param {Node} node @returns {HTMLInputElement} */
const input_of = (node) => /** @type {HTMLInputElement} */ (node);

/** @typedef {Node | string} Part */

/**
 * @param {string} tag
 * @param {Record<string, string>} attributes
 * @param {Part[]} parts
 */
function make(tag, attributes = {}, ...parts) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...parts);
  return node;
}

/**
 * @param {string} tag
 * @param {Record<string, string | number>} attributes
 * @param {Part[]} parts
 */
function svg(tag, attributes = {}, ...parts) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, String(value));
  node.append(...parts);
  return node;
}

/** @param {string} unit @returns {[number, string][]} */
const thousands = (unit) => [
  [1e9, `G${unit}`],
  [1e6, `M${unit}`],
  [1e3, `k${unit}`],
  [1, unit],
];

/** Units that take a prefix, with the prefixes that are usual for them. */
const prefixes = /** @type {Record<string, [number, string][]>} */ ({
  m: [
    [1, "m"],
    [1e-3, "mm"],
    [1e-6, "µm"],
  ],
  s: [
    [1, "s"],
    [1e-3, "ms"],
  ],
  N: thousands("N"),
  "N/m": thousands("N/m"),
  "N s": thousands("N s"),
  J: thousands("J"),
  kg: [
    [1e3, "t"],
    [1, "kg"],
  ],
});

/**
 * @param {number} value
 * @param {number} count significant digits
 */
function digits(value, count = 5) {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) {
    return value.toExponential(count - 1).replace(/\.?0*e\+?/, "e");
  }
  return String(Number(value.toPrecision(count)));
}

/**
 * A value in SI units in a readable form: 0.1374 m is 137.4 mm.
 * @param {number} value
 * @param {string} unit
 * @param {number} count significant digits
 */
function words(value, unit, count = 5) {
  if (unit === "%") return `${digits(100 * value, 4)} %`;
  const list = prefixes[unit];
  if (!list || value === 0) return digits(value, count) + (unit && ` ${unit}`);
  const from = unit === "s" ? 1e-3 : 1; // times of a page in one unit, as in the program's reports
  const [factor, name] =
    list.find(([size]) => Math.abs(value) >= from * size) ?? list[list.length - 1];
  return `${digits(value / factor, count)} ${name}`;
}

/** Writes a text only if it differs: even the same one would be laid out anew. @param {HTMLElement} node @param {string} text */
function write(node, text) {
  if (node instanceof HTMLInputElement) {
    if (node.value !== text) node.value = text;
  } else if (node.textContent !== text) {
    node.textContent = text;
  }
}

/**
 * Shows a number in an element that exists.
 * @param {HTMLElement} node
 * @param {number | null | undefined} value
 * @param {string} unit
 * @param {string} sign
 */
function show(node, value, unit = "", sign = "") {
  if (value === null || value === undefined) {
    write(node, "–");
    delete node.dataset.value;
    delete node.dataset.unit;
    return;
  }
  write(node, sign + words(value, unit).replaceAll(" ", "\u00a0"));
  node.dataset.value = String(value);
  node.dataset.unit = unit === "%" ? "1" : unit;
}

/**
 * A number within a sentence.
 * @param {number | null | undefined} value
 * @param {string} unit
 * @param {string} sign
 */
function number(value, unit = "", sign = "") {
  const node = make("span");
  show(node, value, unit, sign);
  return node;
}

/**
 * @param {HTMLElement} node
 * @param {Part[]} parts
 */
function fill(node, ...parts) {
  node.replaceChildren(...parts);
}

/** "delta max" of --delta-max-m. @param {string} name of an option */
function option_words(name) {
  return name.replace(/-m$/, "").replaceAll("-", " ");
}

/** An entry of a legend. @param {string} ink @param {Part[]} parts */
function key(ink, ...parts) {
  return make("span", { class: `key ink-${ink}` }, make("span", {}, ...parts));
}

/** @param {string[]} ids of elements */
function clear(...ids) {
  for (const id of ids) el(id).replaceChildren();
}
