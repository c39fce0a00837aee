// SPDX-License-Identifier: MIT
// The strip of hits: how each ends for the damper as it is. Its slider tries one.
"use strict";

const most_keys = 8; // there can be a hundred parts

class HitsView {
  /** @param {(hit: number | null) => void} try_hit */
  constructor(try_hit) {
    /** @type {{ from: number, to: number, ends: string }[]} */
    this.hits = [];
    this.most = 1;
    this.unit = "";
    this.what = "hit";
    el("strip").replaceChildren(
      make("div", { class: "lane", id: "lane" }),
      make("input", {
        type: "range",
        id: "hit",
        min: "0",
        max: "2000",
        "aria-label": "strength of the hit to try",
      }),
      make("div", { class: "ends", id: "hit-ends" }),
      make("p", { id: "hit-key" }),
    );
    input("hit").addEventListener("input", () =>
      try_hit((Number(input("hit").value) / 2000) * this.most),
    );
    el("design-hit").addEventListener("click", () => try_hit(null));
  }

  /** @param {any} report with the damper's hits */
  draw(report) {
    const { physical } = report;
    const { pulse } = report.input;
    this.unit = pulse ? "g" : units_of(physical).velocity;
    this.what = pulse ? "pulse" : "hit";
    write(el("hits-heading"), `Other ${pulse ? "pulses" : "hits"} on this damper`);
    write(el("design-hit"), `Back to the design ${this.what}`);
    this.hits = hits_of(report);
    const designed = strengths_of(report);
    this.most = this.hits[this.hits.length - 1]?.to ?? 2 * designed[1]; // none of a simulated mass
    const percent = (/** @type {number} */ value) => `${(100 * value) / this.most}%`;
    const lane = el("lane");
    lane.replaceChildren(
      ...this.hits.map(({ from, to, ends }) => {
        const part = make("div", { class: `part ${ends}` });
        part.style.left = percent(from);
        part.style.width = percent(to - from);
        if (to - from > 0.09 * this.most) part.append(make("span", {}, ends_words[ends] ?? ends));
        part.title = `${ends_words[ends]}: ${digits(from, 3)} to ${words(to, this.unit, 3)}`;
        return part;
      }),
    );
    for (const hit of new Set(designed)) {
      const mark = make("div", { class: "designed" });
      mark.style.left = percent(hit);
      lane.append(mark);
    }
    this.designed = designed[1];
    fill(el("hit-ends"), number(0, this.unit), number(this.most, this.unit));
    fill(el("hit-key"), ...this.keys());
  }

  /** The parts in words, including those too narrow for their names; if there are many, a summary. */
  keys() {
    const named = (/** @type {string} */ ends, /** @type {Part[]} */ ...limit) =>
      key(ends, ends_words[ends] ?? ends, ...limit);
    if (this.hits.length > most_keys)
      return [...new Set(this.hits.map(({ ends }) => ends))].map((ends) => named(ends));
    const last = this.hits.length - 1;
    return this.hits.map(({ to, ends }, i) =>
      i < last
        ? named(ends, " up to ", number(to, this.unit))
        : named(ends, i > 0 ? " beyond" : ""),
    );
  }

  /**
   * Shows which hit is tried, and what the program says of it.
   * @param {number | null} hit @param {any} motion report of simulate @param {number} limit
   */
  show(hit, motion, limit) {
    const value = hit ?? this.designed ?? 0;
    const slider = input("hit");
    write(slider, String(Math.round((2000 * value) / this.most)));
    /** @type {HTMLButtonElement} */ (el("design-hit")).disabled = hit === null;
    slider.setAttribute("aria-valuetext", words(value, this.unit, 4));
    const { peak } = motion_of(motion);
    const { length } = units_of(motion.physical);
    const reached = [": peak ", number(peak, length), " of ", number(limit, length), ". "];
    fill(
      el("hit-words"),
      hit === null ? `The design ${this.what} of ` : `A ${this.what} of `,
      number(value, this.unit),
      ...(motion.response.half_cycles > 0 ? reached : [". "]),
      make("span", { id: "hit-verdict" }, motion.verdict),
    );
  }
}
