// SPDX-License-Identifier: MIT
// The task: a slider and a text field for each input. The engine reads the text, unit and all; the
// sliders only write it.
"use strict";

class Fields {
  /**
   * @param {(change: (options: Options) => Options, done: boolean, source?: string) => void} edit
   * @param {(kind: string) => void} choose_load
   */
  constructor(edit, choose_load) {
    this.edit = edit;
    this.choose_load = choose_load;
    /** @type {OptionRow[]} */
    this.limits = [];
    /** @type {Field[]} */
    this.list = [];
    this.shape = "";
  }

  /**
   * Shows these options; the report, if there is one, gives their values.
   * @param {Options} options
   * @param {any} report
   */
  show(options, report) {
    const physical = is_physical(options);
    const notch = this.notch_of(options);
    const load = load_of(options);
    const shape = `${physical} ${notch} ${load}`;
    if (shape !== this.shape) {
      this.build(physical, notch, load);
      this.build_limits(options);
    }
    this.shape = shape;
    for (const field of this.list) this.show_field(field, options, report);
    input("load-kind").value =
      load === "hit" ? load : load === "pulse" ? options.pulse : records_kind;
    this.show_limits(options);
    this.show_extras(options);
  }

  /** A text, or a choice, for each requirement that the option table has of them. @param {Options} options */
  build_limits(options) {
    this.limits = requirements_of(options);
    const nodes = this.limits.map(({ name, help, values, unit }) => {
      const own = { id: `in-${name}` };
      const control = values.length
        ? make(
            "select",
            own,
            ...["", ...values].map((value) => make("option", { value }, value || "as usual")),
          )
        : make("input", { type: "text", spellcheck: "false", placeholder: unit || "none", ...own });
      control.addEventListener("change", () => this.set(name, input_of(control).value.trim()));
      const label = make("label", { for: own.id }, option_words(name));
      return make(
        "div",
        { class: "field", title: help },
        make("div", { class: "top" }, label, control),
        make("div", { class: "hint", id: `hint-${name}` }),
      );
    });
    fill(el("limits"), ...nodes);
  }

  /** @param {Options} options */
  show_limits(options) {
    for (const { name, values, unit } of this.limits) {
      const control = input(`in-${name}`);
      const value = options[name] ?? "";
      if (document.activeElement !== control || control.getAttribute("aria-invalid") !== "true") {
        if (values.length) control.value = value;
        else write(control, value);
      }
      const number = unit || !values.length ? this.number_of(value) : null;
      if (number === null) delete control.dataset.value;
      else control.dataset.value = String(number);
    }
    const count = this.limits.filter(({ name }) => name in options).length;
    write(el("limits-title"), count ? `Requirements (${count})` : "Requirements");
  }

  /** @param {string} name @param {string} value empty: without it */
  set(name, value) {
    this.edit((options) => {
      const rest = without(options, [name, ...rivals(name)]);
      return value === "" ? rest : { ...rest, [name]: value };
    }, true);
  }

  /** @param {Options} options */
  notch_of(options) {
    const [none, width, hold] = Object.keys(notch_fields);
    return "hold" in options
      ? hold
      : "notch-width" in options || "notch-width-m" in options
        ? width
        : none;
  }

  /** @param {boolean} physical @param {string} notch @param {string} load */
  build(physical, notch, load) {
    const own = physical ? physical_fields : dimensionless_fields;
    const rest = load === "record" ? own.filter((one) => one !== arrivals) : own;
    const before = rest.findIndex((one) => one.stroke);
    const of_load = load_fields[load](physical);
    this.list = [...rest.slice(0, before), ...of_load, ...rest.slice(before)];
    const focused = document.activeElement?.id;
    const kind = make("select", { id: "notch-kind" });
    for (const name of Object.keys(notch_fields)) {
      kind.append(make("option", name === notch ? { selected: "" } : {}, name));
    }
    kind.addEventListener("change", () => {
      const chosen = notch_fields[/** @type {HTMLSelectElement} */ (kind).value](physical);
      const start = chosen && slider_text(chosen, chosen.most / 5);
      this.edit((options) => {
        const rest = without(options, notch_options);
        return chosen && start ? { ...rest, [chosen.name]: start } : rest;
      }, true);
    });
    const notch_field = notch_fields[notch](physical);
    if (notch_field) this.list.push(notch_field);
    const nodes = this.list.map((field) => this.build_field(field));
    const chooser = make(
      "div",
      { class: "field" },
      make("div", { class: "top" }, make("label", { for: "notch-kind" }, "notch"), kind),
    );
    nodes.splice(notch_field ? -1 : nodes.length, 0, chooser);
    nodes.splice(before, 0, this.build_load());
    el("fields").replaceChildren(...nodes);
    if (focused) document.getElementById(focused)?.focus();
  }

