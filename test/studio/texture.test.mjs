// SPDX-License-Identifier: GPL-3.0-or-later
// The texture of one chart, edited in its unit square and on the surface; and the recipe repeats it.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import test, { after, before } from "node:test";
import { reebquad, Studio } from "./harness.mjs";

let studio, mesh, tube;
before(async () => {
  studio = await Studio.start();
  mesh = studio.shape("bitorus", 3000);
  await studio.upload(mesh);
  await studio.suggest();
  await studio.page.fill("#quads", "900");
  await studio.after(() => studio.page.press("#quads", "Enter"));
});
after(() => studio.close());

const edits = async () => (await studio.state()).history.map((step) => step.edit);
const quadsOfChart = () => studio.page.evaluate(() => window.studio.chartView.texture.size);
const operator = (id) => studio.page.click(`[data-operator="${id}"]`);

/** Waits until the texture that is shown is the one of the state. */
async function shown(action) {
  const before = await studio.page.evaluateHandle(() => window.studio.chartView.texture);
  const state = await studio.after(action);
  await studio.page.waitForFunction((old) => window.studio.chartView.texture !== old, before);
  await studio.settle();
  return state;
}

/** An inner vertex of the texture: its index, where it is in the plane on the screen, and on the surface. */
const innerVertex = (turn = 0.5) =>
  studio.page.evaluate((part) => {
    const { chartView } = window.studio, t = chartView.texture;
    const inner = [...new Set(t.quads)].filter((v) => {
      const [x, y] = t.inPlane(v);
      return x > 0.15 && x < t.width - 0.15 && y > 0.15 && y < t.height - 0.15;
    });
    const vertex = inner[Math.floor(part * inner.length)];
    return { vertex, plane: chartView.screen(vertex), space: t.inSpace(vertex).toArray() };
  }, turn);

/** The middle of an edge between two inner vertices, in the plane on the screen. */
const innerEdge = () =>
  studio.page.evaluate(() => {
    const { chartView } = window.studio, t = chartView.texture;
    for (let q = Math.floor(t.size / 2); q < t.size; ++q)
      for (let c = 0; c < 4; ++c) {
        const a = t.quads[4 * q + c], b = t.quads[4 * q + ((c + 1) % 4)];
        const [p, r] = [t.inPlane(a), t.inPlane(b)];
        const isInside = [p, r].every(([x, y]) => x > 0.1 && x < t.width - 0.1 && y > 0.1 && y < t.height - 0.1);
        const [s, e] = [chartView.screen(a), chartView.screen(b)];
        if (isInside && Math.abs(s.y - e.y) < 2) return { x: (s.x + e.x) / 2, y: (s.y + e.y) / 2 + 1 };
      }
    return null;
  });

test("a click on a chart opens it beside its square", async () => {
  tube = (await studio.state()).facts.charts.filter((c) => c.kind === "annulus").sort((a, b) => b.height - a.height)[0];
  await studio.tool("texture");
  assert.match(await studio.page.innerText(".hint-line"), /Click a chart/);
  const inside = await studio.page.evaluate((id) => window.studio.stage.surface.insideOf(id).toArray(), tube.id);
  await studio.clickOn(inside, 1.6);
  await studio.page.waitForSelector(".chart-view:not([hidden])");
  assert.equal(await quadsOfChart(), tube.columns * tube.rows);
  assert.match(await studio.page.innerText(".hint-line"), /Drag a vertex/);
});

test("hovering shines in both views", async () => {
  await operator("rotate_edge");
  const at = await innerEdge();
  await studio.page.mouse.move(at.x, at.y);
  assert.equal(await studio.page.evaluate(() => window.studio.chartView.glow.object.visible), true);
  await studio.picture("texture_hover_edge");
});

test("an edge is turned by a click in the square", async () => {
  const at = await innerEdge();
  const state = await shown(() => studio.page.mouse.click(at.x, at.y));
  assert.equal((await edits()).at(-1).operator, "rotate_edge");
  assert.equal(state.certificate.passed, true);
  assert.ok(state.budget.interior["5"] >= 2 && state.budget.interior["3"] >= 2);
  await studio.picture("texture_turned_edge");
});

