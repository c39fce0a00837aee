// SPDX-License-Identifier: MIT
// From the options to what is seen: the engine is asked, and each view shows its part.
"use strict";

/** How much is drawn anew: another hit, another damper, another task. */
const Level = { hit: 1, damper: 2, task: 3 };
const points = 400; // of a motion
const free_points = 160; // of the one without friction
const region_wait = 10; // ms, less than a frame: the region follows a slider
const most_half_cycles = 2000; // that are drawn: each is as wide as a fifth of a pixel

class Bench {
  /** @param {Engine} engine */
  constructor(engine) {
    this.engine = engine;
    /** @type {Options} */
    this.options = {};
    /** @type {number | null} */
    this.hit = null;
    this.frames = new Frames((level) => this.update(level));
    this.record_timer = 0;
    this.finished = false; // the change is one to go back from
    /** @type {string | null} */
    this.refusal = null; // what is wrong with the input
    /** @type {string[]} */
    this.doubts = []; // about it
    this.opened = false;
    this.answered = false; // once
    this.source = ""; // the control that made the change
    this.last_source = "";
    this.last_time = 0;
    /** @type {string[]} */
    this.unknown = [];
    /** @type {any} */ this.design = null;
    this.turn = 0; // of what is asked beside the page
    this.searches = false; // dampers are simulated, so the best one is found only on request
    /** @type {any} */ this.region_found = null; // of a mass that is simulated
    /** @type {Figure | undefined} */ this.region_drawn = undefined; // the same
    this.waits = false; // a mass that is simulated: while a slider moves only its motion follows
    /** @type {any} */ this.judged = null;
    /** @type {string | null} */ this.suite_sheet = null; // under records
    /** @type {any} */ this.motion = null;
    /** @type {{ f: number, delta: number } | null} */ this.damper = null;
    this.tolerance = /** @type {number | null} */ (null);
    this.admissible = false;
    this.answer = new AnswerView(
      (options) => this.go(options),
      () => this.search(),
    );
    this.fields = new Fields(
      (change, done, source) => this.edit(change, done, source ?? ""),
      (kind) => this.choose_load(kind),
    );
    this.beside = new Beside(engine);
    this.region = new RegionView((f, delta, done, source) => this.move(f, delta, done, source));
    this.motion_view = new MotionView();
    this.hits = new HitsView((hit) => this.try_hit(hit));
    this.record = new RecordView(
      () => this.take_records(),
      (name, text) => this.fields.set(name, text),
      () => this.options.record ?? "",
    );
    el("record-design").addEventListener("click", () => this.choose_load(records_kind));
    this.listen();
    this.open();
  }

  listen() {
    const preset = /** @type {HTMLSelectElement} */ (el("preset"));
    preset.append(make("option", { value: "" }, "your own"));
    for (const [name, scene] of Object.entries(scenes)) {
      if (from_scene(scene))
        preset.append(make("option", { value: name }, name.replaceAll("_", " ")));
    }
    preset.addEventListener("change", () => {
      const options = from_scene(scenes[preset.value] ?? {});
      if (options) this.go(options);
    });
    input("dimensionless").addEventListener("change", () => this.turn_units());
    input("spread").addEventListener("input", () => this.frames.ask(Level.damper));
    for (const id of ["set-f", "set-delta"])
      el(id).addEventListener("change", () => this.set_damper());
    el("release").addEventListener("click", () => this.go(without(this.options, damper_options)));
    el("share-link").addEventListener("click", () => {
      share(
        "This state as a link",
        `${location.href.split("#")[0]}#${to_fragment(this.options)}`,
        "stillpoint.url.txt",
      );
    });
    el("share-command").addEventListener("click", () =>
      share("The same digits from the program", this.commands(), "stillpoint.sh"),
    );
    el("share-scene").addEventListener("click", () =>
      share("scene.json", to_scene(this.options), "scene.json"),
    );
    el("print").addEventListener("click", () => print());
    addEventListener("beforeprint", () => this.draw_sheet());
    addEventListener("afterprint", () => this.try_hit(this.hit));
    addEventListener("popstate", () => this.open());
    el("task").addEventListener("submit", (event) => event.preventDefault());
    el("footer").textContent =
      `stillpoint ${this.engine.version}. Everything is computed on this page; nothing is sent or loaded.`;
  }

