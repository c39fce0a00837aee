// SPDX-License-Identifier: MIT
// What the page promises as a page: its size, its controls, its colours, its speed.
import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { after, before, test } from "node:test";
import * as bench from "./bench.mjs";

const { drag, handle_place, isolator, numbers, settle, with_page } = bench;

before(bench.start);
after(bench.end);

test("it is one file below 600 kB", () => {
  const bytes = statSync(bench.file).size;
  console.log(`${bytes} bytes`);
  assert.ok(bytes < 600e3);
});

test("every control has a name and is reached by the keyboard", () =>
  with_page(isolator, {}, async (page) => {
    const controls = await page.evaluate(() => {
      const list = [
        ...document.querySelectorAll(
          "#bench button, #bench input, #bench select, #bench [tabindex='0']",
        ),
      ];
      return list
        .filter((node) => !node.disabled && node.checkVisibility({ visibilityProperty: true }))
        .map((node, i) => {
          node.dataset.control = String(i);
          const label =
            node.getAttribute("aria-label") ||
            [...(node.labels ?? [])].map((l) => l.textContent).join(" ");
          return {
            id: node.id || node.className.baseVal,
            name: (label || node.textContent).trim(),
          };
        });
    });
    assert.ok(controls.length > 25);
    for (const { id, name } of controls) assert.ok(name.length > 0, id);
    const reached = new Set();
    for (let i = 0; i < controls.length + 8; i++) {
      await page.keyboard.press("Tab");
      reached.add(await page.evaluate(() => document.activeElement?.dataset.control));
    }
    const missed = controls.filter((_, i) => !reached.has(String(i)));
    assert.deepEqual(missed, []);
  }));

test("arrow keys move the damper and go on doing so", () =>
  with_page(isolator, {}, async (page) => {
    let last = await numbers(page);
    await page.focus(".handle");
    for (let i = 0; i < 3; i++) {
      await page.keyboard.press("ArrowRight");
      await settle(page);
      const next = await numbers(page);
      assert.ok(next.f > last.f);
      last = next;
    }
    await page.keyboard.press("ArrowUp");
    await settle(page);
    assert.ok((await numbers(page)).delta > last.delta);
  }));

test("sliders write what the engine reads", () =>
  with_page(isolator, {}, async (page) => {
    for (const slider of ["period", "mass", "velocity", "max-displacement"]) {
      const id = `#slide-${slider}-${slider === "velocity" ? "high" : "low"}`;
      const before = await page.inputValue(`#in-${slider}`);
      await page.focus(id);
      await page.keyboard.press("ArrowRight");
      await page.keyboard.press("ArrowRight");
      await settle(page);
      assert.notEqual(await page.inputValue(`#in-${slider}`), before, slider);
      assert.equal(await bench.notice(page), "", slider);
    }
    await page.focus("#slide-velocity-low");
    for (let i = 0; i < 10; i++) await page.keyboard.press("ArrowLeft");
    await settle(page);
    assert.match(await page.inputValue("#in-velocity"), /^[\d.]+m\/s:[\d.]+m\/s$/);
    assert.equal(await bench.notice(page), "");
  }));

test("the left half of the velocity's handle makes a range", () =>
  with_page(isolator, {}, async (page) => {
    const slider = await page.locator("#slide-velocity-low").boundingBox();
    // Thumbs keep within the slider, so half of one is missing at either end.
    const at = slider.x + 5 + (slider.width - 10) * 0.2;
    const y = slider.y + slider.height / 2;
    await page.mouse.move(at - 4, y);
    await page.mouse.down();
    await page.mouse.move(at - 20, y, { steps: 5 });
    await page.mouse.up();
    await settle(page);
    assert.match(await page.inputValue("#in-velocity"), /^0\.[\d]+m\/s:0\.4m\/s$/);
  }));

test("a damper that is built keeps its length when the task changes", () =>
  with_page(`${isolator}&f=0.024&delta=0.03`, {}, async (page) => {
    const { f, delta } = await numbers(page);
    await bench.type(page, "velocity", "0.5");
    const next = await numbers(page);
    assert.equal(next.f, f);
    // The length goes through its quotient with another unit and back: two roundings each way.
    assert.ok(Math.abs(next.delta / delta - 1) <= 8 * Number.EPSILON, `${next.delta} ${delta}`);
  }));

