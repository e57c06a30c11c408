// SPDX-License-Identifier: GPL-3.0-or-later
// Hints: fingers that the design leaves out are told with the reason; the pointer on a hint shows where, a click applies it.
import assert from "node:assert/strict";
import test, { after, before } from "node:test";
import { Studio } from "./harness.mjs";

let studio;
before(async () => (studio = await Studio.start()));
after(() => studio.close());

const limb = '[data-hint="uncovered_limb"]';

test("limbs without quads of their own are hints, with the reason", async () => {
  await studio.upload(studio.shape("hand", 5000));
  await studio.suggest();
  // One finger loses its extremum.
  await studio.tool("extremum");
  const tip = await studio.page.evaluate(() => {
    const tips = window.studio.stage.critical.filter((c) => c.kind === 2).map((c) => c.position.toArray());
    return tips.sort((a, b) => b[2] - a[2])[0];
  });
  await studio.clickOn(tip);
  await studio.after(() => studio.page.keyboard.press("Delete"));
  await studio.tool("select");
  await studio.tab("check");
  await studio.page.waitForSelector(limb);
  await studio.page.waitForSelector('[data-tab="check"] .badge:not([hidden])');
  assert.match(await studio.page.locator(limb).first().innerText(), /add (maximum|minimum)/);
  assert.ok((await studio.page.locator(limb).first().innerText()).length > 30);
});

test("the pointer on a hint shows where it is", async () => {
  const marks = () => studio.page.evaluate(() => window.studio.viewport.scene.children.filter((o) => o.isPoints && o.renderOrder === 11).length);
  assert.equal(await marks(), 0);
  await studio.page.hover(limb);
  assert.equal(await marks(), 1);
  await studio.page.locator(".hint-row button").nth(1).click();
  await studio.landed();
  await studio.picture("hint");
});

test("a click applies a hint, and the list follows", async () => {
  const before = await studio.state();
  const reasons = await studio.page.locator(limb).allInnerTexts();
  const state = await studio.after(() => studio.page.locator(limb).first().click());
  assert.equal(state.facts.extrema.length, before.facts.extrema.length + 1);
  assert.equal(state.certificate.passed, true);
  await studio.page.waitForFunction(() => !document.querySelector("#find-hints") && !/Looking/.test(document.querySelector(".hint-list").textContent));
  assert.notDeepEqual(await studio.page.locator(limb).allInnerTexts(), reasons);
});

test("what the quads have lost of the shape is a hint too: the pointer shows what it would make, a click makes it", async () => {
  await studio.upload(studio.shape("l-shape", 1500));
  await studio.suggest();
  await studio.tab("check");
  const edge = studio.page.locator('[data-hint="lost_edge"]'), place = studio.page.locator('[data-hint="lost_place"]');
  await place.first().waitFor();
  assert.match(await place.first().innerText(), /cut the surface off.*add (maximum|minimum)/s);
  assert.match(await edge.first().innerText(), /sharp edges.*(fit texture|snap contour)/s);
  await place.first().hover();
  // The contours that the edit would make, drawn over all else.
  await studio.page.waitForFunction(() => window.studio.viewport.scene.children.some((o) => o.renderOrder === 8 && o.visible && o.isLineSegments2));
  await studio.picture("hint_lost");
  const { applied } = await studio.state(), state = await studio.after(() => place.first().click());
  assert.equal(state.applied, applied + 1);
  assert.equal(state.history.at(-1).edit.edit, "add_extremum");
  assert.equal(state.certificate.passed, true);
});

test("the page reported no errors", () => assert.deepEqual(studio.errors, []));
