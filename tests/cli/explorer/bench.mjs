// SPDX-License-Identifier: MIT
// The page in a real browser, without a window, and the program beside it. Given by the environment:
// STILLPOINT_PAGE, STILLPOINT_PROGRAM, STILLPOINT_BROWSER.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, before } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";

/**
 * @typedef {import("playwright-core").Page} Page
 * @typedef {{ x: number, y: number }} Place
 */

const { chromium } = /** @type {import("playwright-core")} */ (
  createRequire(new URL("../../../cli/explorer/page/package.json", import.meta.url))(
    "playwright-core",
  )
);

const page_file = resolve(process.env.STILLPOINT_PAGE ?? "build/explorer/stillpoint.html");
export const address = pathToFileURL(page_file).href;
export const program_file = process.env.STILLPOINT_PROGRAM ?? "build/release/cli/stillpoint";

export const file = page_file;
export const records = fileURLToPath(new URL("../../../data/records/", import.meta.url));
export const isolator = "velocity=0.4m/s&period=2.8s&max-displacement=150mm&mass=1200t";

/** @type {import("playwright-core").Browser | undefined} */
let browser;

before(async () => {
  // The sandbox of the browser needs rights that a container lacks; this page is our own.
  browser = await chromium.launch({
    executablePath: process.env.STILLPOINT_BROWSER ?? "/usr/bin/chromium",
    args: ["--no-sandbox"],
  });
});
after(() => browser?.close());

/**
 * Opens the page, lets `visit` try something, and sees that nothing was loaded and nothing went wrong.
 * @param {string} fragment
 * @param {import("playwright-core").BrowserContextOptions} settings
 * @param {(page: Page) => Promise<void>} visit
 */
export async function with_page(fragment, settings, visit) {
  assert.ok(browser);
  const context = await browser.newContext({
    viewport: { width: 1280, height: 900 },
    reducedMotion: "reduce",
    ...settings,
  });
  const page = await context.newPage();
  /** @type {string[]} */
  const wrong = [];
  /** @type {string[]} */
  const loaded = [];
  page.on("console", (message) => wrong.push(message.text()));
  page.on("pageerror", (error) => wrong.push(String(error)));
  page.on("request", (request) => loaded.push(request.url().slice(0, 200)));
  await page.goto(fragment ? `${address}#${fragment}` : address);
  await page.waitForSelector("body:not(.loading)");
  await settle(page);
  await visit(page);
  assert.deepEqual(wrong, []);
  assert.deepEqual(
    loaded.filter((url) => !url.startsWith(address) && !/^(data|blob):/.test(url)),
    [],
  );
  await context.close();
}

/** A frame. @param {Page} page */
export async function frame(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
}

/** Waits until what was requested and what was postponed is drawn. @param {Page} page */
export async function settle(page) {
  await page.evaluate(
    () =>
      new Promise((done) => {
        const look = () => {
          if (document.body.classList.contains("drawing")) requestAnimationFrame(look);
          else done(undefined);
        };
        requestAnimationFrame(() => requestAnimationFrame(look));
      }),
  );
}

/**
 * Another state in the same page, as when a link is pasted into its address.
 * @param {Page} page @param {string} fragment
 */
export async function go(page, fragment) {
  await page.evaluate((text) => (location.hash = text), fragment);
  await settle(page);
}

/**
 * The numbers of the design in full; null where none is shown.
 * @param {Page} page
 * @returns {Promise<Record<string, any>>}
 */
export function numbers(page) {
  return page.evaluate(() =>
    Object.fromEntries(
      ["f", "delta", "tolerance", "peak", "stop-time"].map((id) => {
        const value = document.getElementById(id)?.dataset.value;
        return [id, value === undefined ? null : Number(value)];
      }),
    ),
  );
}

/** Which the page shows of a report. @param {any} report @returns {Record<string, any>} */
export function numbers_of({ design, physical, cases }) {
  const response = cases[0].motions[0]?.response;
  const of = (/** @type {() => number} */ value) => (design ? value() : null);
  return {
    f: of(() => design.f),
    delta: of(() => physical?.delta_m ?? design.delta),
    tolerance: of(() => design.tolerance),
    peak: of(() => physical?.peak_m ?? response.peak_amplitude),
    "stop-time": of(() => physical?.stop_time_s ?? response.stop_time),
  };
}

/**
 * And of a given damper: as it is judged, and its motion.
 * @param {string} judged @param {string} moved @param {string[]} left_out of the latter
 */