  /** Shows what the address says. */
  open() {
    const { options, unknown } = from_fragment(location.hash);
    this.unknown = unknown;
    this.hit = null;
    this.opened = true;
    this.source = "";
    this.options = Object.keys(options).length ? options : (from_scene(scenes.isolator) ?? {});
    this.frames.ask(Level.task);
  }

  /** Another state, to which one can go back. @param {Options} options */
  go(options) {
    this.options = options;
    this.hit = null;
    this.unknown = [];
    this.source = "";
    this.finished = true;
    this.frames.ask(Level.task);
  }

  /** Steps of the same control, one close after the other, are one step to go back. */
  remember() {
    const fragment = `#${to_fragment(this.options)}`;
    const now = performance.now();
    const same =
      this.source !== "" && this.source === this.last_source && now - this.last_time < 1000;
    if (fragment === location.hash) return;
    if (same) history.replaceState(null, "", fragment);
    else history.pushState(null, "", fragment);
    this.last_source = this.source;
    this.last_time = now;
  }

  /** @param {(options: Options) => Options} change @param {boolean} done @param {string} source */
  edit(change, done, source) {
    this.options = change(this.options);
    this.source = source;
    this.hit = null;
    this.unknown = [];
    this.finished ||= done;
    this.frames.ask(Level.task);
  }

  /** @param {number} f @param {number} delta @param {boolean} done @param {string} source */
  move(f, delta, done, source) {
    this.source = source;
    this.options = { ...without(this.options, damper_options), f: String(f), delta: String(delta) };
    this.hit = null;
    this.finished ||= done;
    this.frames.ask(Level.damper);
  }

  /** What was typed for the damper: with a unit it is a force, and a length or the energy of a passage. */
  set_damper() {
    const f = input("set-f").value.trim();
    const delta = input("set-delta").value.trim();
    if (!f || !delta) return;
    const friction = /[a-z]\s*$/i.test(f) ? "friction-force" : "f";
    const notch = /[a-zµ]\s*$/i.test(delta) ? "delta-m" : "delta";
    this.go({ ...without(this.options, damper_options), [friction]: f, [notch]: delta });
  }

  /** Another load, about as strong. @param {string} kind */
  choose_load(kind) {
    const { options, design } = this;
    const old = load_of(options);
    if (old === "pulse" && pulse_kinds.includes(kind)) return this.go({ ...options, pulse: kind });
    const rest = without(options, [...load_options, ...damper_options]);
    if (kind === records_kind) {
      return this.go({ ...without(rest, ["arrivals"]), record: this.record.names() });
    }
    const { input, physical } = design ?? { input: { v0: 1, p: 1, beta: 1 } };
    const v0 = old === "record" ? null : input.v0;
    this.go({ ...rest, ...load_like(kind, { input: { ...input, v0 }, physical }) });
  }

  /** The records have changed. */
  take_records() {
    if (load_of(this.options) !== "record") return this.draw_record();
    this.fields.set("record", "");
    this.options = { ...this.options, record: this.record.names() };
  }

  /** @param {number | null} hit */
  try_hit(hit) {
    this.hit = hit;
    this.frames.ask(Level.hit);
  }

  /** The same task with or without units. */
  turn_units() {
    const on = input("dimensionless").checked;
    this.frames.finish(); // what was typed last may be refused
    if (this.refusal !== null || on === !is_physical(this.options)) return;
    const { options, damper } = this;
    const residual = this.region_found?.input.residual || this.design.input.residual;
    const design = { ...this.design, input: { ...this.design.input, residual } };
    this.go(on ? to_plain(options, design, damper) : to_physical(options, design));
  }

