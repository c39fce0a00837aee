// The engine of the page, see page/engine.d.ts. `createModule` and `stillpointWasm`, the bytes of the
// WebAssembly, come before it in the file that join.mjs writes.

/** @param {(words: string) => void} [progress] hears how far a search is @returns {Promise<Engine>} */
async function createEngine(progress) {
  const module = await createModule({ wasmBinary: stillpointWasm, progress });
  // Apart from what the file system has of its own.
  module.FS.mkdir("/files");
  module.FS.chdir("/files");

  /** @param {string} text @param {(text: number) => number} work */
  const withText = (text, work) => {
    const size = module.lengthBytesUTF8(text) + 1;
    const at = module._malloc(size);
    module.stringToUTF8(text, at, size);
    try {
      const [said, ...behind] = module.UTF8ToString(work(at)).split("\x1e");
      return { answer: JSON.parse(said), behind };
    } finally {
      module._free(at);
    }
  };
  /** @param {number} index @param {number} size */
  const column = (index, size) => {
    const at = module._stillpoint_numbers() / 8 + index * size;
    return module.HEAPF64.slice(at, at + size);
  };

  return {
    ...JSON.parse(module.UTF8ToString(module._stillpoint_about())),

    run(command, options, ask = {}, files = {}) {
      const written = [];
      try {
        for (const [name, content] of Object.entries(files)) {
          try {
            module.FS.writeFile(name, content);
          } catch {
            return { error: `${name} is not the name of a file` };
          }
          written.push(name);
        }
        const request = {
          command,
          options,
          figures: [],
          report: true,
          quick: false,
          ...ask,
        };
        const { answer, behind } = withText(JSON.stringify(request), module._stillpoint_run);
        if (answer.error !== undefined) return answer;
        const [json, ...drawn] = behind;
        // Its sentences as a page writes them; no number has these signs together.
        const report = json ? JSON.parse(json.replaceAll("+-", "\u00b1")) : null;
        const figures = drawn.map((svg, i) => ({ ...answer.figures[i], svg }));
        return { ...answer, json, report, figures };
      } finally {
        for (const name of written) module.FS.unlink(name);
      }
    },

    motion(options, points) {
      const { answer } = withText(JSON.stringify(options), (text) =>
        module._stillpoint_motion(text, points),
      );
      if (answer.error !== undefined) return answer;
      const size = module._stillpoint_count() / 3;
      return { t: column(0, size), x: column(1, size), v: column(2, size) };
    },

    batch(options, f, delta, v0) {
      const size = f.length;
      const at = module._malloc(3 * 8 * Math.max(size, 1));
      try {
        [f, delta, v0].forEach((values, i) => module.HEAPF64.set(values, at / 8 + i * size));
        const { answer } = withText(JSON.stringify(options), (text) =>
          module._stillpoint_batch(text, size, at),
        );
        if (answer.error !== undefined) return answer;
        return {
          peak: column(0, size),
          rest: column(1, size),
          outcome: Uint8Array.from(column(2, size)),
        };
      } finally {
        module._free(at);
      }
    },
  };
}