  build_load() {
    const kinds = ["hit", ...pulse_kinds, records_kind];
    const words = (/** @type {string} */ kind) =>
      pulse_kinds.includes(kind) ? `${kind} pulse` : kind;
    const chooser = make(
      "select",
      { id: "load-kind" },
      ...kinds.map((kind) => make("option", { value: kind }, words(kind))),
    );
    chooser.addEventListener("change", () => this.choose_load(input_of(chooser).value));
    const label = make("label", { for: "load-kind" }, "load");
    return make("div", { class: "field" }, make("div", { class: "top" }, label, chooser));
  }

  /** @param {Field} field */
  build_field(field) {
    const { name, label, two, stroke } = field;
    const text = make("input", {
      type: "text",
      id: `in-${name}`,
      spellcheck: "false",
      class: two ? "two" : "",
    });
    const typed = /** @type {HTMLInputElement} */ (text);
    text.addEventListener("change", () => this.type(field, typed.value.trim()));
    const slide = make("div", { class: "slide" });
    if (two) slide.append(make("div", { class: "rail" }));
    for (const end of two ? ["low", "high"] : ["low"]) {
      const slider = make("input", {
        type: "range",
        id: `slide-${name}-${end}`,
        class: two ? `${end} two` : end,
        min: "0",
        value: "0",
        max: name === "arrivals" ? String(field.most - field.least) : String(slider_steps),
        "aria-label": two ? `${label}, ${end === "low" ? "weakest" : "strongest"}` : label,
      });
      if (two && end === "low") slider.setAttribute("title", "drag it away for a range of hits");
      slider.addEventListener("input", () => this.slid(field, end, false));
      slider.addEventListener("change", () => this.slid(field, end, true));
      slide.append(slider);
    }
    if (stroke) slide.append(make("div", { class: "barred", id: "barred", hidden: "" }));
    return make(
      "div",
      { class: "field" },
      make("div", { class: "top" }, make("label", { for: `in-${name}` }, label), text),
      slide,
      make("div", { class: "hint", id: `hint-${name}` }),
    );
  }

  /** @param {Field} field @param {string} value */
  type(field, value) {
    // A frequency in the field of a time is that of its motion.
    const frequency = /hz$/i.test(value)
      ? { period: "natural-frequency", "pulse-duration": "excitation-frequency" }[field.name]
      : undefined;
    this.set(frequency ?? field.name, value);
  }

  /** @param {Field} field @param {string} end @param {boolean} done */
  slid(field, end, done) {
    const place = (/** @type {string} */ id) => {
      const slider = input(`slide-${field.name}-${id}`);
      return Number(slider.value) / Number(slider.max);
    };
    const one = (/** @type {string} */ id) => slider_text(field, slider_value(field, place(id)));
    this.edit(
      (options) => {
        const rest = without(options, [field.name, ...rivals(field.name)]);
        if (field.absent_at_least && place("low") === 0) return rest;
        if (!field.two) return { ...rest, [field.name]: one("low") };
        // Two handles at the same place move together, unless the lower one is dragged down.
        const was_range = (options[field.name] ?? "").includes(":");
        if (!was_range && end === "high") return { ...rest, [field.name]: one("high") };
        const low = Math.min(place("low"), place("high"));
        const high = Math.max(place("low"), place("high"));
        const text = (/** @type {number} */ at) => slider_text(field, slider_value(field, at));
        const value = low === high ? text(high) : `${text(low)}:${text(high)}`;
        return { ...rest, [field.name]: value };
      },
      done,
      `slide ${field.name}`,
    );
  }

