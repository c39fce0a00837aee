// SPDX-License-Identifier: MIT
// Ten things that someone tries who opens the page for the first time.
import assert from "node:assert/strict";
import { readFileSync, truncateSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import * as bench from "./bench.mjs";

const { drag, go, handle_place, isolator, notice, numbers, settle, type, with_page, words } = bench;

/** @typedef {import("./bench.mjs").Page} Page */

const near_fault = `${bench.records}near_fault_pulse.txt`;

test("a wrong unit is named, and the right one mends it", () =>
  with_page(isolator, {}, async (page) => {
    const right = await numbers(page);
    await type(page, "velocity", "0.4kg");
    assert.match(await notice(page), /^velocity = "0\.4kg": must be a number in m\/s/);
    assert.equal(await page.getAttribute("#in-velocity", "aria-invalid"), "true");
    // Another hit on the same damper does not make it admissible.
    await page.fill("#hit", "1000");
    await settle(page);
    assert.match(await notice(page), /^velocity = "0\.4kg"/);
    await type(page, "velocity", "400mm/s");
    assert.equal(await notice(page), "");
    assert.equal(await page.getAttribute("#in-velocity", "aria-invalid"), null);
    assert.deepEqual(await numbers(page), right);
    await type(page, "velocity", "400");
    assert.match(await notice(page), /did you mean velocity 400mm\/s\?$/);
    await type(page, "velocity", "0.4");
    assert.equal(await notice(page), "");
  }));

test("an impossible stroke is explained, and what it needs is offered", () =>
  with_page(isolator, {}, async (page) => {
    await type(page, "max-displacement", "50mm");
    assert.match(
      await words(page, "#verdict"),
      /^No admissible design: a peak within 50 mm needs f >= /,
    );
    assert.deepEqual(Object.values(await numbers(page)), [null, null, null, null, null]);
    assert.equal(await page.inputValue("#set-delta"), "");
    const offers = await page.locator("#verdict button").all();
    assert.equal(offers.length, 3);
    for (const offer of offers) {
      await offer.click();
      await settle(page);
      assert.notEqual((await numbers(page)).f, null);
      await page.goBack();
      await settle(page);
      assert.equal((await numbers(page)).f, null);
    }
  }));

/** Drops a file on the page. @param {Page} page @param {string} name @param {string} text */
async function drop(page, name, text) {
  await page.evaluate(
    ([file, content]) => {
      const dropped = new DataTransfer();
      dropped.items.add(new File([content], file));
      for (const kind of ["dragover", "drop"]) {
        document.body.dispatchEvent(
          new DragEvent(kind, { dataTransfer: dropped, bubbles: true, cancelable: true }),
        );
      }
    },
    [name, text],
  );
}

/** Waits until the answer under a record has this. @param {Page} page @param {string} text */
async function until_told(page, text) {
  await page.waitForFunction(
    (part) => document.getElementById("record-answer")?.textContent?.includes(part),
    text,
  );
}

test("a record of 100 MB is refused with the bound, and a small one that is dropped is not", () =>
  with_page(isolator, {}, async (page) => {
    await bench.with_folder(async (folder) => {
      const large = join(folder, "large.txt");
      writeFileSync(large, "");
      truncateSync(large, 100e6);
      await page.setInputFiles("#record-file", large);
      await page.waitForSelector("#record-answer .bad");
      assert.match(
        await words(page, "#record-answer"),
        /large\.txt has 100 MB; this page reads at most 20 MB/,
      );
    });
    await drop(page, "near_fault_pulse.txt", readFileSync(near_fault, "utf8"));
    await page.waitForSelector("#record-locked");
    const { f, delta } = await numbers(page);
    const damper = `period=2.8s&mass=1200t&f=${f}&delta-m=${delta}`;
    const report = bench.program(["simulate", ...bench.words_of(`${damper}&record=${near_fault}`)]);
    for (const [id, value] of [
      ["record-locked", report.physical.locked_from_s],
      ["record-peak", report.physical.peak_m],
      ["record-acceleration", report.response.peak_absolute_acceleration],
      ["record-residual", report.physical.final_position_m],
    ]) {
      assert.equal(Number(await page.getAttribute(`#${id}`, "data-value")), value, id);
    }
  }));

test("a hit of zero is refused as a task and held as a trial", () =>
  with_page(isolator, {}, async (page) => {
    await type(page, "velocity", "0");
    assert.match(await notice(page), /^velocity = 0 m\/s: must be/);
    await go(page, isolator);
    assert.equal(await notice(page), "");
    await page.fill("#hit", "0");
    await settle(page);
    assert.match(await words(page, "#hit-words"), /The mass never moves\./);
    assert.equal(await notice(page), "");
  }));

test("dragged out of the frame, the damper stays on its edge", () =>
  with_page(isolator, {}, async (page) => {
    for (const place of [
      { x: -400, y: -300 },
      { x: 2500, y: -300 },
      { x: 2500, y: 4000 },
      { x: -400, y: 4000 },
    ]) {
      await drag(page, place);
      const plot = await bench.box_of(page, "#region .frame"); // the words above it may wrap anew
      const at = await handle_place(page);
      assert.ok(at.x > plot.x - 2 && at.x < plot.x + plot.width + 2, JSON.stringify(at));
      assert.ok(at.y > plot.y - 2 && at.y < plot.y + plot.height + 2, JSON.stringify(at));
      const { f, delta } = await numbers(page);
      const most = Number((await page.getAttribute("#region svg", "data-x"))?.split(" ")[1]);
      assert.ok(f >= 0 && f <= most && delta >= 0, `${f} ${delta} ${most}`);
      assert.equal(await notice(page), "");
      // A release outside the window counts.
      await page.mouse.move(plot.x + 50, plot.y + 50);
      await settle(page);
      assert.equal((await numbers(page)).f, f);
    }
  }));

test("printed, it is a specification of two pages", () =>
  with_page(isolator, { colorScheme: "dark" }, async (page) => {
    assert.equal(await bench.sheets(page), 2);
    await page.emulateMedia({ media: "print" });
    assert.equal(await page.isVisible("#bench"), false);
    const sheet = await words(page, "#sheet");
    const text = await page.innerText("#sheet");
    for (const part of [
      "283.81 kN",
      "69.423 kJ",
      "±34.18 %",
      "hits of 0.341 to 0.429 m/s",
      "energy ratio",
      "governs",
      "Limits",
      "Assumptions",
    ]) {
      assert.ok(text.replaceAll("\u00a0", " ").includes(part), part);
    }
    assert.equal(await page.locator("#sheet svg.figure").count(), 2);
    assert.match(await words(page, "#sheet-loop-1-title"), /^Force and displacement/);
    await page.emulateMedia({ media: null });
    // Of the design's hit while another is tried, which stays; of none where the input is wrong.
    await page.fill("#hit", "500");
    await settle(page);
    const tried = await words(page, "#hit-words");
    await page.pdf();
    await settle(page);
    assert.equal(await words(page, "#sheet"), sheet);
    assert.equal(await words(page, "#hit-words"), tried);
    assert.equal(await page.inputValue("#hit"), "500");
    await type(page, "period", "soon");
    await page.pdf();
    assert.match(await words(page, "#sheet"), /^No damperperiod = "soon": must be/);
    // No more with a hundred ranges of hits, and with many options and conditions.
    const options =
      "criterion=exact&tolerance-f=0.05&f-max=0.03&delta-max-m=8mm&acceleration-max=0.2g&arrivals=4";
    for (const state of [
      `${isolator}&f=1e-5&delta=1e-5`,
      `velocity=0.36:0.44&period=2.66:2.94&max-displacement=170mm&mass=1200t&${options}&f=0.001&delta=0.002`,
      `velocity=0.36:0.44&period=2.66:2.94&max-displacement=170mm&mass=1200t&${options}`,
    ]) {
      await go(page, state);
      const pages = await bench.sheets(page);
      assert.ok(pages >= 1 && pages <= 2, `${pages}: ${state}`);
    }
  }));

test("what the program says of the damper, the page says too", () =>
  with_page("", {}, async (page) => {
    const plain = "v0=1&p=1&beta=0.8";
    for (const [state, begins] of /** @type {[string, RegExp][]} */ ([
      [isolator, /^Build a friction force of /],
      [`${isolator}&notch-width-m=2cm`, /^Build a friction force of .* 20 mm wide /],
      [`${isolator}&objective=amplitude`, /^The damper found has a friction force of /],
      [`${plain}&objective=time`, /^The damper found has f = /],
      ["v0=1&p=1&beta=3&objective=acceleration", /^The damper found has as little constant /],
      [`${isolator}&f=0.03&delta-m=4mm`, /^The damper is admissible: /],
      [`${plain}&f=0.5&delta=0.3`, /^The damper is not admissible: the mass does not come back \(/],
      [`${plain}&f=0.3&delta=0.0001`, /^The damper is not admissible: the mass passes x = 0 \(/],
    ])) {
      await go(page, state);
      assert.equal(await notice(page), "", state);
      const verdict = (await words(page, "#verdict")).trim();
      assert.match(verdict, begins, state);
      const text = bench.told(/[&]f=/.test(state) ? "region" : "design", state);
      assert.ok(text.includes(verdict), `${verdict} in ${text}`);
      for (const said of (await words(page, "#remarks")).trim().split(/(?<=\.) (?=[A-Z])/)) {
        assert.ok(text.includes(said), `${state}: ${said} in ${text}`);
      }
    }
  }));

test("of a damped mass the region and its damper are shown, and the best is searched if asked", () =>
  with_page(`${isolator}&damping=5%`, {}, async (page) => {
    const said = async () =>
      (await words(page, "#verdict")).replace(/ Search the best damper .*$/, "").trim();
    assert.equal(await notice(page), "");
    assert.match(await said(), /^The damper is admissible: /);
    assert.equal(await page.inputValue("#in-damping"), "5%");
    await page.click("#verdict button");
    await page.waitForFunction(() => location.hash.includes("delta="), null, { timeout: 60e3 });
    await settle(page);
    const state = decodeURIComponent(await bench.state(page));
    const best = bench.told("design", `${isolator}&damping=5%`);
    const text = bench.told("region", state);
    assert.ok(text.includes(await said()), `${await said()} in ${text}`);
    const f = state.match(/&f=([\d.]+)/)?.[1] ?? "none";
    assert.ok(best.includes(f), `f = ${f} in ${best}`);
  }));

test("a record may have any name, and doubts of its units are told", () =>
  with_page(isolator, {}, async (page) => {
    const values = (/** @type {number} */ peak) =>
      Array.from({ length: 40 }, (_, i) => `${i / 10} ${i % 2 ? peak : -peak}\n`).join("");
    for (const [name, shown] of /** @type {const} */ ([
      ["..", "record"],
      ["dev", "dev"],
      ["a#b,c.txt", "a_b_c.txt"],
    ])) {
      await drop(page, name, values(0.1));
      await until_told(page, `${shown}: 40 values in g (assumed); the largest load is 0.1`);
      assert.equal(await page.locator("#record-answer .bad:not(#record-verdict)").count(), 0, name);
    }
    // As the program says it of the same values: an ideal notch jolts, which no acceleration tells.
    await drop(page, "jolt.txt", values(0.1));
    await until_told(page, "jolt.txt");
    assert.match(
      await words(page, "#record-answer"),
      /At the notch the velocity jumps by up to [\d.]+ m\/s/,
    );
    await drop(page, "strong.txt", values(3));
    await page.waitForSelector("#record-answer .bad:not(#record-verdict)");
    assert.match(
      await words(page, "#record-answer .bad:not(#record-verdict)"),
      /the largest value is 3 g if its values are in g, which is assumed; did you mean record-units m\/s2\?/,
    );
  }));

test("of a damper under a record the page says what the program says", () =>
  with_page("", {}, async (page) => {
    for (const notch of ["", "&notch-width-m=80mm", "&hold=0.05"]) {
      const damper = `f=0.03&delta-m=4mm${notch}`;
      await go(page, `${isolator}&${damper}`);
      await drop(page, "near_fault_pulse.txt", readFileSync(near_fault, "utf8"));
      await until_told(page, "near_fault_pulse.txt");
      await settle(page);
      const text = bench.told("simulate", `period=2.8s&mass=1200t&${damper}&record=${near_fault}`);
      const said = await words(page, "#record-verdict");
      assert.ok(said.length > 10 && text.includes(said), `${said} in ${text}`);
      const alarms = await page.locator("#record-answer p.caution, #record-answer p.fault").count();
      assert.equal(await page.locator("#record-verdict.bad").count(), alarms ? 1 : 0, said);
      await page.click("#record-away");
    }
  }));

test("the specification is the program's, with the figures of practice at the worst of the ranges", () =>
  with_page(
    "velocity=0.36:0.44&period=2.66:2.94&max-displacement=170mm&mass=1200t",
    {},
    async (page) => {
      await page.pdf();
      await page.emulateMedia({ media: "print" });
      const text = (await page.innerText("#sheet")).replaceAll("\u00a0", " ");
      const state = new URL(page.url()).hash.slice(1);
      const { practice_worst, physical, cases } = bench.program([
        "design",
        ...bench.words_of(state),
      ]);
      /** @param {RegExp} form @param {number} value @param {number} unit */
      const shows = (form, value, unit = 1) => {
        const shown = Number(text.match(form)?.[1]);
        assert.ok(Math.abs((unit * shown) / value - 1) < 1e-3, `${form}: ${shown}, not ${value}`);
      };
      const weight = physical.friction_force_n / physical.f;
      shows(/base shear\s+([\d.]+) kN/, practice_worst.base_shear_over_weight * weight, 1e3);
      shows(/energy ratio ([\d.]+)/, practice_worst.energy_ratio);
      shows(/residual ratio ([\d.]+)/, practice_worst.residual_ratio);
      const [{ duty }] = cases;
      shows(/taken by a cycle, kJ\s+([\d.]+)/, duty.friction_energy_j, 1e3);
      shows(/slip path, mm\s+[^\t]*\t([\d.]+)/, duty.stroke_m, 1e-3);
    },
  ));

test("going back undoes, going forward does again", () =>
  with_page(isolator, {}, async (page) => {
    const states = [await numbers(page)];
    await type(page, "period", "3s");
    states.push(await numbers(page));
    await page.selectOption("#preset", "plain");
    await settle(page);
    states.push(await numbers(page));
    const at = await handle_place(page);
    await drag(page, { x: at.x - 20, y: at.y }, { x: at.x - 40, y: at.y - 10 });
    states.push(await numbers(page));
    assert.match(page.url(), /[#&]f=.*&delta=/);
    assert.equal(new Set(states.map(({ f }) => f)).size, states.length);
    for (const state of states.slice(0, -1).reverse()) {
      await page.goBack();
      await settle(page);
      assert.deepEqual(await numbers(page), state);
    }
    for (const state of states.slice(1)) {
      await page.goForward();
      await settle(page);
      assert.deepEqual(await numbers(page), state);
    }
  }));

test("a link with nonsense says so and harms nothing", () =>
  with_page("v0=abc&p=%E0%A4%A&<img src=x onerror=alert(1)>&beta&__proto__=1", {}, async (page) => {
    const said = await notice(page);
    assert.match(said, /^(v0 = "abc"|p = "%E0%A4%A"): /);
    assert.match(said, /__proto__=1/);
    assert.match(await words(page, "#verdict"), /^Nothing is computed/);
    assert.equal(await page.locator("#notice img").count(), 0);
    for (const nonsense of [
      "%",
      "=",
      "v0=1e999&p=1&beta=1",
      "f=1",
      "v0=1&p=1&beta=1&f=nan&delta=-1",
      "velocity=1&v0=1",
    ]) {
      await go(page, nonsense);
      assert.notEqual(await notice(page), "", nonsense);
    }
    await page.selectOption("#preset", "isolator");
    await settle(page);
    assert.equal(await notice(page), "");
    assert.equal(
      (await numbers(page)).peak,
      bench.program(["design", ...bench.words_of(isolator)]).physical.peak_m,
    );
  }));

test("resized down to 400 pixels, everything is within reach and the numbers stay", () =>
  with_page(isolator, {}, async (page) => {
    const wide = await numbers(page);
    for (const width of [1280, 1000, 700, 400, 320]) {
      await page.setViewportSize({ width, height: 800 });
      await settle(page);
      const outside = await page.evaluate((right) => {
        const seen = [
          ...document.querySelectorAll(
            "#bench button, #bench input, #bench select, #bench svg, #bench dd",
          ),
        ];
        return seen
          .filter(
            (node) =>
              node.getClientRects().length && node.getBoundingClientRect().right > right + 1,
          )
          .map((node) => node.id || node.getAttribute("class") || node.textContent);
      }, width);
      assert.deepEqual(outside, [], `${width}`);
      const covered = await page.evaluate(() => {
        const boxes = [...document.querySelectorAll("main > *")].map((node) =>
          node.getBoundingClientRect(),
        );
        const meet = (/** @type {DOMRect} */ a, /** @type {DOMRect} */ b) =>
          a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
        return boxes
          .filter((a, i) => a.width < 225 || boxes.slice(i + 1).some((b) => meet(a, b)))
          .map((box) => JSON.stringify(box));
      });
      assert.deepEqual(covered, [], `${width}`);
      assert.ok(
        (await page.evaluate(() => document.documentElement.scrollWidth)) <= width,
        `${width}`,
      );
      assert.deepEqual(await numbers(page), wide);
    }
    const at = await handle_place(page);
    await drag(page, { x: at.x - 15, y: at.y });
    assert.notEqual((await numbers(page)).f, wide.f);
  }));
