// SPDX-License-Identifier: MIT
// The answer in words and numbers.
"use strict";

/**
 * @typedef {object} Answered
 * @property {any} design report of the task's best damper
 * @property {any} region report of that of a mass which is simulated; else null
 * @property {any} judged report of the damper that is shown
 * @property {any} motion its motion
 * @property {{ f: number, delta: number } | null} damper
 * @property {number | null} tolerance
 * @property {boolean} chosen the damper was set by hand
 * @property {Options} options
 */

class AnswerView {
  /** @param {(options: Options) => void} go @param {() => void} search of a mass that is simulated */
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
  show_numbers({ motion, damper, judged, tolerance, chosen }) {
    const { physical } = judged;
    const { length, time } = units_of(physical);
    // The design's own numbers are those of its report.
    const shown = chosen ? motion : judged.design && judged;
    const of_motion = shown && motion_of(shown);
    show(el("f"), damper?.f);
    show(el("delta"), physical ? physical.delta_m : damper?.delta, length);
    show(el("tolerance"), tolerance, "%", "±");
    show(el("peak"), of_motion?.peak, length);
    show(el("stop-time"), of_motion?.stop_time, time);
    show(el("acceleration"), of_motion?.acceleration, "g");
    write(el("acceleration-sub"), of_motion?.felt ?? "");
    const force = physical?.friction_force_n;
    fill(el("f-sub"), ...(force ? [number(force, "N")] : []));
    fill(el("delta-sub"), ...(physical && damper ? ["dimensionless ", number(damper.delta)] : []));
    const peak = shown && response_of(shown).peak_amplitude;
    fill(
      el("peak-sub"),
      ...(shown
        ? [number(peak / judged.input.beta, "%"), " of ", number(limit_of(judged), length)]
        : []),
    );
    const rest = of_motion?.rest;
    const built_rest = motion?.input.notch_width ? motion_of(motion).rest : null;
    const at =
      rest === 0 ? ["at x = 0"] : typeof rest === "number" ? ["at x = ", number(rest, length)] : [];
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
      input(id).value =
        value === undefined ? "" : digits(value, 6) + (id === "set-delta" && physical ? "mm" : "");
    }
  }

  /** In the program's words. @param {Answered} shown */
  show_verdict({ design, region, judged, damper, options }) {
    const report = damper ? judged : (region ?? design);
    const alarms = alarms_of(report);
    const more = region ? this.best() : damper ? [] : this.mends(design, options);
    fill(el("verdict"), report.verdict, ...more);
    el("verdict").classList.toggle("broken", alarms);
    el("remarks").classList.toggle("broken", alarms);
    write(el("remarks"), remarks_of(report));
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
      const least = name === "max-displacement" || name === "beta" || name === "p";
      const better = Number((value * (least ? 1.02 : 0.98)).toPrecision(3));
      const button = make("button", { type: "button" }, `${title} `, number(better, unit));
      button.addEventListener("click", () => this.go({ ...options, [name]: `${better}${unit}` }));
      buttons.push(" ", button);
    };
    if (physical) {
      offer("max-displacement", physical.max_displacement_mend_m, "m", "Use a limit of");
      offer("velocity", physical.velocity_mend_m_per_s, "m/s", "a hit of");
      offer("period", physical.period_mend_s, "s", "a period of");
    } else {
      const names = { beta: "Use a limit of", v0: "a hit of", p: "p =" };
      for (const [name, title] of Object.entries(names)) {
        offer(name, mends.find((/** @type {any} */ one) => one.input === name)?.value, "", title);
      }
    }
    return buttons;
  }
}
