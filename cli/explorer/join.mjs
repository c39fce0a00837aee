// node join.mjs MODULE PAGE SCENES OUT: joins the compiled module (MODULE.js and MODULE.wasm), engine.js and the parts
// of the page into OUT/engine.js, for node, and OUT/stillpoint.html, one file that loads nothing.
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { load_engine } from "./load.mjs";

const [module, page, scenes, out] = process.argv.slice(2);
const largest_page = 900_000;

const read = (/** @type {string[]} */ ...path) => readFileSync(join(...path), "utf8");
const files = (/** @type {string} */ folder, /** @type {string} */ ending) =>
  readdirSync(folder)
    .filter((name) => name.endsWith(ending))
    .sort();
/** Without what only readers need: indentation, types and lines that are only a comment. */
const stripped = (/** @type {string} */ text) =>
  text
    .replace(/(?<=\S.*)\/\*\* @type [^*]*\*\/ ?/g, "")
    .replace(/^ *\/\* [^*]*\*\/$/gm, "")
    .split("\n")
    .map((line) => line.trim())
    .filter((line) => line && !/^(\/\/|\*)/.test(line) && !/^\/\*\*((?!\*\/).)*(\*\/)?$/.test(line))
    .join("\n");

/** As text of 8 bytes for 7 in UTF-8, which page/loader.js reads: its alphabet are the 128 letters of ASCII. Those that a
 * template of JavaScript or HTML would take for its own are 1, 2, ... times 128 higher, with the next letter.
 * @param {Buffer} bytes */
function dense(bytes) {
  const taken = [..."\0\r$<\\`"].map((letter) => letter.charCodeAt(0));
  const letters = [];
  let [bits, count] = [0, 0];
  for (const byte of [...bytes, 0]) {
    bits = (bits << 8) | byte;
    for (count += 8; count >= 7; count -= 7) letters.push((bits >> (count - 7)) & 127);
    bits &= (1 << count) - 1;
  }
  let text = "";
  for (let i = 0; i < letters.length; ++i) {
    const at = taken.indexOf(letters[i]);
    text += String.fromCharCode(at < 0 ? letters[i] : 128 * (at + 1) + (letters[++i] ?? 0));
  }
  return text;
}

const wasm = readFileSync(`${module}.wasm`);
const glue = read(`${module}.js`);
const engine = stripped(readFileSync(new URL("engine/engine.js", import.meta.url), "utf8"));
writeFileSync(
  join(out, "engine.js"),
  [
    glue,
    `const stillpointWasm = Uint8Array.from(atob("${wasm.toString("base64")}"), (c) => c.charCodeAt(0));`,
    engine,
  ].join("\n"),
);

const { options } = await load_engine(join(out, "engine.js"));
const presets = Object.fromEntries(
  files(scenes, ".json").map((name) => [basename(name, ".json"), JSON.parse(read(scenes, name))]),
);
const parts = files(page, ".js").filter((name) => /^\d\d-/.test(name));
const scripts = Buffer.from([glue, engine, ""].join("\n")); // which a worker runs too
const script = Buffer.from(
  [
    `const scenes = ${JSON.stringify(presets)};`,
    `const option_rows = ${JSON.stringify(options)};`,
    ...parts.map((name) => stripped(read(page, name))),
  ].join("\n"),
);
const plain = Buffer.concat([scripts, script, wasm]);
const packed = execFileSync("xz", ["--format=lzma", "-9e", "--stdout"], {
  input: plain,
  maxBuffer: plain.length,
});
const loader = `${stripped(read(page, "loader.js"))}
start_page(\`${dense(packed)}\`, ${packed.length}, ${plain.length}, ${scripts.length}, ${scripts.length + script.length});`;
const style = files(page, ".css").map((name) =>
  stripped(read(page, name))
    .replace(/(?<=^[a-z-]+:) | (?=\{$)/gm, "")
    .replace(/;\n(?=\})|(?<=[{};,])\n/g, ""),
);
const html = read(page, "page.html")
  .replace("<!-- style -->", () => `<style>\n${style.join("\n")}</style>`)
  .replace("<!-- scripts -->", () => `<script>\n${loader}</script>`);
const size = Buffer.byteLength(html);
if (size > largest_page) {
  console.error(
    `dev: the page has ${size} bytes, more than the ${largest_page} that it should have`,
  );
}
writeFileSync(join(out, "stillpoint.html"), html);
