// SPDX-License-Identifier: MIT
// The specification: two pages for the one who builds or checks the damper.
"use strict";

const assumptions = [
  "One rigid mass moves in one direction on a linear spring, without viscous damping.",
  "The constant friction is the same at rest and in motion, whatever the speed, the pressure and the temperature. Give their spread as the tolerance.",
  "The notch takes the same energy at every passage through x = 0.",
  "The hit is a velocity at x = 0, where the mass has left the notch. That is valid for pulses much shorter than the natural period.",
  "Nothing stops the mass at the stroke limit: farther out the motion goes on.",
  "One hit: each later one starts where the mass came to rest after the one before.",
];

/**
 * @typedef {object} Sheet
 * @property {Options} options
 * @property {any} report of the design, or of the damper that was chosen
 * @property {any} motion
 * @property {boolean} chosen the damper was set by hand
 * @property {boolean} admissible
 * @property {number | null} tolerance
 * @property {string} command
 * @property {string} link
 * @property {string} version
 */

/** @param {[string, Part[] | null][]} rows those without a value are left out */
function sheet_table(rows) {
  const body = make("tbody");
  for (const [name, value] of rows) {
    if (value)
      body.append(make("tr", {}, make("th", { scope: "row" }, name), make("td", {}, ...value)));
  }
  return make("table", {}, body);
}

/** @param {string[]} head @param {Part[][]} rows */
function sheet_columns(head, rows) {
  const cells = (/** @type {string} */ tag, /** @type {Part[]} */ row) =>
    make("tr", {}, ...row.map((part) => make(tag, {}, part)));
  return make(
    "table",
    {},
    make("thead", {}, cells("th", head)),
    make("tbody", {}, ...rows.map((row) => cells("td", row))),
  );
}

/** @param {(number | null)[] | null | undefined} range @param {string} unit @returns {Part[] | null} */
function range_parts(range, unit) {
  if (!range) return null;
  const [low, high] = range;
  return high === null
    ? ["at least ", number(low, unit)]
    : [number(low, unit), " to ", number(high, unit)];
}

/** @param {Sheet} sheet */
function build_rows({ report, motion, tolerance, options }) {
  const physical = report.physical;
  const { f, delta } = motion.input;
  return sheet_table([
    ["constant friction", ["f = ", number(f)]],
    [
      "friction force",
      physical?.friction_force_n ? [number(physical.friction_force_n, "N")] : null,
    ],
    ["notch", ["Δ = ", number(delta), ...(physical ? [" = ", number(physical.delta_m, "m")] : [])]],
    [
      "capacity",
      physical?.energy_per_passage_j
        ? [number(physical.energy_per_passage_j, "J"), " at a passage"]
        : null,
    ],
    [
      "notch width",
      options["notch-width-m"] || options["notch-width"]
        ? [options["notch-width-m"] ?? options["notch-width"]]
        : null,
    ],
    ["notch lets go", options.hold ? [`at ${options.hold.replace(/\s*g$/, "")} g above f`] : null],
    [
      "tolerance",
      tolerance === null
        ? ["none: not admissible"]
        : [number(tolerance, "%", "±"), " of f and Δ at once"],
    ],
  ]);
}

/** @param {Sheet} sheet */
function performance_rows({ report, motion }) {
  const { practice, works_for } = report;
  const limit = limit_of(report);
  const { peak, rest, stop_time, acceleration } = motion_of(motion);
  const { length, time, velocity } = units_of(motion.physical);
  return sheet_table([
    [
      "peak",
      [
        number(peak, length),
        ", ",
        number(peak / limit, "%"),
        " of the limit ",
        number(limit, length),
      ],
    ],
    [
      "at rest",
      rest === null
        ? ["never"]
        : ["at x = ", number(rest, rest === 0 ? "" : length), " after ", number(stop_time, time)],
    ],
    ["transmitted", [number(acceleration, "g"), " outside the notch"]],
    [
      "works for hits of",
      range_parts(report.physical?.works_for_velocity_m_per_s ?? works_for?.v0, velocity),
    ],
    [
      report.physical ? "and periods of" : "and p of",
      range_parts(report.physical?.works_for_period_s ?? works_for?.p, time),
    ],
    ["base shear/weight", practice ? [number(practice.base_shear_over_weight)] : null],
    [
      "secant stiffness",
      practice && report.physical?.secant_stiffness_n_per_m
        ? [number(report.physical.secant_stiffness_n_per_m, "N"), "/m"]
        : null,
    ],
    [
      "equivalent damping",
      practice?.equivalent_damping
        ? [number(practice.equivalent_damping, "%"), " of critical"]
        : null,
    ],
    [
      "re-centring",
      practice?.energy_ratio
        ? [
            "Eₛ/Eₕ = ",
            number(practice.energy_ratio),
            " (EN 15129), d/dᵣₘ = ",
            number(practice.residual_ratio),
            " (EN 1998-2)",
          ]
        : null,
    ],
  ]);
}

