// SPDX-License-Identifier: MIT
// A record dropped on the page: the damper under it.
"use strict";

const largest_record = 20e6; // bytes; a record of an hour at 200 values a second has 10 MB

class RecordView {
  /** @param {() => void} changed */
  constructor(changed) {
    this.changed = changed;
    /** @type {{ name: string, bytes: Uint8Array } | null} */
    this.record = null;
    input("record-file").addEventListener("change", () =>
      this.take(input("record-file").files?.[0]),
    );
    for (const id of ["record-units", "record-step"]) el(id).addEventListener("change", changed);
    el("record-away").addEventListener("click", () => {
      this.record = null;
      input("record-file").value = "";
      changed();
    });
    for (const kind of ["dragover", "dragleave", "drop"]) {
      document.addEventListener(kind, (event) => {
        const files = /** @type {DragEvent} */ (event).dataTransfer;
        if (!files?.types.includes("Files")) return;
        event.preventDefault();
        document.body.classList.toggle("dropping", kind === "dragover");
        if (kind === "drop") this.take(files.files[0]);
      });
    }
  }

  /** @param {File | undefined} file */
  async take(file) {
    if (!file) return;
    if (file.size > largest_record) {
      this.record = null;
      this.changed();
      this.refuse(
        `${file.name} has ${digits(file.size / 1e6, 3)} MB; this page reads at most ${largest_record / 1e6} MB. ` +
          `The program reads up to 67 MB: stillpoint simulate --record.`,
      );
      return;
    }
    this.record = {
      name: file.name.replace(/[#,]/g, "_").replace(/^\.*$/, "record"),
      bytes: new Uint8Array(await file.arrayBuffer()),
    };
    this.changed();
    el("record-heading").scrollIntoView({ block: "nearest" });
  }

  /** @param {string} words */
  refuse(words) {
    fill(el("record-answer"), make("p", { class: "bad" }, words));
    clear("record-figures");
  }

  /**
   * @param {Engine} engine
   * @param {Options} damper the options of the motion that it is put under the record
   */
  draw(engine, damper) {
    el("record-away").hidden = this.record === null;
    if (!this.record) {
      return clear("record-answer", "record-figures");
    }
    const { name, bytes } = this.record;
    /** @type {Options} */
    const options = { ...without(damper, ["velocity", "v0"]), record: name };
    const units = /** @type {HTMLSelectElement} */ (el("record-units"));
    if (units.selectedIndex > 0) options["record-units"] = units.value;
    if (input("record-step").value.trim())
      options["record-step"] = input("record-step").value.trim();
    const answer = engine.run(
      "simulate",
      options,
      { figures: ["motion", "excitation"] },
      { [name]: bytes },
    );
    if ("error" in answer) return this.refuse(answer.error);
    this.show(name, answer);
  }

  /** @param {string} name @param {Answer} answer */
  show(name, { report, figures, doubts }) {
    const { response, physical } = report;
    const { length, time } = units_of(physical);
    const { peak, acceleration } = motion_of(report);
    const load = report.input.excitation;
    const value = (/** @type {string} */ of_physical, /** @type {string} */ plain) =>
      physical ? physical[of_physical] : response[plain];
    const fact = (
      /** @type {string} */ title,
      /** @type {Node} */ node,
      /** @type {string} */ id,
    ) => {
      if (node instanceof HTMLElement) node.id = id;
      return make("div", {}, make("dt", {}, title), make("dd", {}, node));
    };
    const locked = value("locked_from_s", "locked_from");
    fill(
      el("record-answer"),
      make("p", { id: "record-verdict", class: alarms_of(report) ? "bad" : "" }, report.verdict),
      ...report.findings.map((/** @type {any} */ now) =>
        make("p", { class: now.severity }, now.text),
      ),
      make(
        "dl",
        { class: "facts" },
        fact("peak", number(peak, length), "record-peak"),
        fact("transmitted", number(acceleration, "g"), "record-acceleration"),
        fact(
          locked !== null && locked !== undefined
            ? "locked from"
            : response.peak_amplitude === 0
              ? "held throughout"
              : "not locked at the end",
          number(locked, time),
          "record-locked",
        ),
        fact(
          "residual",
          number(value("final_position_m", "final_position"), length),
          "record-residual",
        ),
      ),
      make(
        "p",
        { class: "faint" },
        `${name}: `,
        number(load.samples),
        ` values in ${load.record_units_read}${load.record_units_assumed ? " (assumed)" : ""}; the largest load is `,
        number(load.pga, "g"),
        ".",
      ),
      ...doubts.map((text) => make("p", { class: "bad" }, text.replace("--", ""))),
    );
    const plates = figures.map((figure) => {
      const plate = make("div", { class: "plate" });
      put_figure(plate, {
        ...figure,
        svg: figure.svg.replaceAll(`${figure.id}-`, `record-${figure.id}-`),
      });
      return plate;
    });
    el("record-figures").replaceChildren(...plates);
  }
}
