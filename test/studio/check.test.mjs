// SPDX-License-Identifier: GPL-3.0-or-later
// What the page says is true, and what it refuses leaves no trace: how far the quads are from the surface, drags to where nothing can be,
// Escape, numbers, a design begun by hand, and one word for one thing.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test, { after, before } from "node:test";
import { pageModules, Studio } from "./harness.mjs";

let studio;
before(async () => (studio = await Studio.start({ width: 1100, height: 700 })));
after(() => studio.close());

const tail = async () => (await studio.state()).history.map((step) => step.edit.edit);
const answer = (id) => studio.page.click(`dialog.question [data-answer="${id}"]`);
const measured = () => studio.page.waitForFunction(() => window.studio.store.get("deviation"));
const critical = (kind) => studio.page.evaluate((k) => window.studio.stage.critical.filter((c) => c.kind === k).map((c) => c.position.toArray()), kind);

/** What axe finds serious in what is seen now, dark and light, a line each. */
async function barriers(where) {
  if (!(await studio.page.evaluate(() => "axe" in window))) await studio.page.evaluate(readFileSync(pageModules.resolve("axe-core/axe.min.js"), "utf8"));
  const found = new Set();
  for (const theme of ["light", "dark"]) {
    await studio.page.evaluate((theme) => (document.documentElement.dataset.theme = theme), theme);
    const lines = await studio.page.evaluate(async () => {
      const { violations } = await window.axe.run(document, { resultTypes: ["violations"] });
      return violations.filter(({ impact }) => impact === "serious" || impact === "critical").flatMap(({ id, nodes }) => nodes.map((n) => `${id} ${n.target.join(" ")}: ${n.failureSummary}`));
    });
    for (const line of lines) found.add(`${where}, ${theme}: ${line}`);
  }
  return [...found];
}

test("the page has no barrier that axe calls serious before a mesh is open", async () => {
  assert.deepEqual(await barriers("start"), []);
});

test("a design is begun by hand, without a suggestion", async () => {
  await studio.upload(studio.shape("l-shape", 1500));
  assert.equal(await studio.page.isDisabled('[data-tool="subdivide"]'), true);
  await studio.tool("extremum");
  const [low, high] = await studio.page.evaluate(() => {
    const { surface } = window.studio.stage, t = surface.triangles; // the middles of faces: a corner is hard to hit
    const all = Array.from({ length: t.length / 3 }, (_, f) => [0, 1, 2].reduce((sum, k) => sum.addScaledVector(surface.vertex(t[3 * f + k]), 1 / 3), surface.vertex(0).multiplyScalar(0)));
    const along = (p) => p.y - p.x;
    all.sort((a, b) => along(a) - along(b));
    return [all[0].toArray(), all.at(-1).toArray()];
  });
  await studio.page.click('[data-choice="minimum"]');
  await studio.clickOn(low);
  assert.equal(await studio.page.isDisabled("#design-by-hand"), true);
  await studio.page.click('[data-choice="maximum"]');
  await studio.clickOn(high);
  await studio.picture("by_hand");
  const state = await studio.after(() => studio.page.keyboard.press("Enter"));
  assert.deepEqual(await tail(), ["set_extrema"]);
  assert.ok(state.statistics.quads > 0);
});

test("another suggestion asks before it throws steps away", async () => {
  await studio.page.click("#suggest");
  await studio.page.waitForSelector("text=Suggest another design?");
  await answer("cancel");
  assert.deepEqual(await tail(), ["set_extrema"]);
  await studio.page.click("#suggest");
  await studio.after(() => answer("suggest"));
  assert.deepEqual(await tail(), ["set_extrema", "suggest"]);
});

test("the number of quads is what was typed; what was typed wrongly is refused with a sentence", async () => {
  const steps = (await tail()).length;
  await studio.page.fill("#quads", "-5");
  await studio.page.press("#quads", "Enter");
  await studio.told(/lies between 50 and 1/);
  await studio.page.fill("#quads", "400");
  const state = await studio.after(() => studio.page.press("#quads", "Enter"));
  assert.equal(state.facts.target_quads, 400);
  assert.equal(await studio.page.inputValue("#quads"), "400");
  await studio.after(() => studio.page.press("#quads", "Enter")); // asking again asks again
  assert.equal((await tail()).length, steps + 2);
  // Undoing what was typed, and leaving the field, makes no step.
  await studio.page.fill("#quads", "900");
  await studio.page.press("#quads", "Control+z");
  await studio.page.locator("#quads").blur();
  await studio.settle();
  await studio.quiet();
  assert.equal(await studio.page.inputValue("#quads"), "400");
  assert.equal((await tail()).length, steps + 2);
  assert.equal((await studio.state()).applied, steps + 2);
});

