// SPDX-License-Identifier: MIT
// The answer in words and numbers.
"use strict";

/**
 * @typedef {object} Answered
 * @property {any} design report of the task's best damper
 * @property {any} region report of that of a mass which is simulated; else null
 * @property {boolean} searches the best damper is searched when it is asked for
 * @property {any} judged report of the damper that is shown
 * @property {any} motion its motion
 * @property {{ f: number, delta: number } | null} damper
 * @property {number | null} tolerance
 * @property {boolean} chosen the damper was set by hand
 * @property {Options} options
 */

class AnswerView {
  /** @param {(options: Options) => void} go @param {() => void} search where dampers are simulated */
  constructor(go, search) {
    this.go = go;
    this.search = search;
  }

  /** @param {Answered} shown */
  show(shown) {
    this.show_numbers(shown);
    this.show_verdict(shown);
  }

  /** @param {Answered} shown */
  show_numbers({ motion, damper, judged, tolerance, chosen, options }) {
    const { physical } = judged;
    const { length, time } = units_of(physical);
    // The design's own numbers are those of its report.
    const suite = judged.cases?.[0].worst && !motion;
    const shown = suite ? judged : chosen ? motion : judged.design && judged;
    const of_motion = shown && (suite ? suite_of(judged) : motion_of(shown));
    show(el("f"), damper?.f);
    show(el("delta"), physical ? physical.delta_m : damper?.delta, length);
    show(el("tolerance"), tolerance, "%", "±");
    show(el("peak"), of_motion?.peak, length);
    show(el("stop-time"), of_motion?.stop_time, time);
    show(el("acceleration"), of_motion?.acceleration, "g");
    write(el("acceleration-sub"), of_motion?.felt ?? "");
    const { friction_force_n: force, energy_per_passage_j: energy } =
      motion?.physical ?? physical ?? {};
    fill(el("f-sub"), ...(force ? [number(force, "N")] : []));
    const plain = ["dimensionless ", number(damper?.delta)];
    fill(
      el("delta-sub"),
      ...(energy ? [number(energy, "J"), " a passage, "] : []),
      ...(physical && damper ? plain : []),
    );
    const limit = limit_of(judged);
    fill(
      el("peak-sub"),
      ...(shown && limit
        ? [number(of_motion.peak / limit, "%"), " of ", number(limit, length)]
        : []),
    );
    const rest = of_motion?.rest;
    const built_rest = motion?.input.notch_width ? motion_of(motion).rest : null;
    const at = suite
      ? ["residual ", number(rest, length)]
      : rest === 0
        ? ["at x = 0"]
        : typeof rest === "number"
          ? ["at x = ", number(rest, length)]
          : [];
    const as_built =
      typeof built_rest === "number" && !chosen
        ? ["; as built at ", number(built_rest, length)]
        : [];
    fill(el("rest-sub"), ...at, ...as_built);
    for (const [id, value] of /** @type {const} */ ([
      ["set-f", damper?.f],
      ["set-delta", damper && physical ? physical.delta_m * 1000 : damper?.delta],
    ])) {
      if (document.activeElement === el(id)) continue;
      const typed = id === "set-f" ? options["friction-force"] : options["delta-m"];
      input(id).value =
        value === undefined
          ? ""
          : /[NJbpnt]$/.test(typed ?? "")
            ? typed
            : digits(value, 6) + (id === "set-delta" && physical ? "mm" : "");
    }
  }

  /** In the program's words. @param {Answered} shown */
  show_verdict({ design, region, searches, judged, damper, options }) {
    const report = damper ? judged : (region ?? design);
    const alarms = alarms_of(report);
    const more = searches ? this.best() : damper ? [] : this.mends(design, options);
    fill(el("verdict"), report.verdict, ...more);
    el("verdict").classList.toggle("broken", alarms);
    el("remarks").classList.toggle("broken", alarms);
    fill(el("remarks"), remarks_of(report), ...this.smaller(report, options));
  }

  /** The bound of Delta that the program proposes where nothing else bounds it. @param {any} report @param {Options} options @returns {Part[]} */
  smaller({ findings }, options) {
    const found = findings.find((/** @type {any} */ now) => now.kind === "delta_unbounded");
    if (!found) return [];
    const in_metres = is_physical(options);
    const value = Number((in_metres ? found.proposed_m : found.proposed).toPrecision(3));
    const unit = in_metres ? "m" : "";
    const button = make("button", { type: "button" }, "Use a delta max of ", number(value, unit));
    const name = in_metres ? "delta-max-m" : "delta-max";
    button.addEventListener("click", () => this.go({ ...options, [name]: `${value}${unit}` }));
    return [" ", button];
  }

  /** @returns {Part[]} */
  best() {
    const button = make("button", { type: "button" }, "Search the best damper (some seconds)");
    button.addEventListener("click", () => this.search());
    return [" ", button];
  }

  /** What would make it feasible, each to be applied. @param {any} design @param {Options} options @returns {Part[]} */
  mends({ mends, physical }, options) {
    const buttons = /** @type {Part[]} */ ([]);
    const offer = (
      /** @type {string} */ name,
      /** @type {number | null} */ value,
      /** @type {string} */ unit,
      /** @type {string} */ title,
    ) => {
      if (
        value === null ||
        value === undefined ||
        !(name in options) ||
        options[name].includes(":")
      )
        return;
      // On the edge itself only one damper is left, without any tolerance: a fiftieth beyond it, there are more.
      const least = ["max-displacement", "beta", "p", "lambda"].includes(name);
      const better = Number((value * (least ? 1.02 : 0.98)).toPrecision(3));
      const button = make("button", { type: "button" }, `${title} `, number(better, unit));
      button.addEventListener("click", () => this.go({ ...options, [name]: `${better}${unit}` }));
      buttons.push(" ", button);
    };
    if (physical) {
      offer("max-displacement", physical.max_displacement_mend_m, "m", "Use a limit of");
      offer("velocity", physical.velocity_mend_m_per_s, "m/s", "a hit of");
      offer("period", physical.period_mend_s, "s", "a period of");
    }
    const names = {
      beta: "Use a limit of",
      v0: "a hit of",
      k: "a peak of",
      p: "p =",
      lambda: "λ =",
    };
    for (const [name, title] of Object.entries(names)) {
      const { value } = mends.find((/** @type {any} */ one) => one.input === name) ?? {};
      if (!physical || name === "k") offer(name, value, name === "k" ? "g" : "", title);
    }
    return buttons;
  }
}
