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
    /** @type {Map<string, { work: () => void, since: number }>} */
    this.later = new Map();
  }

  /** Draws at least at this level, once, in the next frame. @param {number} level */
  ask(level) {
    this.level = Math.max(this.level, level);
    this.request();
  }

  /** Draws a part when a frame has time; if requested again, it is drawn only once. @param {string} part @param {() => void} work */
  put_off(part, work) {
    this.later.set(part, { work, since: this.later.get(part)?.since ?? performance.now() });
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
    const level = this.level;
    this.level = 0;
    this.requested = false;
    if (level > 0) this.draw(level);
    let drawn = level > 0;
    for (const [part, { work, since }] of this.later) {
      const now = performance.now();
      if (drawn && now - start > drawing_time && now - since < longest_wait) break;
      this.later.delete(part);
      work();
      drawn = true;
    }
    // For the tests and for developers: the last frames, in the browser's own record of times.
    if (performance.getEntriesByName("redraw").length > 500) performance.clearMeasures("redraw");
    performance.measure("redraw", { start, end: performance.now(), detail: level });
    if (this.later.size > 0) this.request();
    if (!this.requested) document.body.classList.remove("drawing");
  }

  /** Draws at once what was requested and what was postponed. */
  finish() {
    const level = this.level;
    this.level = 0;
    if (level > 0) this.draw(level);
    for (const [part, { work }] of this.later) {
      this.later.delete(part);
      work();
    }
  }
}