test("how far quads and surface are from each other is told in units and per cent", async () => {
  await measured();
  const { deviation, diagonal } = await studio.page.evaluate(() => {
    const deviation = window.studio.store.get("deviation");
    return { deviation, diagonal: window.studio.store.get("state").file.diagonal };
  });
  assert.ok(Math.abs(deviation.diagonal - diagonal) < 1e-6 * diagonal);
  assert.equal(deviation.corners, 12); // of an L
  const greatest = Math.max(deviation.of_surface, deviation.of_quads);
  assert.ok(Math.abs(deviation.worst[0].distance - greatest) < 1e-9 * diagonal);
  assert.ok(greatest > 0.001 * diagonal && greatest < 0.2 * diagonal, `${greatest}`);
  const text = await studio.page.innerText(".deviation");
  assert.match(text, /\d %/);
  assert.ok(text.includes(greatest.toPrecision(3)));
  assert.equal(await studio.page.getAttribute("[data-corners]", "data-corners"), `${12 - deviation.lost_corners.length}/12`);
  assert.ok(deviation.lost_sharp_length > 0.02 * deviation.sharp_length);
  assert.equal(await studio.page.getAttribute("[data-sharp]", "data-sharp"), `${Math.round(100 * (1 - deviation.lost_sharp_length / deviation.sharp_length))} %`);
  assert.match(await studio.page.innerText(".status .kept"), /off by .* %.* % of sharp edges cut through/);
  assert.match(await studio.page.innerText(".hint-list"), /^(?!Nothing to improve)/);
});

test("its colours are on the surface, under the quads' edges, and the worst places are flown to", async () => {
  await studio.view("surface");
  const plain = await studio.drawn();
  await studio.view("deviation");
  assert.notEqual(await studio.drawn(), plain);
  const shown = await studio.page.evaluate(() => ({ mode: window.studio.stage.surface.material.uniforms.mode.value, edges: window.studio.stage.wireframe.object.visible }));
  assert.deepEqual(shown, { mode: 3, edges: true });
  await studio.picture("deviation_dark");
  const before = await studio.drawn();
  await studio.page.selectOption("#deviation-scale", "4");
  assert.notEqual(await studio.drawn(), before);
  const row = studio.page.locator(".place-list .finding").last();
  const place = (await row.getAttribute("data-place")).split(" ").map(Number);
  await row.click();
  await studio.page.waitForFunction((p) => Math.hypot(...window.studio.viewport.controls.target.toArray().map((x, i) => x - p[i])) < 1e-3, place);
  await studio.picture("deviation_worst");
});

test("the surface in place of the quads keeps their edges", async () => {
  await studio.view("quads");
  await studio.page.keyboard.press("1");
  await studio.settle();
  const shown = await studio.page.evaluate(() => [...window.studio.store.get("layers")].sort());
  assert.ok(shown.includes("surface") && shown.includes("wireframe") && !shown.includes("quads"));
  assert.equal(await studio.page.evaluate(() => window.studio.stage.wireframe.object.visible), true);
});

test("normals are split at creases", async () => {
  const sharpest = () => studio.page.evaluate(() => {
    // The faces of an L are flat: with its own normals a face is shaded evenly.
    const { normals, triangles } = window.studio.stage.surface;
    let least = 1;
    for (let c = 0; c < triangles.length; c += 3)
      for (const [a, b] of [[0, 1], [1, 2]]) least = Math.min(least, [0, 1, 2].reduce((sum, k) => sum + normals[3 * (c + a) + k] * normals[3 * (c + b) + k], 0));
    return least;
  });
  assert.ok((await sharpest()) > 0.999);
});

/** Presses an extremum and drags it towards a place of the surface, in steps, without letting go. */
async function dragTo(from, to) {
  const begin = await studio.screen(from), end = await studio.screen(to);
  await studio.page.mouse.move(begin.x, begin.y);
  await studio.page.mouse.down();
  for (let i = 1; i <= 6; ++i) {
    await studio.page.mouse.move(begin.x + ((end.x - begin.x) * i) / 6, begin.y + ((end.y - begin.y) * i) / 6);
    await studio.settle();
  }
}

test("a place that is refused is red while dragging; let go there, everything is as before the drag", async () => {
  await studio.upload(studio.shape("torus", 2500));
  const made = await studio.suggest();
  await studio.tool("extremum");
  const [maximum] = await critical(2);
  await studio.face(maximum, 3);
  // What is seen farthest from it lies beyond the saddle, where its charts end.
  const beyond = await studio.page.evaluate((from) => {
    const { stage, viewport } = window.studio, at = (p) => viewport.project(p.clone()), start = at(viewport.controls.target.clone().set(...from));
    const seen = Array.from({ length: stage.surface.positions.length / 3 }, (_, v) => stage.surface.vertex(v)).filter((p) => stage.isInSight(p));
    const far = (p) => Math.hypot(at(p).x - start.x, at(p).y - start.y);
    return seen.reduce((best, p) => (far(p) > far(best) ? p : best)).toArray();
  }, maximum);
  await dragTo(maximum, beyond);
  await studio.page.waitForSelector(".hint-line.bad");
  assert.match(await studio.page.innerText(".hint-line"), /refused/);
  assert.equal(await studio.page.locator("canvas.refused").count(), 1);
  await studio.picture("drag_refused");
  await studio.page.mouse.up();
  await studio.told(/Nothing was changed/);
  await studio.quiet();
  const state = await studio.state();
  assert.deepEqual(await tail(), ["suggest"]);
  assert.deepEqual(state.statistics, made.statistics);
  assert.equal(await studio.page.locator("canvas.refused").count(), 0);
  assert.ok((await critical(2)).some((p) => p.every((x, i) => x === maximum[i])));
});

