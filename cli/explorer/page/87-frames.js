// SPDX-License-Identifier: MIT
// What is drawn when: a frame has first what was changed, and then, while it has time, what follows from it.
"use strict";

const drawing_time = 5; // ms of the 16 that a frame has; style, layout and paint come after it
const longest_wait = 200; // ms for postponed work while each frame has a change

class Frames {
  /** @param {(level: number) => void} draw */
  constructor(draw) {
    this.draw = draw;
    this.level = 0;
    this.requested = false;
    /** @type {Map<string, { work: () => void, since: number, wait: number }>} */
    this.later = new Map();
    /** @type {Map<string, number>} how long each part took when it was drawn last, in ms */
    this.took = new Map();
    this.gave_way = false; // the last frame had no room for the change
  }

  /** Draws at least at this level, once, in the next frame. @param {number} level */
  ask(level) {
    this.level = Math.max(this.level, level);
    this.request();
  }

  /**
   * Draws a part when a frame has time; if requested again, it is drawn only once.
   * @param {string} part @param {() => void} work @param {number} wait in ms, then it goes before a change
   */
  put_off(part, work, wait = longest_wait) {
    const since = this.later.get(part)?.since ?? performance.now();
    this.later.set(part, { work, since, wait });
    this.request();
  }

  request() {
    if (this.requested) return;
    this.requested = true;
    document.body.classList.add("drawing");
    requestAnimationFrame(() => this.frame());
  }

  frame() {
    const start = performance.now();
    this.requested = false;
    // What has waited too long has a frame of its own, every other one at most.
    const [late] =
      (this.level > 0 &&
        !this.gave_way &&
        [...this.later].find(([, { since, wait }]) => start - since >= wait)) ||
      [];
    this.gave_way = late !== undefined;
    const level = late === undefined ? this.level : 0;
    if (late !== undefined) {
      this.draw_part(late);
      this.draw_parts(start, true);
      this.request();
    } else {
      this.level = 0;
      if (level > 0) this.draw(level);
      this.draw_parts(start, level > 0);
    }
    // For the tests and for developers: the last frames, in the browser's own record of times.
    if (performance.getEntriesByName("redraw").length > 500) performance.clearMeasures("redraw");
    performance.measure("redraw", { start, end: performance.now(), detail: level });
    if (this.later.size > 0) this.request();
    if (!this.requested) document.body.classList.remove("drawing");
  }

  /** Those that fit into the frame, by the time that they took last. @param {number} start @param {boolean} drawn */
  draw_parts(start, drawn) {
    for (const part of this.later.keys()) {
      const end = performance.now() + (this.took.get(part) ?? 0);
      if (drawn && end - start > drawing_time) break;
      this.draw_part(part);
      drawn = true;
    }
  }

  /** @param {string} part */
  draw_part(part) {
    const start = performance.now();
    const work = this.later.get(part)?.work;
    this.later.delete(part);
    work?.();
    this.took.set(part, performance.now() - start);
  }

  /** Draws at once what was requested and what was postponed. */
  finish() {
    const level = this.level;
    this.level = 0;
    if (level > 0) this.draw(level);
    for (const part of this.later.keys()) this.draw_part(part);
  }
}