  /** @param {number} level */
  update(level) {
    if (this.refusal !== null) level = Level.task; // until it is corrected, whatever changes
    const message = (this.refusal = this.ask(level));
    if (this.finished) this.remember();
    this.finished = false;
    document.body.classList.remove("loading");
    document.body.classList.toggle("stale", message !== null);
    const unknown = this.unknown?.length
      ? `The link has keys that this page does not know: ${this.unknown.join(", ").slice(0, 200)}.`
      : "";
    const doubts = message === null ? this.doubts.map((text) => text.replace("--", "")) : [];
    const notice = [message ?? "", ...doubts, unknown]
      .filter(Boolean)
      .join(". ")
      .replaceAll("?. ", "? ");
    el("notice").hidden = notice === "";
    el("notice").classList.toggle("doubt", message === null);
    if (el("notice").textContent !== notice) el("notice").textContent = notice;
    input("dimensionless").checked = !is_physical(this.options);
    // Its numbers are not known; the times of records are in seconds.
    input("dimensionless").disabled = message !== null || load_of(this.options) === "record";
    const set = damper_options.some((name) => name in this.options);
    /** @type {HTMLButtonElement} */ (el("release")).disabled = !set;
    const under_records = load_of(this.options) === "record";
    const back = this.region_found ? "the middle" : "the best damper";
    write(el("release"), under_records ? "Remove this damper" : `Back to ${back}`);
    document.body.classList.toggle("of-records", under_records);
    this.record.show_list(this.options, under_records);
    el("record-design").hidden = !this.record.list.length || under_records || message !== null;
    if (level === Level.task || message) {
      this.fields.show(this.options, message ? null : this.design);
      this.frames.put_off("preset", () => this.show_preset());
    }
    if (message !== null && !this.answered) {
      el("verdict").textContent = "Nothing is computed until that is corrected.";
      document.body.classList.add("nothing");
    }
    this.fields.blame(message);
    if (message === null) this.show(level);
    this.answered ||= message === null;
  }

  /** Asks the engine; returns what is wrong with the input, or nothing. @param {number} level */
  ask(level) {
    const { engine, options } = this;
    if (level === Level.task) {
      const error = this.ask_task();
      if (error !== null) return error;
    }
    if (load_of(options) === "record") {
      this.judged = this.design;
      this.damper = this.motion = this.suite_sheet = null;
      return null;
    }
    if (level >= Level.damper && !(level === Level.task && this.waits)) {
      this.judged = this.design;
      if (this.region_found) {
        const error = this.judge_simulated();
        if (error) return error;
      } else if (damper_options.some((name) => name in this.options)) {
        const judged = engine.run("region", options_of("region", this.options));
        if ("error" in judged) return judged.error;
        if (has_damper(this.options)) this.judged = judged.report;
      }
      this.take_damper();
    }
    if (!this.damper) {
      this.motion = null;
      return null;
    }
    const run = motion_options(options, this.judged, { ...this.damper, hit: this.hit });
    const motion = engine.run("simulate", run);
    if ("error" in motion) return motion.error;
    this.motion = motion.report;
    return null;
  }

  /** The best damper, or the region where the best is searched on request; returns what is wrong with the input. */
  ask_task() {
    const { engine, options } = this;
    const under_records = load_of(options) === "record";
    this.turn++;
    this.beside.cancel();
    const plain = plain_task(options);
    const asked = under_records ? plain : options_of("design", options);
    const quick = engine.run("design", asked, { quick: true });
    if ("error" in quick) return quick.error;
    const design = quick.searches ? engine.run("design", plain) : quick;
    if ("error" in design) return design.error;
    this.keep_damper(design.report);
    this.design = design.report;
    this.doubts = under_records ? [] : quick.doubts;
    this.searches = under_records || quick.searches === true;
    const simulated = this.searches && !under_records;
    this.waits =
      this.region_found !== null && simulated && this.source.startsWith("slide") && !this.finished;
    if (!this.waits) this.region_found = null;
    if (simulated && !this.waits) {
      const region = engine.run("region", this.task(), { figures: ["region"] });
      if ("error" in region) return region.error;
      this.region_found = region.report;
      this.region_drawn = region.figures[0];
    }
    return null;
  }

  /** The task without a damper. */
  task() {
    return without(options_of("region", this.options), damper_options);
  }

  /** The damper that is set, or one from the middle of the region; returns what is wrong with it. */
  judge_simulated() {
    const { feasible } = this.region_found;
    const middle = feasible?.[feasible.length >> 1];
    this.judged = this.region_found;
    if (!middle && !has_damper(this.options)) return null;
    const damper = has_damper(this.options)
      ? options_of("region", this.options)
      : {
          ...this.task(),
          f: digits(middle.f),
          delta: digits((middle.delta[0] + middle.delta[1]) / 2),
        };
    const judged = this.engine.run("region", damper);
    if ("error" in judged) return judged.error;
    const { report } = judged;
    const { input, physical } = this.design;
    const { v0, p, v0_range, p_range } = input;
    this.judged = {
      ...report,
      input: { ...report.input, v0, p, v0_range, p_range },
      physical: physical && {
        ...physical,
        delta_m: report.design?.delta_m,
        friction_force_n: null,
      },
    };
    return null;
  }