  /** @param {Field} field @param {Options} options @param {any} report */
  show_field(field, options, report) {
    const { name, two } = field;
    const text = input(`in-${name}`);
    const own = [name, ...rivals(name)].find((key) => key in options);
    const values = (report ? field.read(report) : []).filter((one) => one !== null);
    if (document.activeElement !== text || text.getAttribute("aria-invalid") !== "true") {
      write(text, own ? options[own] : name === "arrivals" ? "1" : "");
    }
    text.placeholder = own ? "" : name === "mass" ? "none" : "0";
    // Of a mass that is simulated the report is that of a task without some.
    const given = own === name && load_of(options) !== "hit" ? this.number_of(options[name]) : null;
    const parsed =
      given !== null && !two
        ? [given]
        : values.length || !unreturned.includes(name)
          ? values
          : [this.number_of(options[name])];
    const [low, high] = [parsed[0], parsed[parsed.length - 1]];
    if (high !== null && high !== undefined && Number.isFinite(high)) {
      text.dataset.value = String(high);
    } else {
      delete text.dataset.value;
    }
    for (const [id, value] of /** @type {const} */ ([
      ["low", low],
      ["high", high],
    ])) {
      const slider = document.getElementById(`slide-${name}-${id}`);
      if (!(slider instanceof HTMLInputElement) || value === null || value === undefined) continue;
      if (document.activeElement !== slider) {
        write(slider, String(Math.round(slider_place(field, value) * Number(slider.max))));
      }
      slider.setAttribute("aria-valuetext", words(value, field.unit, 4));
    }
    if (field.stroke) return; // show_end has its hint
    write(
      el(`hint-${name}`),
      own && own !== name
        ? `given as the ${option_words(own)}`
        : name === "hold"
          ? "acts under a record; a hit is the same without it"
          : "",
    );
  }

  /** For a field that no report returns: in metres, or as given. @param {string | undefined} text */
  number_of(text = "") {
    const value = parseFloat(text);
    if (Number.isNaN(value)) return null;
    const in_one = /** @type {Record<string, number>} */ ({
      mm: 1000,
      cm: 100,
      ms: 1000,
      t: 1e-3,
      kN: 1e-3,
    });
    return value / (in_one[text.match(/[a-zA-Z%]+$/)?.[0] ?? ""] ?? 1);
  }

  /** Where designs end, on the slider of the stroke. @param {number | null} least */
  show_end(least) {
    const bar = document.getElementById("barred");
    const field = this.list.find(({ stroke }) => stroke);
    if (!bar || !field) return;
    const at = least ? slider_place(field, least) : 0;
    bar.style.width = `${100 * at}%`;
    bar.hidden = at === 0;
    const hint = el(`hint-${field.name}`);
    if (least) fill(hint, "designs end at ", number(least, field.unit));
    else hint.textContent = "";
  }

  /** Marks the field that a message is about. @param {string | null} message */
  blame(message) {
    const about = message?.match(/^(?:--)?([a-z0-9-]+)/i)?.[1];
    for (const { name } of this.list) {
      const wrong = about === name || (about !== undefined && rivals(name).includes(about));
      input(`in-${name}`).toggleAttribute("aria-invalid", false);
      if (wrong) input(`in-${name}`).setAttribute("aria-invalid", "true");
    }
    for (const { name } of this.limits) {
      const wrong = about === name;
      input(`in-${name}`).toggleAttribute("aria-invalid", false);
      if (wrong) input(`in-${name}`).setAttribute("aria-invalid", "true");
      write(el(`hint-${name}`), wrong && message ? message : "");
      if (wrong) el("requirements").setAttribute("open", "");
    }
  }

  /** Options without a field of their own, each to be removed. @param {Options} options */
  show_extras(options) {
    const shown = [
      ...this.list.flatMap(({ name }) => [name, ...rivals(name)]),
      ...this.limits.map(({ name }) => name),
      ...damper_options,
      ...notch_options,
      ...["title", "pulse", "record", "record-units", "record-step"],
    ];
    const chips = Object.keys(options)
      .filter((name) => !shown.includes(name))
      .map((name) => {
        const chip = make("button", { type: "button" }, `${option_words(name)} ${options[name]} ×`);
        chip.setAttribute("aria-label", `Remove ${name} ${options[name]}`);
        chip.addEventListener("click", () => this.edit((all) => without(all, [name]), true));
        return chip;
      });
    el("extras").replaceChildren(...chips);
  }
}
