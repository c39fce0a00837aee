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

const method_words = /** @type {Record<string, string>} */ ({
  half_cycle_map: "half-cycle map",
  runge_kutta: "Runge-Kutta",
});

const constraint_words = /** @type {Record<string, string>} */ ({
  dead_zone: "dead zone",
  f_max: "largest f",
  delta_max: "largest Δ",
});

const most_full_rows = 4; // of hits: more do not leave room for the plots

/**
 * @typedef {object} Sheet
 * @property {Options} options
 * @property {any} report of the design, or of the damper that was chosen
 * @property {any} motion
 * @property {number | null} tolerance
 * @property {string} command
 * @property {string} link
 * @property {string} version
 */

/** @param {[string, ...(Part[] | null)[]][]} rows those without a value are left out @param {string[]} head of the columns */
function sheet_table(rows, head = []) {
  const body = make("tbody");
  for (const [name, ...values] of rows) {
    if (values.some(Boolean))
      body.append(
        make(
          "tr",
          {},
          make("th", { scope: "row" }, name),
          ...values.map((value) => make("td", {}, ...(value ?? ["–"]))),
        ),
      );
  }
  const names = head.map((text) => make("th", { scope: "col" }, text));
  return make(
    "table",
    {},
    ...(names.length ? [make("thead", {}, make("tr", {}, ...names))] : []),
    body,
  );
}

/** Two rows in a line. @param {HTMLElement} table */
function sheet_halves(table) {
  return make("div", { class: "halves" }, table);
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
      "notch capacity",
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
    ["hold", options.hold ? [`${options.hold.replace(/\s*g$/, "")} g above f`] : null],
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
  const { works_for } = report;
  const limit = limit_of(report);
  const { peak, rest, stop_time, acceleration, felt } = motion_of(motion);
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
    ["transmitted", [number(acceleration, "g"), ` ${felt}`]],
    [
      "works for hits of",
      range_parts(report.physical?.works_for_velocity_m_per_s ?? works_for?.v0, velocity),
    ],
    [
      report.physical ? "and periods of" : "and p of",
      range_parts(report.physical?.works_for_period_s ?? works_for?.p, time),
    ],
  ]);
}

/** Of a task with ranges, which motion is shown. @param {any} report */
function shown_words({ input }) {
  const ends = [input.v0_range && "strongest hit", input.p_range && "softest spring"];
  return ends.filter(Boolean).join(", ");
}

/** @param {string} title @param {string} which may be empty */
function sheet_heading(title, which) {
  return make("h2", {}, which ? `${title}: ${which}` : title);
}

/** The figures used in practice: of the motion shown and, with ranges, the worst at their ends. @param {Sheet} sheet */
function practice_nodes({ report, motion, options }) {
  const { practice, physical, input } = report;
  if (!practice) return [];
  // Of all hits up to one, with one spring, the strongest is the worst.
  const practice_worst = input.v0_range?.[0] === 0 && !input.p_range ? null : report.practice_worst;
  const { mass_kg, gravity_m_per_s2, length_unit_m, velocity_unit_m_per_s } = physical ?? {};
  const impulse = (/** @type {number} */ value) =>
    mass_kg
      ? [number(mass_kg * velocity_unit_m_per_s * value, "N s")]
      : physical
        ? [number(velocity_unit_m_per_s * value, "N s"), " per kg"]
        : [number(value), " times the mass"];
  const columns = [practice, practice_worst].filter(Boolean);
  const range_worst = report.built_notch?.largest_acceleration;
  /** @param {string} name @param {(now: any) => Part[] | null} cell @returns {[string, ...(Part[] | null)[]]} */
  const row = (name, cell) => [name, ...columns.map(cell)];
  const rows = [
    row("base shear/weight", (now) =>
      // What is transmitted, with a notch that has a width in it.
      !motion.input.notch_width
        ? [number(now.base_shear_over_weight)]
        : now === practice
          ? [number(felt_of(motion.response)), " the notch included"]
          : range_worst
            ? [number(felt_of(range_worst.response)), " the notch included"]
            : null,
    ),
    row("secant stiffness", ({ secant_stiffness: stiffness, ...now }) =>
      !stiffness
        ? null
        : mass_kg
          ? [number(stiffness * ((mass_kg * gravity_m_per_s2) / length_unit_m), "N/m")]
          : [number(now.base_shear_over_weight / now.restoring_over_weight), " times the spring's"],
    ),
    row("equivalent damping", ({ equivalent_damping: damping }) =>
      damping ? [number(damping, "%"), " of critical"] : null,
    ),
    row("re-centring Eₛ/Eₕ", ({ energy_ratio: ratio }) =>
      ratio ? [number(ratio), " (EN 15129)"] : null,
    ),
    row("re-centring d/dᵣₘ", ({ residual_ratio: ratio }) =>
      ratio ? [number(ratio), " (EN 1998-2)"] : null,
    ),
    row("impulse at a passage", ({ impulse_largest: largest, impulse_at_stop: stop }) =>
      largest > (stop ?? 0) ? ["at most ", ...impulse(largest)] : null,
    ),
    row("impulse at the stop", ({ impulse_at_stop: stop }) => (stop ? impulse(stop) : null)),
  ];
  const shown = shown_words(report);
  // As the program says it: these are not of the notch that will be built.
  const title = !notch_options.some((name) => name in options)
    ? "In practice"
    : `In practice, with a notch that ${"hold" in options ? "holds any load" : "has no width"}`;
  if (!practice_worst) return [sheet_heading(title, shown), sheet_halves(sheet_table(rows))];
  const worst =
    input.v0_range?.[0] === 0
      ? "strongest hit, worst end of the springs"
      : "worst end of the ranges";
  return [sheet_heading(title, ""), sheet_table(rows, ["", shown, worst])];
}

