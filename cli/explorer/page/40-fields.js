// SPDX-License-Identifier: MIT
// The task: a slider and a text field for each input. The engine reads the text, unit and all; the
// sliders only write it.
"use strict";

class Fields {
  /**
   * @param {(change: (options: Options) => Options, done: boolean, source?: string) => void} edit
   */
  constructor(edit) {
    this.edit = edit;
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
    const shape = `${physical} ${notch}`;
    if (shape !== this.shape) this.build(physical, notch);
    this.shape = shape;
    for (const field of this.list) this.show_field(field, options, report);
    this.show_extras(options);
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

  /** @param {boolean} physical @param {string} notch */
  build(physical, notch) {
    this.list = [...(physical ? physical_fields : dimensionless_fields)];
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
    el("fields").replaceChildren(...nodes);
    if (focused) document.getElementById(focused)?.focus();
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
    if (stroke) slide.append(make("div", { class: "barred", id: "barred" }));
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
    // A frequency in the field of the period is the natural frequency.
    const name = field.name === "period" && /hz$/i.test(value) ? "natural-frequency" : field.name;
    this.edit((options) => {
      const rest = without(options, [field.name, ...rivals(name)]);
      return value === "" ? rest : { ...rest, [name]: value };
    }, true);
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
    const { name } = field;
    const text = input(`in-${name}`);
    const own = [name, ...rivals(name)].find((key) => key in options);
    const values = report ? field.read(report) : [];
    if (document.activeElement !== text || text.getAttribute("aria-invalid") !== "true") {
      write(text, own ? options[own] : name === "arrivals" ? "1" : "");
    }
    text.placeholder = own ? "" : name === "mass" ? "none" : "0";
    const parsed =
      values.length || !unreturned.includes(name) ? values : [this.number_of(options[name])];
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
    const in_one_metre = /** @type {Record<string, number>} */ ({ mm: 1000, cm: 100 });
    return value / (in_one_metre[text.match(/[a-z]+$/)?.[0] ?? ""] ?? 1);
  }

  /** Where designs end, on the slider of the stroke. @param {number | null} least */
  show_end(least) {
    const bar = document.getElementById("barred");
    const field = this.list.find(({ stroke }) => stroke);
    if (!bar || !field) return;
    const at = least ? slider_place(field, least) : 0;
    bar.style.width = `${100 * at}%`;
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
  }

  /** Options without a field of their own, each to be removed. @param {Options} options */
  show_extras(options) {
    const shown = [
      ...this.list.flatMap(({ name }) => [name, ...rivals(name)]),
      ...damper_options,
      ...notch_options,
      "title",
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
