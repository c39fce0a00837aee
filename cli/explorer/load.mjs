import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import vm from "node:vm";

/** The engine of a file that join.mjs wrote, see page/engine.d.ts. @param {string} file @returns {Promise<Engine>} */
export function load_engine(file) {
  Object.assign(globalThis, {
    require: createRequire(import.meta.url),
    __filename: file,
    __dirname: ".",
  });
  return vm.runInThisContext(`${readFileSync(file, "utf8")}\ncreateEngine`)();
}
