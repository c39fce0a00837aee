// SPDX-License-Identifier: MIT
// Pulses, requirements, forces and suites of records: the page has the program's numbers and its refusals.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import * as bench from "./bench.mjs";

const { go, isolator, notice, numbers, numbers_of, program, settle, state, type, with_page } =
  bench;
const { words, words_of } = bench;

const shock =
  "pulse=half-sine&k=30g&pulse-duration=5ms&period=0.5s&max-displacement=100mm&delta-max-m=60mm";
const records = ["near_fault_pulse.txt", "strong_motion.AT2"];

test("a pulse of each kind has the program's numbers, region and motion", () =>
  with_page(shock, {}, async (page) => {
    const kinds = await page.$$eval("#load-kind option", (all) =>
      all.map((one) => /** @type {HTMLOptionElement} */ (one).value),
    );
    assert.ok(kinds.includes("rectangle") && kinds[0] === "hit" && kinds.at(-1) === "records");
    for (const kind of kinds.slice(1, -1)) {
      await go(page, shock);
      await page.selectOption("#load-kind", kind);
      await settle(page);
      const task = await state(page);
      assert.ok(task.includes(`pulse=${kind}`), task);
      assert.deepEqual(
        await numbers(page),
        numbers_of(program(["design", ...words_of(task)])),
        kind,
      );
      assert.equal(await page.locator("#region svg .handle").count(), 1, kind);
      const plots = page.locator("#motion > svg, #phase > svg, #energy > svg, #cloud > svg");
      assert.equal(await plots.count(), 4, kind);
      assert.match(await words(page, "#hit-words"), /^The design pulse of 30\u00a0g: peak/);
    }
  }));

test("a damper that is dragged under a pulse has the numbers of region and simulate", () =>
  with_page(shock, {}, async (page) => {
    const at = await bench.handle_place(page);
    await bench.drag(page, { x: at.x - 60, y: at.y + 40 });
    const task = await state(page);
    assert.match(task, /&f=[\d.]+&delta=[\d.]+&/);
    const motion = task.replace("pulse=", "excitation=");
    const { wanted } = bench.numbers_of_damper(task, motion, ["max-displacement", "delta-max-m"]);
    assert.deepEqual(await numbers(page), wanted);
  }));

test("a link with any load comes back as it was", async () => {
  for (const task of [
    shock,
    `${shock}&f=0.2&delta=0.5`,
    "pulse=haversine&k=2g:3g&lambda=5&p=1&beta=1.2",
    "pulse=rectangle&k=1g&excitation-frequency=10Hz&natural-frequency=1Hz&max-displacement=90mm",
    `${isolator}&acceleration-max=0.1g&f-max=350kN&delta-max-m=6mm&tolerance-f=0.05&objective=time`,
    `${isolator}&friction-force=280kN&delta-m=5mm`,
    "p=1&beta=0.9&v0=1&notch-width=0.01",
  ]) {
    await with_page(task, {}, async (page) => {
      assert.equal(await notice(page), "", task);
      const first = await numbers(page);
      await page.click("#share-link");
      const link = new URL(await page.inputValue("#share-text")).hash.slice(1);
      await page.keyboard.press("Escape");
      const sorted = (/** @type {string} */ text) =>
        [...new URLSearchParams(text)].map(([name, value]) => `${name}=${value}`).sort();
      assert.deepEqual(sorted(link), sorted(task));
      await go(page, isolator);
      await go(page, link);
      assert.deepEqual(await numbers(page), first, task);
    });
  }
});

test("the load changes from a hit to a pulse and back, about as strong", () =>
  with_page(isolator, {}, async (page) => {
    await page.selectOption("#load-kind", "half-sine");
    await settle(page);
    assert.equal(await notice(page), "");
    assert.match(await state(page), /pulse=half-sine.*k=12.8g.*pulse-duration=5ms/);
    assert.match(await words(page, "#remarks"), /Nothing bounds delta.*Use a delta max of/);
    await page.click("#remarks button");
    await settle(page);
    assert.match(await state(page), /delta-max-m=0.00\d+m/);
    await page.selectOption("#load-kind", "hit");
    await settle(page);
    const velocity = (await state(page)).match(/velocity=([\d.]+)m/)?.[1];
    assert.ok(Math.abs(Number(velocity) - 0.4) < 0.004, velocity);
    assert.equal(await notice(page), "");
  }));

test("each requirement is an option of the program, and its refusal stands at its field", () =>
  with_page(isolator, {}, async (page) => {
    await page.click("#limits-title");
    const fields = await page.$$eval("#limits input", (all) =>
      all.map((one) => [one.id.slice(3), one.closest(".field")?.getAttribute("title") ?? ""]),
    );
    assert.ok(fields.length >= 7);
    for (const [name, help_of] of fields) {
      assert.ok(help_of.length > 10, name);
      await type(page, name, "never");
      const refusal = program(["design", ...words_of(`${isolator}&${name}=never`)]).refused;
      const said = await words(page, `#hint-${name}`);
      assert.ok(said && refusal.includes(said), `${name}: ${said} in ${refusal}`);
      assert.equal(await page.getAttribute(`#in-${name}`, "aria-invalid"), "true", name);
      await type(page, name, "");
      assert.equal(await notice(page), "", name);
      assert.equal(await words(page, `#hint-${name}`), "");
    }
    await type(page, "acceleration-max", "0.1g");
    await page.selectOption("#in-objective", "time");
    await settle(page);
    const wanted = words_of(`${isolator}&acceleration-max=0.1g&objective=time`);
    assert.deepEqual(await numbers(page), numbers_of(program(["design", ...wanted])));
    assert.equal(await page.getAttribute("#in-acceleration-max", "data-value"), "0.1");
    // One beyond the closed forms: the best is searched on request.
    await type(page, "tolerance-period", "0.02");
    assert.equal(await notice(page), "");
    assert.match(await words(page, "#verdict"), /Search the best damper/);
  }));

