// SPDX-License-Identifier: MIT
// Records dropped on the page, each with its factor: the damper under one of them or, if they are the load of the
// task, under all.
"use strict";

const largest_record = 20e6; // bytes; a record of an hour at 200 values a second has 10 MB
const record_list = "records.csv"; // with the factors, as the program reads them

/** @typedef {{ name: string, bytes: Uint8Array, factor: string }} Recorded */

/** The factors of "a.AT2*0.7", a line each. @param {string} listed @returns {Record<string, string>} */
function factors_in(listed) {
  return Object.fromEntries(listed.split("\n").map((line) => line.split("*")));
}

class RecordView {
  /** @param {() => void} changed @param {(name: string, text: string) => void} set an option @param {() => string} listed what names() was */
  constructor(changed, set, listed) {
    this.changed = changed;
    this.listed = listed;
    /** @type {Recorded[]} */
    this.list = [];
    this.chosen = 0;
    input("record-file").addEventListener("change", () =>
      this.take([...(input("record-file").files ?? [])]),
    );
    for (const name of ["record-units", "record-step"]) {
      el(name).addEventListener("change", () => set(name, input(name).value.trim()));
    }
    el("record-away").addEventListener("click", () => this.put([]));
    for (const kind of ["dragover", "dragleave", "drop"]) {
      document.addEventListener(kind, (event) => {
        const files = /** @type {DragEvent} */ (event).dataTransfer;
        if (!files?.types.includes("Files")) return;
        event.preventDefault();
        document.body.classList.toggle("dropping", kind === "dragover");
        if (kind === "drop") this.take([...files.files]);
      });
    }
  }

  /** @param {Recorded[]} list */
  put(list) {
    this.list = list;
    this.chosen = Math.max(0, list.length - 1);
    input("record-file").value = "";
    this.changed();
  }

