// SPDX-License-Identifier: MIT
// The engine beside the page, for what takes seconds: the page goes on, hears how far it is, and can end it.
"use strict";

/** What the worker runs after the engine's scripts. */
function serve() {
  /** @type {Promise<Engine> | undefined} */
  let engine;
  const post = (/** @type {unknown} */ message) => postMessage(message);
  onmessage = async ({ data: { wasm, call } }) => {
    globalThis.stillpointWasm ??= wasm;
    engine ??= createEngine((words) => post({ words }));
    try {
      post({ answer: (await engine).run(.../** @type {Parameters<Engine["run"]>} */ (call)) });
    } catch (error) {
      post({ answer: { error: `the search failed: ${error}` } });
    }
  };
}

class Beside {
  /** @param {Engine} engine for browsers without workers */
  constructor(engine) {
    this.engine = engine;
    /** @type {Worker | null} */
    this.worker = null;
    /** @type {((answer: Answer | Refusal | null) => void) | null} */
    this.done = null;
  }

  /**
   * One at a time: the one before is cancelled.
   * @param {Parameters<Engine["run"]>} call @param {(words: string) => void} progress
   * @returns {Promise<Answer | Refusal | null>} nothing if it was cancelled
   */
  run(call, progress = () => {}) {
    this.cancel();
    const code = `"use strict";\n${stillpointEngine}\n(${serve})();`;
    try {
      this.worker ??= new Worker(URL.createObjectURL(new Blob([code])));
    } catch {
      return new Promise((done) => setTimeout(() => done(this.engine.run(...call)), 50));
    }
    const { worker } = this;
    return new Promise((done) => {
      this.done = done;
      worker.onmessage = ({ data: { words, answer } }) => {
        if (words !== undefined) return progress(words);
        this.done = null;
        done(answer);
      };
      worker.onerror = ({ message }) => {
        this.done = null;
        done({ error: `this browser runs no worker: ${message}` });
      };
      worker.postMessage({ wasm: stillpointWasm, call });
    });
  }

  cancel() {
    if (!this.done) return;
    this.worker?.terminate();
    this.worker = null;
    this.done(null);
    this.done = null;
  }
}