  /** The best damper where dampers are simulated, beside the page. */
  async search() {
    const options = without(this.options, [...damper_options, "search-period"]);
    const found = await this.ask_beside("design", "Searching.", {});
    if (found === undefined) return;
    if (found === null) return this.frames.ask(Level.damper);
    if ("error" in found) return this.refuse(found.error);
    const { design, verdict } = found.report;
    if (!design) return fill(el("verdict"), verdict);
    const damper = /** @type {Options} */ ({ f: String(design.f) });
    if ("search-period" in this.options) damper.period = `${design.period_s}s`;
    if (load_of(options) !== "record" || design.delta_m === null)
      damper.delta = String(design.delta);
    else damper["delta-m"] = String(design.delta_m);
    this.go({ ...options, ...damper });
  }

  /** What the engine beside the page refuses. @param {string} error */
  refuse(error) {
    fill(el("verdict"), error);
    el("verdict").classList.add("broken");
    this.fields.blame(error);
  }

  /** Asks the engine beside the page; until it answers the verdict says how far it is. @param {"design" | "region"} command @param {string} word @param {Ask} ask @returns {Promise<Answer | Refusal | null | undefined>} null: cancelled; undefined: overtaken by another task */
  async ask_beside(command, word, ask) {
    const given = options_of(
      command,
      command === "design" ? without(this.options, damper_options) : this.options,
    );
    const under_records = load_of(given) === "record";
    const { named, files } = under_records ? this.record.given() : { named: {}, files: {} };
    const turn = ++this.turn;
    const cancel = make("button", { type: "button" }, "Cancel");
    cancel.addEventListener("click", () => this.beside.cancel());
    const how_far = make("span", { id: "progress" }, word);
    fill(el("verdict"), how_far, " ", cancel);
    const options = { ...without(given, ["record"]), ...named };
    // The length unit of records is another than that of the hit that stands for them here.
    const unit = this.design.physical?.length_unit_m;
    if (under_records && unit && "delta" in options) {
      options["delta-m"] = String(Number(options.delta) * unit);
      delete options.delta;
    }
    const found = await this.beside.run([command, options, ask, files], (words) =>
      write(how_far, words),
    );
    return turn === this.turn ? found : undefined;
  }

  /** Under records the damper is judged beside the page, and the answer is shown when it comes. */
  async judge_suite() {
    const { record, options } = this;
    const missing = options.record
      ? `A link has only the names and factors of records: drop ${Object.keys(factors_in(options.record)).join(", ")} here again.`
      : "Drop the records that the damper must withstand anywhere on this page.";
    this.answer.show_numbers({ ...this, region: null, chosen: false });
    clear("remarks", "record-figures", "record-answer");
    if (!record.list.length) return fill(el("verdict"), missing);
    if (!has_damper(options)) {
      const many = `${record.list.length} record${record.list.length > 1 ? "s" : ""}: type a damper below, or`;
      return fill(el("verdict"), many, ...this.answer.best());
    }
    const figures = ["worst", "worst-load", "record-1", "record-1-load"];
    const sheet = sheet_of({ ...without(options, ["record"]), ...record.given().named });
    const found = await this.ask_beside("region", "Each record is simulated.", { figures, sheet });
    if (found === undefined) return;
    if (found === null) return fill(el("verdict"), "Cancelled.", ...this.answer.best());
    if ("error" in found) return this.refuse(found.error);
    const { physical, design } = found.report;
    this.judged = {
      ...found.report,
      physical: physical && { ...physical, delta_m: design.delta_m },
    };
    this.suite_sheet = found.sheet ?? null;
    this.take_damper();
    this.answer.show({ ...this, region: null, chosen: true });
    record.show_suite(found);
  }

  /** A damper that is already built keeps its length when the unit of length changes with the task. @param {any} next */
  keep_damper(next) {
    const old = this.design?.physical?.length_unit_m;
    const now = next.physical?.length_unit_m;
    const by_link = this.opened;
    this.opened = false;
    if (by_link || !old || !now || old === now || !("delta" in this.options)) return;
    const delta = (Number(this.options.delta) * old) / now;
    if (Number.isFinite(delta)) this.options = { ...this.options, delta: String(delta) };
  }

  take_damper() {
    const { design, admissible } = this.judged;
    this.damper = design && { f: design.f, delta: design.delta };
    this.tolerance = design?.tolerance ?? null;
    this.admissible = admissible ?? design !== null;
  }