  /** @param {File[]} files */
  async take(files) {
    const large = files.find(({ size }) => size > largest_record);
    if (large) {
      this.put([]);
      this.refuse(
        `${large.name} has ${digits(large.size / 1e6, 3)} MB; this page reads at most ${largest_record / 1e6} MB. ` +
          `The program reads up to 67 MB: stillpoint simulate --record.`,
      );
      return;
    }
    const factors = factors_in(this.listed());
    const taken = await Promise.all(
      files.map(async (file) => {
        const name = file.name.replace(/[#*,\n"]/g, "_").replace(/^\.*$/, "record");
        const bytes = new Uint8Array(await file.arrayBuffer());
        return { name, bytes, factor: factors[name] ?? "1" };
      }),
    );
    const is_new = (/** @type {Recorded} */ { name }) => !taken.some((one) => one.name === name);
    if (taken.length) this.put([...this.list.filter(is_new), ...taken]);
    el("record-heading").scrollIntoView({ block: "nearest" });
  }

  /** What the link has of them, each with its factor. */
  names() {
    return this.list
      .map(({ name, factor }) => name + (factor === "1" ? "" : `*${factor}`))
      .join("\n");
  }

  /** The options that name them, and their files. */
  given() {
    const files = Object.fromEntries(this.list.map(({ name, bytes }) => [name, bytes]));
    /** @type {Options} */
    const named = { record: this.list.map(({ name }) => name).join("\n") };
    if (this.list.every(({ factor }) => factor === "1")) return { named, files, table: "" };
    const rows = this.list.map(({ name, factor }) => `${name},${factor}\n`);
    const table = `file,scale\n${rows.join("")}`;
    const bytes = new TextEncoder().encode(table);
    return {
      named: /** @type {Options} */ ({ "records-list": record_list }),
      files: { ...files, [record_list]: bytes },
      table,
    };
  }

  /** @param {string} words */
  refuse(words) {
    fill(el("record-answer"), make("p", { class: "bad" }, words));
    clear("record-figures");
  }

  /** @param {Options} options @param {boolean} all the task is for all of them */
  show_list(options, all) {
    el("record-away").hidden = this.list.length === 0;
    for (const name of ["record-units", "record-step"]) {
      if (document.activeElement !== el(name)) input(name).value = options[name] ?? "";
    }
    const rows = this.list.map((record, i) => {
      const factor = make("input", {
        type: "text",
        size: "5",
        "aria-label": `factor of ${record.name}`,
      });
      input_of(factor).value = record.factor;
      factor.addEventListener("change", () => {
        record.factor = input_of(factor).value.trim() || "1";
        this.changed();
      });
      const away = make("button", { type: "button", "aria-label": `Remove ${record.name}` }, "×");
      away.addEventListener("click", () => this.put(this.list.filter((one) => one !== record)));
      const is_shown = all || i === this.chosen;
      const name = is_shown
        ? make("span", {}, record.name)
        : make("button", { type: "button" }, record.name);
      if (!is_shown) {
        name.addEventListener("click", () => {
          this.chosen = i;
          this.changed();
        });
      }
      return make("li", {}, name, make("label", {}, " × ", factor), " ", away);
    });
    const open = document.activeElement?.closest("#record-list");
    if (!open || rows.length !== el("record-list").children.length)
      fill(el("record-list"), ...rows);
  }

  /**
   * @param {Engine} engine
   * @param {Options} damper the options of the motion that is put under the chosen record
   */
  draw(engine, damper) {
    const record = this.list[this.chosen];
    if (!record) return clear("record-answer", "record-figures");
    const { name, bytes, factor } = record;
    const left_out = names_where(({ load }) => load === "hit" || load === "pulse");
    const options = /** @type {Options} */ ({
      ...without(damper, [...left_out, "excitation"]),
      record: name,
      ...(factor === "1" ? {} : { "record-scale": factor }),
    });
    const figures = ["motion", "excitation"];
    const answer = engine.run("simulate", options, { figures }, { [name]: bytes });
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
      ...this.said(report),
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
    this.show_figures(figures);
  }

  /** The verdict and what is to be known besides. @param {any} report */
  said(report) {
    return [
      make("p", { id: "record-verdict", class: alarms_of(report) ? "bad" : "" }, report.verdict),
      ...report.findings.map((/** @type {any} */ now) =>
        make("p", { class: now.severity }, now.text),
      ),
    ];
  }

  /** A damper under all of them: a row for each, with the largest of each column in bold. @param {Answer} answer */
  show_suite({ report, figures, doubts }) {
    const [{ motions, worst }] = report.cases;
    const { length } = units_of(report.physical);
    const figure = (/** @type {any} */ of, /** @type {string} */ name) => of[name];
    const columns = /** @type {[string, string, string, string][]} */ ([
      ["peak", length ? "peak_m" : "peak_amplitude", length, "peak_amplitude"],
      ["residual", length ? "final_position_m" : "final_position", length, "residual"],
      ["transmitted", felt_name, "g", felt_name],
    ]);
    const head = ["record", "factor", "largest load", ...columns.map(([title]) => title)];
    const rows = motions.map((/** @type {any} */ motion) => {
      const cells = columns.map(([, name, unit, of]) => {
        const value = figure(motion.physical ?? {}, name) ?? motion.response[name];
        const governs = worst?.of?.[of]?.motion === motion.what;
        return make("td", governs ? { class: "governs" } : {}, number(Math.abs(value), unit));
      });
      const plain = [number(motion.scale), number(motion.pga, "g")].map((node) =>
        make("td", {}, node),
      );
      return make("tr", {}, make("th", {}, motion.what), ...plain, ...cells);
    });
    const title = make("tr", {}, ...head.map((text) => make("th", {}, text)));
    fill(
      el("record-answer"),
      make("table", {}, title, ...rows),
      make(
        "p",
        { class: "faint" },
        "Of the damper itself; in bold what governs within the tolerance.",
      ),
      ...doubts.map((text) => make("p", { class: "bad" }, text.replace("--", ""))),
    );
    this.show_figures(figures);
  }

  /** @param {Figure[]} figures */
  show_figures(figures) {
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
