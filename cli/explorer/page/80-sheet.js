// SPDX-License-Identifier: MIT
// The specification: two pages for the one who builds or checks the damper.
"use strict";

/** @param {Options} options */
const assumptions = ({ damping, breakaway }) => [
  `One rigid mass moves in one direction on a linear spring, ${damping ? `with viscous damping of ${damping} of the critical` : "without viscous damping"}.`,
  `The constant friction is ${breakaway ? `${breakaway} times as large at rest as` : "the same at rest and"} in motion, whatever the speed, the pressure and the temperature. Give their spread as the tolerance.`,
  "The notch takes the same energy at every passage through x = 0.",
  "The hit is a velocity at x = 0, where the mass has left the notch. That is valid for pulses much shorter than the natural period.",
  "Nothing stops the mass at the stroke limit: farther out the motion goes on.",
  "One hit: each later one starts where the mass came to rest after the one before.",
];

/** What the figures used in practice are. @param {Options} options */
function practice_words(options) {
  const ideal = "hold" in options ? "holds any load" : "has no width";
  const built = notch_options.some((name) => name in options);
  return `The energy ratio is that of EN 15129, the residual ratio that of EN 1998-2.${
    built ? ` The figures of practice are with a notch that ${ideal}.` : ""
  }`;
}

/** Those of the program's details that a specification shows; the others are left to the program. */
const sheet_details = ["Practice", "Practice worst", "Physical"];

/**
 * @typedef {object} Sheet
 * @property {Options} options
 * @property {string} verdict
 * @property {string} document the program's sections, as HTML
 * @property {Figure[]} hits how the motion ends after other hits
 * @property {string} command
 * @property {string} link
 * @property {string} version
 */

/** The program's answer, what follows from it, and the details, opened. @param {string} document */
function program_parts(document) {
  const all = make("div");
  all.innerHTML = document;
  const details = [...all.querySelectorAll("details")];
  for (const one of details) one.remove();
  const shown = details.filter((one) =>
    sheet_details.includes(one.querySelector("summary")?.textContent ?? ""),
  );
  for (const one of shown) one.open = true;
  const sections = [...all.querySelectorAll("section")];
  for (const one of sections) one.remove();
  return { answer: all, sections, details: make("div", { class: "details" }, ...shown) };
}

/** @param {string} id */
function plate_copy(id) {
  const plate = make("div");
  // The copy has ids of its own: a pattern in what is not displayed is not drawn.
  plate.innerHTML = el(id).innerHTML.replaceAll(`${id}-`, `sheet-${id}-`);
  return plate;
}

/** A text that breaks only between words: browsers also break after each hyphen. @param {string} text @returns {Part[]} */
function whole_words(text) {
  return text
    .split(/(\s+)/)
    .map((word) => (word.trim() ? make("span", { class: "word" }, word) : word));
}

/** @param {[string, string]} option */
function task_row([name, value]) {
  return make("tr", {}, make("th", {}, option_words(name)), make("td", {}, value));
}

/** @param {Sheet} sheet */
function draw_sheet({ options, verdict, document, hits, command, link, version }) {
  const task = Object.entries(without(options, ["title", ...damper_options]));
  const day = new Date().toLocaleDateString("en-GB", {
    day: "numeric",
    month: "long",
    year: "numeric",
  });
  const { answer, sections, details } = program_parts(document);
  const plates = hits.map(({ svg }) => {
    const plate = make("div");
    plate.innerHTML = svg;
    return plate;
  });
  fill(
    el("sheet"),
    make(
      "div",
      { class: "leaf" },
      make("h1", {}, options.title ?? "Damper with constant and point friction"),
      make("p", {}, `Damper specification. ${verdict}`),
      answer,
      ...sections,
      make("div", { class: "plates" }, plate_copy("region"), plate_copy("phase")),
    ),
    make(
      "div",
      { class: "leaf" },
      make("h2", {}, "Task"),
      make("div", { class: "details" }, make("table", {}, ...task.map(task_row))),
      details,
      make("p", {}, document.includes("Practice") ? practice_words(options) : ""),
      make("h2", {}, "Assumptions"),
      make(
        "div",
        { class: "plates" },
        make("ul", {}, ...assumptions(options).map((text) => make("li", {}, text))),
        ...plates,
      ),
      make("h2", {}, "The same with the program"),
      make("pre", {}, ...whole_words(command)),
      make("p", { class: "foot" }, `stillpoint ${version}, ${day}. State of the page: #${link}`),
    ),
  );
}