  show_preset() {
    const fragment = to_fragment(this.options);
    const name = Object.keys(scenes).find((key) => {
      const options = from_scene(scenes[key]);
      return options && to_fragment(options) === fragment;
    });
    /** @type {HTMLSelectElement} */ (el("preset")).value = name ?? "";
  }

  /** @param {number} level */
  show(level) {
    const chosen = this.judged !== this.design;
    if (level === Level.task && !this.waits && load_of(this.options) !== "record") {
      const task = this.task();
      const { design } = this;
      this.frames.put_off("region", () => this.draw_region(task, design), region_wait);
      this.frames.put_off("end", () => this.fields.show_end(this.least_stroke()));
    }
    const under_records = load_of(this.options) === "record";
    document.body.classList.toggle("nothing", !this.damper && !under_records);
    write(el("region-heading"), under_records ? "The damper" : "Which dampers work");
    if (under_records) {
      this.motion_view.draw_nothing();
      return this.frames.put_off("suite", () => this.judge_suite());
    }
    if (level >= Level.damper) {
      this.answer.show({ ...this, region: this.region_found, chosen });
    }
    if (!this.damper || !this.motion) return this.show_nothing();
    if (level >= Level.damper) {
      if (level === Level.damper) this.show_damper();
      this.hits.draw(this.judged);
      this.draw_later();
    }
    this.hits.show(this.hit, this.motion, limit_of(this.judged));
    if (level === Level.task) this.frames.put_off("motion", () => this.draw_motion());
    else this.draw_motion();
    if (level >= Level.damper) this.frames.put_off("cloud", () => this.draw_cloud());
  }

  /** The region of a task, and the damper in it. @param {Options} task @param {any} design */
  draw_region(task, design) {
    const region = this.region_found
      ? { figures: this.region_drawn ? [this.region_drawn] : [] }
      : this.engine.run("region", task, { figures: ["region"], report: false });
    if ("error" in region) return fill(el("region"), region.error);
    this.region.draw(region.figures[0], design);
    this.show_damper();
  }

  show_damper() {
    if (!this.damper || !this.motion) return;
    this.region.show({ ...this.damper, tolerance: this.tolerance, admissible: this.admissible });
  }

  draw_cloud() {
    if (!this.motion || !this.damper) return;
    if (this.motion.response.half_cycles > most_half_cycles) return clear("cloud", "cloud-words");
    draw_cloud(this.engine, this.judged, this.damper, this.plain_motion());
  }

  /** The motion shown, dimensionless. @returns {Options} */
  plain_motion() {
    const { notch_width, excitation, ...input } = this.motion.input;
    /** @type {Options} */
    const options = notch_width === null ? {} : { "notch-width": String(notch_width) };
    for (const name of ["v0", "p", "f", "delta", "damping", "breakaway"]) {
      if (name in input) options[name] = String(input[name]);
    }
    if (excitation) {
      delete options.v0;
      options.excitation = excitation.type;
      options.k = String(excitation.k);
      options.lambda = String(excitation.lambda);
    }
    return options;
  }

  /** The stroke below which no damper works, for a task with a far smaller one. */
  least_stroke() {
    if (this.region_found) return null;
    const { physical: units, region: bounds } = this.design;
    const [name, small] = units
      ? ["max-displacement", 0.2 * units.max_displacement_min_m]
      : ["beta", 0.2 * bounds.beta_min];
    const task = without(options_of("region", this.options), damper_options);
    const answer = this.engine.run("region", { ...task, [name]: String(small) });
    if ("error" in answer) return null;
    const { physical, mends } = answer.report;
    if (physical) return physical.max_displacement_mend_m;
    return mends.find((/** @type {any} */ one) => one.input === "beta")?.value ?? null;
  }

  show_nothing() {
    const views = ["cloud", "cloud-words", "hit-words", "hit-key", "lane"];
    clear(...views, "record-figures", "record-answer");
    this.motion_view.draw_nothing();
  }

