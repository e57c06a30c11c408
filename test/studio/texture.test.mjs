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

test("the camera frames the chart that opens", async () => {
  await studio.landed();
  const part = await studio.page.evaluate(() => {
    const { stage, store, viewport } = window.studio, points = stage.surface.pointsOf(store.get("chart")), box = viewport.canvas.getBoundingClientRect();
    const at = Array.from({ length: points.length / 3 }, (_, i) => viewport.project(viewport.controls.target.clone().fromArray(points, 3 * i), box));
    const xs = at.map((p) => p.x - box.x), ys = at.map((p) => p.y - box.y);
    return { inside: Math.min(...xs) >= 0 && Math.max(...xs) <= box.width && Math.min(...ys) >= 0 && Math.max(...ys) <= box.height, most: Math.max((Math.max(...xs) - Math.min(...xs)) / box.width, (Math.max(...ys) - Math.min(...ys)) / box.height) };
  });
  assert.ok(part.inside && part.most > 0.5, JSON.stringify(part));
});

const boxOf = (selector) => studio.page.locator(selector).boundingBox();
const overlap = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

test("the chart lies beside the model, and nothing lies over either; the bar between them is dragged, or moved by keys, and is kept", async () => {
  const apart = async () => {
    const [model, chart, box] = await Promise.all([".canvas", ".chart-view", ".tool-box"].map(boxOf));
    for (const [a, b] of [[model, chart], [model, box], [chart, box]]) assert.ok(!overlap(a, b), JSON.stringify([a, b]));
    return { model, chart };
  };
  const before = await apart(), bar = await boxOf(".split");
  await studio.page.mouse.move(bar.x + 3, bar.y + 100);
  await studio.page.mouse.down();
  await studio.page.mouse.move(bar.x - 97, bar.y + 100, { steps: 4 });
  await studio.page.mouse.up();
  const wider = await apart();
  assert.ok(Math.abs(wider.chart.width - before.chart.width - 100) < 5 && wider.model.width < before.model.width - 90);
  await studio.page.focus(".split");
  await studio.page.keyboard.press("ArrowRight");
  assert.ok((await boxOf(".chart-view")).width < wider.chart.width - 10);
  await studio.page.waitForFunction(() => window.studio.viewport.canvas.clientWidth === window.studio.viewport.host.clientWidth);
  await studio.page.setViewportSize({ width: 1024, height: 640 });
  const small = await apart();
  assert.ok(small.model.width > 280 && small.chart.width > 240 && small.model.height > 400, JSON.stringify(small));
  await studio.picture("texture_1024");
  await studio.page.setViewportSize({ width: 1400, height: 860 });
  await studio.picture("texture_docked");
  assert.ok(Math.abs((await studio.page.evaluate(() => window.studio.preferences.get("split"))) - 0.45) > 0.01);
});

test("the chart has its true proportions, grows by the wheel around the pointer, and is moved by the right button", async () => {
  const shape = await studio.page.evaluate(() => {
    const { chartView } = window.studio, t = chartView.texture, ratios = [];
    for (let q = 0; q < t.size; ++q) {
      const space = t.cornersInSpace(q), s = chartView.scale(t), flat = t.corners(q).map(([v, u]) => [s.x(v), s.y(u)]);
      const onScreen = (a, b) => Math.hypot(flat[a][0] - flat[b][0], flat[a][1] - flat[b][1]);
      ratios.push(onScreen(0, 1) / onScreen(1, 2) / (space[0].distanceTo(space[1]) / space[1].distanceTo(space[2])));
    }
    return ratios.sort((a, b) => a - b)[ratios.length >> 1];
  });
  assert.ok(shape > 0.75 && shape < 1.33, `${shape}`);
  const { vertex, plane } = await innerVertex(), place = () => studio.page.evaluate((v) => window.studio.chartView.screen(v), vertex);
  const scale = () => studio.page.evaluate(() => window.studio.chartView.scale(window.studio.chartView.texture).a);
  const first = await scale();
  await studio.page.mouse.move(plane.x, plane.y);
  await studio.page.mouse.wheel(0, -500);
  await studio.page.waitForFunction((a) => window.studio.chartView.scale(window.studio.chartView.texture).a > 1.5 * a, first);
  const grown = await place();
  assert.ok(Math.hypot(grown.x - plane.x, grown.y - plane.y) < 1, "what is under the pointer stays there");
  await studio.page.mouse.down({ button: "right" });
  await studio.page.mouse.move(plane.x + 30, plane.y - 20, { steps: 3 });
  await studio.page.mouse.up({ button: "right" });
  const moved = await place();
  assert.ok(Math.hypot(moved.x - grown.x - 30, moved.y - grown.y + 20) < 2, JSON.stringify([grown, moved]));
  await studio.picture("texture_enlarged");
  await studio.page.focus(".chart-view canvas");
  await studio.page.keyboard.press("0");
  assert.ok(Math.abs((await scale()) / first - 1) < 0.01);
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