test("forces and energies are taken and told where a mass is given", () =>
  with_page(isolator, {}, async (page) => {
    await page.fill("#set-f", "280kN");
    await page.fill("#set-delta", "60kJ");
    await page.press("#set-delta", "Enter");
    await settle(page);
    const task = await state(page);
    assert.match(task, /friction-force=280kN/);
    assert.equal(await page.inputValue("#set-f"), "280kN");
    const judged = program(["region", ...words_of(task)]);
    const told = await page.$$eval("#f-sub [data-value], #delta-sub [data-value]", (all) =>
      all.map((one) => Number(one.getAttribute("data-value"))),
    );
    assert.equal(told[0], judged.physical.friction_force_n);
    assert.ok(Math.abs(told[1] / 60e3 - 1) < 1e-12);
    assert.equal((await numbers(page)).f, judged.design.f);
  }));

test("a suite of records is searched beside the page, judged, and told record by record", () =>
  bench.with_folder(async (temporary) => {
    const list = join(temporary, "records.csv");
    const rows = [`${bench.records}${records[0]},1`, `${bench.records}${records[1]},1.2`];
    writeFileSync(list, `file,scale\n${rows.join("\n")}\n`);
    const task = "period=2.8s&max-displacement=300mm";
    const drop = (/** @type {bench.Page} */ page) =>
      page.setInputFiles(
        "#record-file",
        records.map((name) => bench.records + name),
      );
    let link = "";
    await with_page(`${task}&record=`, {}, async (page) => {
      const until = (/** @type {RegExp} */ said) =>
        page.waitForFunction(
          (source) =>
            new RegExp(source).test(document.getElementById("verdict")?.textContent ?? ""),
          said.source,
          { timeout: 60e3 },
        );
      assert.match(await words(page, "#verdict"), /^Drop the records/);
      await drop(page);
      await until(/^2 records: type a damper below, or Search the best/);
      await page.fill("#record-list li:nth-child(2) input", "1.2");
      await page.press("#record-list li:nth-child(2) input", "Enter");
      await settle(page);
      await page.click("#verdict button");
      await until(/^The damper is admissible/);
      const suite = [...words_of(task), "--records-list", list];
      const { design } = program(["design", ...suite]);
      const f_delta = ["--f", `${design.f}`, "--delta-m", `${design.delta_m}`];
      const { cases, design: judged } = program(["region", ...suite, ...f_delta]);
      const [{ worst, motions }] = cases;
      const { f, delta, tolerance, peak } = await numbers(page);
      assert.deepEqual(
        { f, delta, tolerance, peak },
        { f: design.f, delta: design.delta_m, tolerance: judged.tolerance, peak: worst.peak_m },
      );
      const cells = await page.$$eval("#record-answer tr:not(:first-child)", (all) =>
        all.map((row) =>
          [...row.querySelectorAll("[data-value]")].map((one) =>
            Number(one.getAttribute("data-value")),
          ),
        ),
      );
      assert.deepEqual(
        cells,
        motions.map((/** @type {any} */ one) => [
          one.scale,
          one.pga,
          one.physical.peak_m,
          Math.abs(one.physical.final_position_m),
          one.response.peak_absolute_acceleration,
        ]),
      );
      const bold = await words(page, "#record-answer td.governs");
      assert.match(bold, /mm/);
      assert.equal(await page.locator("#record-figures .plate > svg").count(), 2);
      await page.click("#share-command");
      const command = await page.inputValue("#share-text");
      assert.match(command, /^printf .*near_fault_pulse.txt,1\\nstrong_motion.AT2,1.2/);
      assert.match(command, /stillpoint region .*--records-list records.csv/);
      await page.keyboard.press("Escape");
      link = await state(page);
      // What the program refuses stands at its field.
      await page.click("#limits-title");
      await type(page, "tolerance-f", "7");
      await until(/^tolerance-f = /);
      assert.match(await words(page, "#hint-tolerance-f"), /^tolerance-f = /);
      await type(page, "tolerance-f", "");
      await page.click("#record-list li:nth-child(1) button");
      await until(/^The damper is /);
      assert.equal(await page.locator("#record-answer tr").count(), 2);
      assert.match(await state(page), /record=strong_motion.AT2/);
      // A search can be ended.
      await page.click("#verdict button");
      await until(/Cancel$/);
      await page.click("#verdict button");
      await until(/Search the best damper/);
    });
    // Its link gives the records their factors when they are dropped again.
    await with_page(link, {}, async (page) => {
      assert.match(
        await words(page, "#verdict"),
        /names and factors of records: drop near_fault_pulse.txt, strong_motion.AT2 here/,
      );
      await drop(page);
      await page.waitForSelector("#record-list li:nth-child(2) input");
      assert.equal(await page.inputValue("#record-list li:nth-child(1) input"), "1");
      assert.equal(await page.inputValue("#record-list li:nth-child(2) input"), "1.2");
    });
  }));
