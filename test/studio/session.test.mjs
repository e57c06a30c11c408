// SPDX-License-Identifier: GPL-3.0-or-later
// From a file to quads and back: open, suggest, change the counts, undo, redo, lose the program, export.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import test, { after, before } from "node:test";
import { Studio } from "./harness.mjs";

let studio;
before(async () => (studio = await Studio.start()));
after(() => studio.close());

test("the page says what to do while nothing is open", async () => {
  await studio.page.waitForSelector("text=From a surface to quads");
  await studio.picture("welcome_dark");
  assert.equal(await studio.page.isDisabled("#export"), true);
});

test("the token is gone from the address bar", () => assert.ok(!studio.page.url().includes("token")));

test("what is no mesh is refused with a sentence", async () => {
  writeFileSync(studio.path("broken.obj"), "f 1 2 3\n");
  await studio.page.setInputFiles("#file-input", studio.path("broken.obj"));
  await studio.told(/line 1/);
});

test("a mesh is opened by upload", async () => {
  const state = await studio.upload(studio.shape("hand", 6000));
  assert.equal(state.file.genus, 0);
  assert.match(await studio.page.innerText(".status"), /hand\.off/);
  assert.equal(await studio.page.isDisabled('[data-tool="subdivide"]'), true); // before there is a design
  await studio.picture("surface");
});

test("the suggestion gives certified quads", async () => {
  const state = await studio.suggest();
  assert.ok(state.statistics.quads > 2000);
  assert.equal(state.certificate.passed, true);
  assert.equal(await studio.page.getAttribute("[data-light]", "data-light") !== "red", true);
  await studio.picture("quads");
});

test("every view shows something else", async () => {
  const seen = new Set();
  for (const view of ["surface", "field", "atlas", "quads", "quality"]) {
    await studio.view(view);
    seen.add(await studio.drawn());
    await studio.picture(`view_${view}`);
  }
  assert.equal(seen.size, 5);
});

test("keys switch layers", async () => {
  await studio.view("atlas");
  await studio.page.keyboard.press("7");
  assert.equal(await studio.page.getAttribute('[data-layer="reeb"]', "aria-checked"), "true");
  await studio.picture("reeb_graph");
  await studio.page.keyboard.press("x");
  await studio.picture("xray");
  await studio.page.keyboard.press("x");
  await studio.page.keyboard.press("7");
  await studio.page.keyboard.press("?");
  await studio.picture("keys");
  await studio.page.keyboard.press("Escape");
});

test("every layer can be seen", async () => {
  const ids = await studio.page.evaluate(() => [...document.querySelectorAll("[data-layer]")].map((e) => e.dataset.layer));
  assert.equal(ids.length, 14);
  await studio.tab("layers");
  await studio.page.waitForFunction(() => window.studio.store.get("deviation"));
  for (const id of ids) {
    await studio.view(id === "valences" || id === "quads" ? "surface" : id === "surface" ? "quads" : "surface");
    const before = await studio.drawn();
    await studio.page.click(`[data-layer="${id}"]`);
    assert.notEqual(await studio.drawn(), before, id);
    await studio.picture(`layer_${id}`);
  }
});

test("a bar of the histogram lights its quads", async () => {
  await studio.view("quality");
  await studio.tab("check");
  const before = await studio.drawn();
  await studio.page.locator(".bar:not([disabled])").last().click();
  assert.notEqual(await studio.drawn(), before);
  await studio.picture("quality_lit");
  await studio.page.locator(".bar:not([disabled])").first().click(); // few, which are seen from everywhere
  const segments = () => studio.page.evaluate(() => { const { litEdges } = window.studio.stage.quads; return litEdges.object.visible ? litEdges.segments : 0; });
  assert.ok((await segments()) >= 4);
  await studio.picture("quality_worst");
  await studio.page.locator(".bar.chosen").click();
  assert.equal(await segments(), 0);
});

test("counts, undo and redo", async () => {
  await studio.tab("design");
  await studio.page.fill("#quads", "1200");
  const fewer = await studio.after(() => studio.page.press("#quads", "Enter"));
  assert.ok(Math.abs(fewer.statistics.quads - 1200) < 200);
  const undone = await studio.after(() => studio.page.click("#undo"));
  assert.ok(undone.statistics.quads > 2000);
  const redone = await studio.after(() => studio.page.click("#redo"));
  assert.equal(redone.statistics.quads, fewer.statistics.quads);
  await studio.tab("history");
  const first = await studio.after(() => studio.page.click('[data-step="1"]'));
  assert.equal(first.applied, 1);
  await studio.after(() => studio.page.click('[data-step="2"]'));
});