/** How hits of each strength end; if that changes many times, the strengths between which it does. @param {Sheet} sheet */
function hit_rows({ report }) {
  const hits = hits_of(report);
  /** @type {{ ends: string, from: number, to: number | null, count: number }[]} */
  const rows = [];
  hits.forEach(({ ends, from, to: end }, i) => {
    const to = i + 1 < hits.length ? end : null; // the last one has no end but that of the figure
    const same = hits.length > most_keys && rows.find((row) => row.ends === ends);
    if (!same) rows.push({ ends, from, to, count: 1 });
    else Object.assign(same, { to, count: same.count + 1 });
  });
  return sheet_table(
    rows.map(({ ends, from, to, count }) => {
      const range = range_parts([from, to], units_of(report.physical).velocity) ?? [];
      const many = count > 1 ? [number(count), " ranges within "] : [];
      return [ends_words[ends] ?? ends, [...many, ...range]];
    }),
  );
}

/** @param {Sheet} sheet */
function check_nodes({ report }) {
  const nodes = /** @type {Node[]} */ ([]);
  if (report.cross_check) {
    nodes.push(
      sheet_columns(
        ["computed again by", "relative error", "allowed", ""],
        report.cross_check.methods.map((/** @type {any} */ method) => [
          method.name.replaceAll("_", " "),
          number(method.relative_error),
          number(method.tolerance),
          method.passed ? "agrees" : "DISAGREES",
        ]),
      ),
    );
  }
  nodes.push(
    sheet_columns(
      ["condition", "variable", "value", "", "bound", ""],
      report.constraints.map((/** @type {any} */ one) => [
        one.name.replaceAll("_", " "),
        one.variable,
        number(one.value),
        one.relation.replace("<=", "≤").replace(">=", "≥"),
        number(one.limit),
        one.satisfied ? "met" : "VIOLATED",
      ]),
    ),
  );
  return nodes;
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

/** @param {Sheet} sheet */
function draw_sheet(sheet) {
  const { options, chosen, admissible, command, link, version } = sheet;
  const task = Object.entries(without(options, ["title", ...damper_options]));
  const title = options.title ?? "Damper with constant and point friction";
  const day = new Date().toLocaleDateString("en-GB", {
    day: "numeric",
    month: "long",
    year: "numeric",
  });
  const head = chosen
    ? `Damper chosen by hand; ${admissible ? "it meets every condition" : "it is NOT admissible"}.`
    : options.objective && options.objective !== "robust"
      ? `The best damper for the objective ${options.objective}.`
      : "Of all dampers, this one tolerates the largest manufacturing errors.";
  fill(
    el("sheet"),
    make(
      "div",
      { class: "leaf" },
      make("h1", {}, title),
      make("p", {}, `Damper specification. ${head}`),
      make("h2", {}, "To build"),
      build_rows(sheet),
      make("h2", {}, "What it does"),
      performance_rows(sheet),
      make("h2", {}, "How the motion ends after other hits"),
      hit_rows(sheet),
      make("div", { class: "plates" }, plate_copy("region"), plate_copy("phase")),
    ),
    make(
      "div",
      { class: "leaf" },
      make("h2", {}, "Task"),
      make(
        "div",
        { class: "task" },
        sheet_table(task.map(([name, value]) => [name.replaceAll("-", " "), [value]])),
      ),
      make("h2", {}, "Checks"),
      ...check_nodes(sheet),
      make("h2", {}, "Assumptions"),
      make("ul", {}, ...assumptions.map((text) => make("li", {}, text))),
      make("h2", {}, "The same with the program"),
      make("pre", {}, ...whole_words(command)),
      make("p", { class: "foot" }, `stillpoint ${version}, ${day}. State of the page: #${link}`),
    ),
  );
}