test("units switch there and back", () =>
  with_page(isolator, {}, async (page) => {
    const { f, tolerance } = await numbers(page);
    await page.check("#dimensionless");
    await settle(page);
    assert.equal(await bench.notice(page), "");
    const plain = await numbers(page);
    assert.equal(plain.f, f);
    assert.equal(plain.tolerance, tolerance);
    await page.uncheck("#dimensionless");
    await settle(page);
    assert.equal(await bench.notice(page), "");
    // The lengths are rounded to six digits on the way back.
    const back = await numbers(page);
    assert.ok(Math.abs(back.f / f - 1) < 1e-4);
  }));

test("numbers in sentences stand in full in data-value", () =>
  with_page(isolator, {}, async (page) => {
    const bare = await page.evaluate(() => {
      const found = [];
      for (const id of ["answer", "judgement", "hit-words", "cloud-words", "hit-ends"]) {
        const walker = document.createTreeWalker(document.getElementById(id), NodeFilter.SHOW_TEXT);
        for (let node = walker.nextNode(); node; node = walker.nextNode()) {
          const text = node.textContent.replaceAll("x = 0", "");
          const full = node.parentElement.closest("[data-value]");
          if (/\d/.test(text) && !(full && Number.isFinite(Number(full.dataset.value))))
            found.push(text);
        }
      }
      return found;
    });
    assert.deepEqual(bare, []);
  }));

test("it moves, but not for those who asked for less motion", async () => {
  const moved = async (reducedMotion) => {
    let times = [];
    await with_page(isolator, { reducedMotion }, async (page) => {
      for (let i = 0; i < 2; i++) {
        times.push(await page.getAttribute("#clock", "data-value"));
        await page.waitForTimeout(200);
      }
    });
    return times[0] !== times[1];
  };
  assert.equal(await moved("no-preference"), true);
  assert.equal(await moved("reduce"), false);
});

test("light and dark are both legible", async () => {
  for (const colorScheme of ["light", "dark"]) {
    await with_page(isolator, { colorScheme }, async (page) => {
      const least = await page.evaluate(() => {
        const parts = (text) =>
          text
            .match(/[\d.]+/g)
            .slice(0, 3)
            .map(Number);
        const light = (text) => {
          const [r, g, b] = parts(text).map((c) =>
            c / 255 <= 0.03928 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4,
          );
          return 0.2126 * r + 0.7152 * g + 0.0722 * b;
        };
        const paper = light(getComputedStyle(document.body).backgroundColor);
        const inks = [
          ...document.querySelectorAll(
            "#bench p, #bench dt, #bench dd, #bench label, #bench button:enabled",
          ),
        ];
        return Math.min(
          ...inks.map((node) => {
            const ink = light(getComputedStyle(node).color);
            return (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05);
          }),
        );
      });
      assert.ok(least >= 4.5, `${colorScheme}: ${least}`); // WCAG 2, AA
    });
  }
});

test("the time of a redraw while dragging", () =>
  with_page(isolator, {}, async (page) => {
    const at = await handle_place(page);
    const places = Array.from({ length: 40 }, (_, i) => ({
      x: at.x - i,
      y: at.y + 30 * Math.sin(i / 6),
    }));
    await drag(page, ...places);
    const slider = await page.locator("#slide-period-low").boundingBox();
    await page.mouse.move(slider.x + slider.width * 0.7, slider.y + 9);
    await page.mouse.down();
    for (let i = 0; i < 40; i++) {
      await page.mouse.move(slider.x + slider.width * 0.7 - i, slider.y + 9);
      await settle(page);
    }
    await page.mouse.up();
    const times = await page.evaluate(() =>
      performance.getEntriesByName("redraw").map(({ duration, detail }) => ({ duration, detail })),
    );
    for (const [level, name] of [
      [2, "dragging the damper"],
      [3, "dragging a slider"],
    ]) {
      const list = times.filter(({ detail }) => detail === level).map(({ duration }) => duration);
      list.sort((a, b) => a - b);
      assert.ok(list.length >= 20, name);
      const of = (share) => list[Math.floor(share * (list.length - 1))].toFixed(1);
      console.log(
        `${name}: least ${of(0)} ms, median ${of(0.5)} ms, nine of ten within ${of(0.9)} ms, of ${list.length}`,
      );
    }
  }));