/** How hits of each strength end; if that changes many times, the strengths between which it does. @param {any} report */
function hit_nodes(report) {
  const hits = hits_of(report);
  /** @type {{ ends: string, from: number, to: number | null, count: number }[]} */
  const rows = [];
  hits.forEach(({ ends, from, to: end }, i) => {
    const to = i + 1 < hits.length ? end : null; // the last one has no end but that of the figure
    const same = hits.length > most_keys && rows.find((row) => row.ends === ends);
    if (!same) rows.push({ ends, from, to, count: 1 });
    else Object.assign(same, { to, count: same.count + 1 });
  });
  const table = sheet_table(
    rows.map(({ ends, from, to, count }) => {
      const range = range_parts([from, to], units_of(report.physical).velocity) ?? [];
      const many = count > 1 ? [number(count), " ranges within "] : [];
      return [ends_words[ends] ?? ends, [...many, ...range]];
    }),
  );
  return [
    make("h2", {}, "How the motion ends after other hits"),
    rows.length > most_full_rows ? sheet_halves(table) : table,
  ];
}

/** @param {Sheet} sheet */
function check_nodes({ report }) {
  const nodes = /** @type {Node[]} */ ([]);
  if (report.cross_check) {
    nodes.push(
      sheet_columns(
        ["computed again by", "relative error", "allowed", ""],
        report.cross_check.methods.map((/** @type {any} */ method) => [
          method_words[method.name] ?? method.name,
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
        constraint_words[one.name] ?? one.name,
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
  const { options, command, link, version } = sheet;
  const task = Object.entries(without(options, ["title", ...damper_options]));
  const title = options.title ?? "Damper with constant and point friction";
  const day = new Date().toLocaleDateString("en-GB", {
    day: "numeric",
    month: "long",
    year: "numeric",
  });
  const hits = hit_nodes(sheet.report);
  const ranges = Boolean(sheet.report.practice_worst); // whose figures leave no room for the hits
  fill(
    el("sheet"),
    make(
      "div",
      { class: "leaf" },
      make("h1", {}, title),
      make("p", {}, `Damper specification. ${sheet.report.verdict}`),
      make("h2", {}, "To build"),
      build_rows(sheet),
      make("p", {}, remarks_of(sheet.report)),
      sheet_heading("What it does", shown_words(sheet.report)),
      performance_rows(sheet),
      ...practice_nodes(sheet),
      ...(ranges ? [] : hits),
      make("div", { class: "plates" }, plate_copy("region"), plate_copy("phase")),
    ),
    make(
      "div",
      { class: "leaf" },
      ...(ranges ? hits : []),
      make("h2", {}, "Task"),
      sheet_halves(sheet_table(task.map(([name, value]) => [option_words(name), [value]]))),
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