export function numbers_of_damper(judged, moved, left_out) {
  const report = program(["region", ...words_of(judged)]);
  const motion = program(["simulate", ...words_of(moved, left_out)]);
  const wanted = {
    f: report.design.f,
    delta: report.physical?.delta_m ?? report.design.delta,
    tolerance: report.design.tolerance,
    peak: motion.physical?.peak_m ?? motion.response.peak_amplitude,
    "stop-time": motion.physical?.stop_time_s ?? motion.response.stop_time,
  };
  return { report, wanted };
}

/** The options in the address. @param {Page} page */
export function state(page) {
  return page.evaluate(() => location.hash.slice(1));
}

/** How many pages it has on paper. @param {Page} page */
export async function sheets(page) {
  const paper = (await page.pdf({ preferCSSPageSize: true })).toString("latin1");
  return paper.match(/\/Type\s*\/Page\b/g)?.length ?? 0;
}

/** A folder for as long as it is used. @param {(folder: string) => Promise<void>} use */
export async function with_folder(use) {
  const folder = mkdtempSync(join(tmpdir(), "explorer-"));
  try {
    await use(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** What an element says. @param {Page} page @param {string} selector */
export async function words(page, selector) {
  return (await page.textContent(selector)) ?? "";
}

/** What is wrong, or nothing. @param {Page} page */
export async function notice(page) {
  return (await page.isVisible("#notice")) ? words(page, "#notice") : "";
}

/** Types into a field of the task. @param {Page} page @param {string} name @param {string} text */
export async function type(page, name, text) {
  await page.fill(`#in-${name}`, text);
  await page.press(`#in-${name}`, "Enter");
  await settle(page);
}

/** @param {Page} page @param {string} selector */
export async function box_of(page, selector) {
  const box = await page.locator(selector).boundingBox();
  assert.ok(box, selector);
  return box;
}

/** The middle of the handle. @param {Page} page */
export async function handle_place(page) {
  const box = await box_of(page, ".handle .grip");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Drags the handle to places, one after the other. @param {Page} page @param {Place[]} places */
export async function drag(page, ...places) {
  await page.locator(".handle .grip").scrollIntoViewIfNeeded();
  const from = await handle_place(page);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (const { x, y } of places) {
    await page.mouse.move(x, y, { steps: 4 });
    await settle(page);
  }
  await page.mouse.up();
  await settle(page);
}

/**
 * The frames in which the page drew during `work`: what each took of its thread in ms of computing, with style, layout
 * and paint. Other load on the machine hardly affects it.
 * @param {Page} page
 * @param {() => Promise<void>} work
 */
export async function frame_times(page, work) {
  assert.ok(browser);
  const categories = ["toplevel", "devtools.timeline", "blink.user_timing"];
  await browser.startTracing(page, { categories });
  await work();
  /** @type {{ name: string, ph: string, pid: number, tid: number, ts: number, dur: number, tdur: number }[]} */
  const events = JSON.parse(String(await browser.stopTracing())).traceEvents;
  const drawn = events.filter(({ name, ph }) => name === "redraw" && ph === "b");
  return events
    .filter(({ name, dur }) => name === "ThreadControllerImpl::RunTask" && dur > 0)
    .filter(({ pid, tid, ts, dur }) =>
      drawn.some((of) => of.pid === pid && of.tid === tid && of.ts >= ts && of.ts < ts + dur),
    )
    .map(({ tdur }) => tdur / 1000);
}

/** Runs the program; its report, or what it refuses. @param {string[]} words @returns {any} */
export function program(words) {
  const run = spawnSync(program_file, [...words, "--json"], { encoding: "utf8" });
  assert.equal(run.error, undefined);
  return run.stdout ? JSON.parse(run.stdout) : { refused: run.stderr };
}

/** The report for people, in one line and with the signs of the page. @param {string} command @param {string} fragment */
export function told(command, fragment) {
  const run = spawnSync(program_file, [command, ...words_of(fragment)], { encoding: "utf8" });
  return run.stdout.replace(/\s+/g, " ").replaceAll("+-", "\u00b1");
}

/**
 * The words of a fragment's options, for the program.
 * @param {string} fragment
 * @param {string[]} left_out
 */
export function words_of(fragment, left_out = []) {
  return [...new URLSearchParams(fragment)]
    .filter(([name]) => !left_out.includes(name))
    .flatMap(([name, value]) => [`--${name}`, value]);
}
