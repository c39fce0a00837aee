// SPDX-License-Identifier: MIT
// The numbers of the page are those of the program, to the last digit.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import * as bench from "./bench.mjs";
import { random_from, random_task } from "./random.mjs";

const { go, isolator, numbers, notice, program, settle, with_page, words, words_of } = bench;

test("200 random tasks have the program's numbers", () =>
  with_page(isolator, {}, async (page) => {
    const seed = Number(process.env.STILLPOINT_SEED ?? 20261122);
    console.log(`seed ${seed}`);
    const random = random_from(seed);
    let designs = 0;
    for (let i = 0; i < 200; i++) {
      const task = random_task(random);
      await go(page, task);
      const report = program(["design", ...words_of(task)]);
      if (report.refused) {
        assert.ok(report.refused.includes(await notice(page)), `${task}: ${report.refused}`);
        continue;
      }
      assert.equal(await notice(page), "", task);
      const wanted = bench.numbers_of(report);
      assert.deepEqual(await numbers(page), wanted, task);
      if (wanted.f !== null) designs++;
    }
    console.log(`${designs} of 200 have a damper`);
    assert.ok(designs > 100);
  }));

test("a damper set by hand has the numbers of region and simulate", () =>
  with_page(isolator, {}, async (page) => {
    const random = random_from(7);
    for (let i = 0; i < 40; i++) {
      const physical = i % 2;
      const f = (physical ? 0.04 : 0.5) * random();
      const delta = (physical ? 0.06 : 0.6) * random();
      const task = physical ? "velocity=0.4&period=2.8&max-displacement=0.15" : "v0=1&p=1&beta=0.8";
      const state = `${task}&f=${f}&delta=${delta}`;
      await go(page, state);
      const left_out = ["max-displacement", "beta"];
      const { report, wanted } = bench.numbers_of_damper(state, state, left_out);
      assert.deepEqual(await numbers(page), wanted);
      const broken = report.constraints.some((/** @type {any} */ one) => !one.satisfied);
      assert.equal(
        await page.evaluate(() => document.querySelector(".overlay.broken") !== null),
        broken,
        state,
      );
      assert.match(
        await words(page, "#verdict"),
        broken ? /^The damper is not admissible: / : /^The damper is admissible: /,
        state,
      );
      // A side lights up only where the damper is forbidden.
      assert.ok(broken || (await page.locator("#region .lit").count()) === 0, state);
    }
  }));

/** Runs what a reader would paste into a shell. @param {string} line */
function shell(line) {
  const setup = `stillpoint() { '${bench.program_file}' "$@" --json; }`;
  const run = spawnSync("sh", ["-c", `${setup}; ${line}`], { encoding: "utf8" });
  return JSON.parse(run.stdout);
}

test("command, scene and link give the same digits", () =>
  with_page("", {}, async (page) => {
    const taken = async (/** @type {string} */ button) => {
      await page.click(button);
      const text = await page.inputValue("#share-text");
      await page.keyboard.press("Escape");
      return text;
    };
    await bench.with_folder(async (folder) => {
      for (const preset of await page.evaluate(() =>
        [...document.querySelectorAll("option")]
          .filter((option) => option.closest("#preset"))
          .map(({ value }) => value),
      )) {
        if (!preset || preset === "rubber_isolator") continue; // its damper is not the best
        await page.selectOption("#preset", preset);
        await settle(page);
        const shown = await numbers(page);
        const design = shell(await taken("#share-command"));
        assert.equal(design.design?.f ?? null, shown.f, preset);
        assert.equal(
          design.physical?.peak_m ?? design.cases[0].motions[0]?.response.peak_amplitude ?? null,
          shown.peak,
          preset,
        );
        const scene = join(folder, "scene.json");
        writeFileSync(scene, await taken("#share-scene"));
        assert.deepEqual(program(["design", scene]).design, design.design, preset);
        const link = await taken("#share-link");
        await go(page, "v0=1&p=1&beta=0.9");
        await go(page, new URL(link).hash.slice(1));
        assert.deepEqual(await numbers(page), shown, preset);
      }
      await go(page, `${isolator}&f=0.03&delta=0.04`);
      const shown = await numbers(page);
      const [judged, run] = (await taken("#share-command")).trim().split("\n").map(shell);
      assert.equal(judged.design.tolerance, shown.tolerance);
      assert.equal(run.physical.peak_m, shown.peak);
      assert.equal(run.physical.stop_time_s, shown["stop-time"]);
    });
  }));