test("a vertex is dragged with a brush in the square: one step, live", async () => {
  await operator("drag");
  await studio.page.fill("#brush", "2");
  const { plane, space } = await innerVertex();
  const steps = (await edits()).length;
  await shown(async () => {
    await studio.page.mouse.move(plane.x, plane.y);
    await studio.page.mouse.down();
    for (let i = 1; i <= 5; ++i) {
      await studio.page.mouse.move(plane.x + 2 * i, plane.y + 2 * i);
      await studio.settle();
    }
    await studio.page.mouse.up();
  });
  await studio.page.waitForFunction(() => window.studio.store.get("state").history.at(-1).edit.edit === "drag_vertices" && !window.studio.store.get("busy"));
  assert.equal((await edits()).length, steps + 1);
  const { points, to } = (await edits()).at(-1);
  assert.ok(Math.hypot(...points[0].point.map((x, i) => x - to.point[i])) > 0.01);
  assert.ok(space.length === 3);
  await studio.picture("texture_dragged");
});

test("a vertex is dragged on the surface, and an anchor stays", async () => {
  const first = await innerVertex(0.3), other = await innerVertex(0.7);
  await operator("anchor");
  await studio.page.mouse.click(other.plane.x, other.plane.y);
  await operator("drag");
  await studio.face(first.space, 1.4);
  const from = await studio.screen(first.space);
  const steps = (await edits()).length;
  await shown(async () => {
    await studio.page.mouse.move(from.x, from.y);
    await studio.page.mouse.down();
    await studio.page.mouse.move(from.x + 6, from.y + 5);
    await studio.page.mouse.move(from.x + 12, from.y + 9);
    await studio.page.mouse.up();
  });
  const all = await edits();
  assert.equal(all.length, steps + 1);
  assert.equal(all.at(-1).anchors.length, 1);
  const after = await studio.page.evaluate((v) => window.studio.chartView.texture.inSpace(v).toArray(), other.vertex);
  assert.ok(Math.hypot(...after.map((x, i) => x - other.space[i])) < 1e-4);
  await studio.picture("texture_on_the_surface");
});

test("a strip is inserted and the chart subdivided", async () => {
  await operator("insert_polychord");
  const at = await innerEdge();
  const quads = await quadsOfChart();
  const inserted = await shown(() => studio.page.mouse.click(at.x, at.y));
  assert.ok((await quadsOfChart()) > quads);
  assert.equal(inserted.certificate.passed, true);
  const before = await quadsOfChart();
  await shown(() => operator("subdivide"));
  assert.equal(await quadsOfChart(), 4 * before);
  await studio.picture("texture_subdivided");
  await shown(() => studio.page.keyboard.press("Control+z"));
});

test("what is impossible is refused with its reason and changes nothing", async () => {
  await operator("remove_doublet");
  const { plane } = await innerVertex(0.5);
  const { revision } = await studio.state();
  await studio.page.mouse.click(plane.x, plane.y);
  await studio.told(/did not work/i);
  assert.equal((await studio.state()).revision, revision);
  await studio.picture("texture_refused");
});

test("five are undone and redone", async () => {
  const last = await studio.state();
  for (let i = 0; i < 5; ++i) await studio.after(() => studio.page.keyboard.press("Control+z"));
  for (let i = 0; i < 5; ++i) await studio.after(() => studio.page.keyboard.press("Control+Shift+z"));
  assert.deepEqual((await studio.state()).statistics, last.statistics);
});

test("the recipe repeats it byte for byte", async () => {
  const quads = await studio.download(() => studio.page.click("#export"));
  const recipe = await studio.download(() => studio.page.click("#recipe"));
  writeFileSync(studio.path("texture.json"), recipe);
  reebquad("replay", mesh, studio.path("texture.json"), "-o", studio.path("texture.obj"), "--quiet");
  assert.ok(quads.equals(readFileSync(studio.path("texture.obj"))));
});

test("a texture is fitted to the sharp edges in its chart", async () => {
  await studio.page.keyboard.press("Escape");
  await studio.upload(studio.shape("twisted-bar", 3000));
  await studio.suggest();
  tube = (await studio.state()).facts.charts.filter((c) => c.kind === "annulus").sort((a, b) => b.height - a.height)[0];
  await studio.tool("texture");
  const inside = await studio.page.evaluate((id) => window.studio.stage.surface.insideOf(id).toArray(), tube.id);
  await studio.clickOn(inside, 1.6);
  await studio.page.waitForSelector(".chart-view:not([hidden])");
  const state = await shown(() => operator("fit"));
  assert.equal((await edits()).at(-1).edit, "fit_texture");
  assert.equal(state.certificate.passed, true);
  await studio.picture("texture_fitted");
});

test("the page reported no errors", () => assert.deepEqual(studio.errors, []));