  draw_motion() {
    if (!this.motion) return;
    const { half_cycles } = this.motion.response;
    if (half_cycles > most_half_cycles)
      return this.motion_view.draw_nothing(
        make("p", {}, "It moves for ", number(half_cycles), " half-cycles, too many to draw."),
      );
    const plain = this.plain_motion();
    const motion = this.engine.motion(plain, points);
    if ("error" in motion) return fill(el("motion"), motion.error);
    const { physical, input: run } = this.motion;
    const end = String(shown_time(motion, run.p));
    const rest = without(plain, ["breakaway", "notch-width"]);
    const alone = { ...rest, f: "0", delta: "0", "t-end": end };
    const free = this.engine.motion(alone, free_points);
    if ("error" in free) return fill(el("motion"), free.error);
    const transmitted = () => {
      const { damper, options, judged, hit } = this;
      if (!damper) return undefined;
      const shown = motion_options(options, judged, { ...damper, hit });
      const drawn = this.engine.run("simulate", shown, { figures: ["transmitted"], report: false });
      return "figures" in drawn ? drawn.figures[0] : undefined;
    };
    this.motion_view.draw({
      motion,
      free,
      load: run.excitation ? transmitted : null,
      p: run.p,
      zeta: run.damping ?? 0,
      f: run.f,
      width: run.notch_width ?? 0,
      limit: limit_of(this.judged) / (physical?.length_unit_m ?? 1),
      units: plot_units(physical),
    });
    this.frames.put_off("portraits", () => this.motion_view.draw_portraits());
  }

  draw_record() {
    if (!this.motion || !this.damper) return;
    const read = without(
      this.options,
      Object.keys(this.options).filter((name) => !["record-units", "record-step"].includes(name)),
    );
    const { excitation, ...damper } = motion_options(this.options, this.judged, {
      ...this.damper,
      hit: 0,
    });
    this.record.show_list(this.options, false);
    el("record-design").hidden = !this.record.list.length;
    this.record.draw(this.engine, { ...damper, ...read });
  }

  /** A record takes longer than a frame, so it waits until the damper stops moving. */
  draw_later() {
    clearTimeout(this.record_timer);
    if (this.record.list.length) this.record_timer = setTimeout(() => this.draw_record(), 120);
  }

  /** With the damper from the middle of the region, where none is set. */
  with_damper() {
    const { options, damper } = this;
    return this.region_found && damper && !has_damper(options)
      ? {
          ...without(options, damper_options),
          f: String(damper.f),
          delta: String(damper.delta),
        }
      : options;
  }

  commands() {
    const { damper } = this;
    const { named, table } = this.record.given();
    const design = without(this.options, damper_options);
    if (load_of(design) === "record") {
      const list =
        table && `printf ${shell_word(table.replaceAll("\n", "\\n"))} > ${record_list}\n`;
      const command = has_damper(this.options) ? "region" : "design";
      const given = { ...without(options_of(command, this.options), ["record"]), ...named };
      return `${list}${command_line(command, given)}\n`;
    }
    const given = this.with_damper();
    if (!has_damper(given)) return command_line("design", options_of("design", design)) + "\n";
    const judged = command_line("region", options_of("region", given));
    const run = damper && motion_options(given, this.judged, { ...damper, hit: null });
    return `${judged}\n${run ? command_line("simulate", run) : ""}\n`;
  }

  /** For the design's hit, whichever is tried. */
  draw_sheet() {
    const tried = this.hit;
    this.try_hit(null);
    this.frames.finish();
    this.hit = tried;
    const sheet = this.refusal === null && this.damper && this.sheet();
    if (sheet) {
      el("sheet").innerHTML = sheet;
      return;
    }
    const words = this.refusal ?? this.judged?.verdict ?? el("verdict").textContent ?? "";
    fill(el("sheet"), make("h1", {}, "No damper"), make("p", {}, words));
  }

  /** The specification of the damper shown; under records it came with its answer. */
  sheet() {
    if (load_of(this.options) === "record") return this.suite_sheet;
    const given = this.with_damper();
    const command = has_damper(given) ? "region" : "design";
    const sheet = sheet_of(given);
    const said = this.engine.run(command, options_of(command, given), { report: false, sheet });
    return "sheet" in said ? said.sheet : null;
  }
}

/** What a specification says of its task. @param {Options} options */
const sheet_of = (options) => ({ title: options.title ?? "", scene: to_scene(options) });

createEngine().then(
  (engine) => {
    document.head.append(make("style", {}, engine.style));
    const bench = new Bench(engine);
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) {
      requestAnimationFrame(() => {
        bench.frames.finish(); // the motion may wait for a frame with time
        bench.motion_view.play();
      });
    }
  },
  (error) => {
    document.body.classList.remove("loading");
    el("notice").hidden = false;
    el("notice").textContent = `This browser cannot run the engine: ${error}`;
  },
);