test("Escape takes a drag back at once, and leaves no step", async () => {
  const before = await studio.state(), [maximum] = await critical(2);
  const aside = await studio.page.evaluate(([x, y, z]) => {
    const { stage, viewport } = window.studio, from = viewport.controls.target.clone().set(x, y, z);
    const all = Array.from({ length: stage.surface.positions.length / 3 }, (_, v) => stage.surface.vertex(v));
    return all.filter((p) => p.distanceTo(from) > 0.05 * stage.surface.radius).sort((a, b) => a.distanceTo(from) - b.distanceTo(from))[3].toArray();
  }, maximum);
  await studio.face(maximum, 2);
  await dragTo(maximum, aside);
  await studio.page.waitForFunction((n) => window.studio.store.get("state").history.length > n, before.history.length);
  await studio.page.keyboard.press("Escape");
  await studio.page.waitForFunction((n) => window.studio.store.get("state").history.length === n, before.history.length);
  await studio.page.mouse.up();
  await studio.quiet();
  const state = await studio.state();
  assert.equal(state.applied, before.applied);
  assert.deepEqual(state.statistics, before.statistics);
  assert.equal(await studio.page.locator('[data-tool="extremum"].on').count(), 1, "the tool goes on");
});

test("what cannot be deleted in its chart says why and what helps", async () => {
  const maxima = await critical(2);
  await studio.clickOn(maxima[0]);
  await studio.page.click("#delete-extremum");
  const sentence = maxima.length > 1 ? /in the charts around nothing would be a maximum.*whole surface/i : /the field needs at least one maximum/i;
  await studio.told(sentence);
});

test("one word for one thing, and no letters smaller than 12 pixels", async () => {
  const texts = new Set(), small = new Set();
  const read = async () => {
    for (const [text, size] of await studio.page.evaluate(() => [...document.querySelectorAll("body *:not(script, style, option)")].flatMap((e) => {
      const own = [...e.childNodes].filter((n) => n.nodeType === 3).map((n) => n.textContent).join(" ").trim(), size = parseFloat(getComputedStyle(e).fontSize);
      return [...["title", "aria-label", "placeholder"].flatMap((name) => (e.getAttribute(name) ? [[e.getAttribute(name), 99]] : [])), ...(own ? [[own, size]] : [])];
    }))) {
      texts.add(text);
      if (size > 0 && size < 12) small.add(text); // a button with a sign alone has letters of no size
    }
  };
  await studio.page.keyboard.press("?");
  await read();
  await studio.page.keyboard.press("Escape");
  for (const tool of await studio.page.evaluate(() => [...document.querySelectorAll("[data-tool]")].map((e) => e.dataset.tool))) {
    await studio.page.click(`[data-tool="${tool}"]`);
    await read();
    for (const choice of await studio.page.locator(".tool-box [data-variant]").all()) {
      await choice.click();
      await read();
    }
  }
  const forbidden = /\b(disc|discs|annulus|annuli|polychord|subdivide|euler|singularit|edit texture|remove extremum|certify)\b/i;
  assert.deepEqual([...texts].filter((text) => forbidden.test(text)), []);
  assert.deepEqual([...small], []);
  assert.ok(texts.size > 150);
});

test("the page has no barrier that axe calls serious: in no step, tab, tool, menu, dialog or list of keys", async () => {
  const found = [];
  for (const step of await studio.page.evaluate(() => [...document.querySelectorAll("[data-view]")].map((e) => e.dataset.view))) {
    await studio.view(step);
    found.push(...(await barriers(`step ${step}`)));
  }
  for (const tab of await studio.page.evaluate(() => [...document.querySelectorAll("[data-tab]")].map((e) => e.dataset.tab))) {
    await studio.tab(tab);
    found.push(...(await barriers(`tab ${tab}`)));
  }
  await studio.tab("design");
  for (const tool of await studio.page.evaluate(() => [...document.querySelectorAll("[data-tool]")].map((e) => e.dataset.tool))) {
    await studio.tool(tool);
    found.push(...(await barriers(`tool ${tool}`)));
  }
  await studio.page.click("#display");
  found.push(...(await barriers("display")));
  await studio.page.click("#display");
  for (const dialog of ["#save-as", "#open"]) {
    await studio.page.click(dialog);
    await studio.page.waitForSelector("dialog[open]");
    found.push(...(await barriers(dialog)));
    await studio.page.keyboard.press("Escape");
  }
  await studio.page.keyboard.press("?");
  found.push(...(await barriers("keys")));
  await studio.page.keyboard.press("Escape");
  assert.deepEqual(found, []);
});

test("the page reported no errors", () => assert.deepEqual(studio.errors, []));