test("the certificate runs all its checks", async () => {
  const state = await studio.after(() => studio.page.click(".certificate"));
  const names = state.certificate.checks.filter((c) => c.status === "not_checked").map((c) => c.name);
  assert.ok(!names.includes("no_self_intersections"), names.join());
});

test("a page that is loaded anew finds the session", async () => {
  const quads = (await studio.state()).statistics.quads;
  await studio.page.reload();
  await studio.page.waitForFunction(() => window.studio?.store.get("state")?.statistics);
  assert.equal((await studio.state()).statistics.quads, quads);
});

test("a program that was killed offers the session and exports the same bytes", async () => {
  const before = await studio.download(() => studio.page.click("#export"));
  await studio.stopProgram("SIGKILL");
  await studio.startProgram();
  await studio.page.goto(studio.url);
  await studio.page.click("#restore");
  await studio.page.waitForFunction(() => window.studio?.store.get("state")?.statistics);
  await studio.page.waitForFunction(() => !window.studio.store.get("busy"));
  assert.ok(before.equals(await studio.download(() => studio.page.click("#export"))));
});

test("the light theme", async () => {
  await studio.page.click("#theme");
  await studio.view("field");
  await studio.picture("light_field");
  await studio.view("quads");
  await studio.picture("light_quads");
});

test("the camera is moved by keys and by two fingers on a touchpad", async () => {
  const camera = () => studio.page.evaluate(() => {
    const { camera, controls } = window.studio.viewport;
    return { target: controls.target.toArray(), distance: camera.position.distanceTo(controls.target), direction: camera.position.clone().sub(controls.target).normalize().toArray() };
  });
  const far = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));
  const after = async (act) => {
    await act();
    await studio.settle();
    return camera();
  };
  const { keyboard, mouse } = studio.page;
  await studio.home();
  await studio.page.focus(".canvas canvas");
  const begin = await camera(), turned = await after(() => keyboard.press("Shift+ArrowLeft"));
  assert.ok(far(turned.direction, begin.direction) > 0.01);
  const moved = await after(() => keyboard.press("ArrowLeft"));
  assert.ok(far(moved.target, turned.target) > 0.001);
  const near = await after(() => keyboard.press("+"));
  assert.ok(near.distance < 0.95 * moved.distance);
  await mouse.move(600, 400);
  const slid = await after(() => mouse.wheel(60, 4));
  assert.ok(far(slid.target, near.target) > 0.01 && Math.abs(slid.distance - near.distance) < 0.01 * near.distance);
  const zoomed = await after(() => mouse.wheel(0, -200));
  assert.ok(zoomed.distance < slid.distance);
  await mouse.dblclick(600, 430);
  await studio.landed();
  const focused = await camera();
  assert.ok(far(focused.target, zoomed.target) > 0.01 && focused.distance < zoomed.distance);
  await studio.home();
});

test("the page stays usable at 200 %", async () => {
  for (const [name, width, height] of [["narrow", 700, 860], ["enlarged", 700, 430]]) {
    await studio.page.setViewportSize({ width, height });
    await studio.tool("plane");
    await studio.home();
    await studio.picture(name);
    for (const control of ["#open", "#export", "#apply-plane", '[data-view="quality"]']) assert.ok(await studio.page.isVisible(control), control);
    const canvas = await studio.page.locator(".canvas").boundingBox(), box = await studio.page.locator(".tool-box").boundingBox();
    assert.ok(canvas.width > 400 && canvas.height > 300, JSON.stringify(canvas));
    assert.ok(box.y + box.height <= height, "the tool's controls are all in sight");
    assert.ok(box.x >= canvas.x + canvas.width || box.y >= canvas.y + canvas.height, "and beside the model");
    await studio.tool("select");
  }
});

test("the page reported no errors", () => assert.deepEqual(studio.errors.filter((e) => !/WebSocket|ERR_CONNECTION|422/.test(e)), []));
