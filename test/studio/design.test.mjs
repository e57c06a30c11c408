// SPDX-License-Identifier: GPL-3.0-or-later
// A design made by mouse and keys: contours, saddles, charts, counts; refused edits; undo; and the recipe repeats it.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import test, { after, before } from "node:test";
import { reebquad, Studio } from "./harness.mjs";

let studio, mesh;
/** A point of a contour between two others of a tube: unlike that of a cap it can be deleted. */
let added;
before(async () => {
  studio = await Studio.start();
  mesh = studio.shape("torus", 4000);
});
after(() => studio.close());

/** Positions of the critical points of a kind (0 minimum, 1 saddle, 2 maximum). */
const critical = (kind) =>
  studio.page.evaluate((k) => window.studio.stage.critical.filter((c) => c.kind === k).map((c) => c.position.toArray()), kind);

/** A point in the middle of a contour of that kind. */
const contour = (kind) =>
  studio.page.evaluate((k) => {
    const found = window.studio.stage.contours.find((c) => c.kind === k);
    return found && found.points[found.points.length >> 1].toArray();
  }, kind);

/** Waits until the program has said what the plane would take. */
const answered = () => studio.page.waitForFunction(() => window.studio.tools.current.isAnswered);

const history = async () => (await studio.state()).history.map((step) => step.edit.edit);

test("a torus and its suggestion", async () => {
  const file = await studio.upload(mesh);
  assert.equal(file.file.genus, 1);
  const state = await studio.suggest();
  assert.equal(state.certificate.passed, true);
  assert.equal((await critical(1)).length, 2);
  await studio.view("atlas");
  await studio.picture("torus_atlas");
});

test("the pointer shows which contour a click would draw; the click draws that", async () => {
  const charts = (await studio.state()).facts.charts.length;
  await studio.tool("subdivide");
  const point = await studio.insideTallestTube();
  await studio.face(point);
  const { x, y } = await studio.screen(point);
  await studio.page.mouse.move(x, y);
  await studio.page.waitForFunction(() => window.studio.tools.current.preview?.curve.object.visible);
  const shown = await studio.page.evaluate(() => {
    const { instanceStart } = window.studio.tools.current.preview.curve.object.geometry.attributes;
    return Array.from({ length: instanceStart.count }, (_, i) => [instanceStart.getX(i), instanceStart.getY(i), instanceStart.getZ(i)].join());
  });
  await studio.picture("subdivide_preview");
  const state = await studio.after(() => studio.page.mouse.click(x, y));
  assert.equal(state.facts.charts.length, charts + 1);
  const drawn = await studio.page.evaluate(() => window.studio.stage.contours.filter((c) => c.kind === "regular").map((c) => c.points.map((p) => p.toArray().join())));
  const same = drawn.find((points) => shown.every((p) => points.includes(p)));
  assert.ok(same, "the contour is the one that was shown");
  added = same[same.length >> 1].split(",").map(Number);
  assert.equal(await studio.page.evaluate(() => window.studio.tools.current.preview.curve.object.visible), false);
  await studio.picture("subdivided");
});

test("contours without saddles look different, and tools that take these alone light no other", async () => {
  const segments = await studio.page.evaluate(() => {
    const { stage } = window.studio;
    return { light: stage.freeLines.segments, free: stage.contours.filter((c) => c.kind === "regular").reduce((sum, c) => sum + c.points.length - 1, 0), all: stage.contourLines.segments, shown: stage.freeLines.object.visible };
  });
  assert.ok(segments.shown && segments.light === segments.free && segments.free < segments.all, JSON.stringify(segments));
  await studio.tool("drag");
  const lit = async (kind) => {
    const at = await contour(kind);
    await studio.face(at, kind === "saddle" ? 0.5 : 2.6); // from inside the hole
    const { x, y } = await studio.screen(at);
    await studio.page.mouse.move(x + 1, y);
    assert.equal(await studio.page.evaluate(([x, y]) => window.studio.stage.contourAt({ clientX: x, clientY: y })?.kind, [x, y]), kind);
    return studio.page.evaluate(() => window.studio.stage.chosenContour.object.visible);
  };
  assert.equal(await lit("regular"), true);
  assert.equal(await lit("saddle"), false);
});

test("a contour that is chosen is deleted by a button, or by a key", async () => {
  const { length } = (await studio.state()).facts.charts;
  await studio.tool("select");
  for (const remove of [() => studio.page.click("#delete-chosen"), () => studio.page.keyboard.press("Delete")]) {
    await studio.clickOn(added);
    await studio.page.evaluate(() => window.studio.store.set("state", { ...window.studio.store.get("state") })); // as when other work ends
    assert.match(await studio.page.innerText(".hint-line"), /Delete/);
    assert.equal(await studio.page.evaluate(() => window.studio.stage.chosenContour.object.visible), true);
    await studio.picture("contour_chosen");
    const state = await studio.after(remove);
    assert.equal((await history()).at(-1), "remove_contour");
    assert.equal(state.facts.charts.length, length - 1);
    await studio.after(() => studio.page.keyboard.press("Control+z"));
  }
  // That of a saddle cannot go.
  await studio.clickOn(await contour("saddle"), 0.5);
  assert.equal(await studio.page.isDisabled("#delete-chosen"), true);
});

test("a contour is dragged, and one drag is one step", async () => {
  await studio.tool("drag");
  const steps = (await history()).length;
  const from = await studio.page.evaluate(() => {
    const c = window.studio.stage.contours.filter((c) => c.kind === "regular").sort((a, b) => b.points.length - a.points.length)[0];
    return c.points[c.points.length >> 1].toArray();
  });
  await studio.face(from);
  const { x, y } = await studio.screen(from);
  await studio.after(async () => {
    await studio.page.mouse.move(x, y);
    await studio.page.mouse.down();
    for (let i = 1; i <= 4; ++i) await studio.page.mouse.move(x + 3 * i, y + 2 * i);
    await studio.page.mouse.up();
  });
  assert.ok((await history()).length <= steps + 1);
});

test("a contour is moved by the plane", async () => {
  await studio.tool("plane");
  const at = await contour("regular");
  await studio.clickOn(at);
  await studio.page.waitForSelector("#apply-plane:not([disabled])");
  await studio.picture("plane_widget");
  const steps = (await history()).length;
  await studio.page.evaluate(() => {
    const tool = window.studio.tools.current;
    tool.turn(0.12);
  });
  const state = await studio.after(() => studio.page.keyboard.press("Enter"));
  assert.equal((await history()).length, steps + 1);
  assert.equal(state.certificate.passed, true);
});

test("an impossible place is red and says why, and applying it changes nothing", async () => {
  const at = await contour("regular");
  await studio.clickOn(at);
  await studio.page.waitForSelector("#apply-plane:not([disabled])");
  const { revision } = await studio.state();
  // Shifted on and on, until the contours there are in the way.
  for (let i = 0; i < 12 && (await studio.page.locator(".hint-line.bad").count()) === 0; ++i) {
    await studio.page.evaluate(() => window.studio.tools.current.shift(0.1 * window.studio.tools.current.plane.scale.x));
    await answered();
  }
  await studio.page.waitForSelector(".hint-line.bad");
  assert.match(await studio.page.innerText(".hint-line"), /refused/);
  await studio.picture("plane_refused");
  await studio.page.keyboard.press("Enter");
  await studio.told(/did not work.*Nothing was changed: try another place/is);
  assert.equal((await studio.state()).revision, revision);
  // Where it is: the camera flies there, the place is marked, and the mark goes with the message.
  const marks = () => studio.page.evaluate(() => window.studio.viewport.scene.children.filter((o) => o.isPoints && o.renderOrder === 11).length);
  await studio.page.hover(".toast"); // while the pointer is on it it stays
  await studio.page.locator(".toast button", { hasText: "Show" }).click();
  assert.equal(await marks(), 1);
  await studio.picture("refused_where");
  await studio.page.locator(".toast button[aria-label=Dismiss]").click();
  assert.equal(await marks(), 0);
});

test("a refusal lets flash what stands in the way and offers what works; the offer is one step, which can be undone", async () => {
  const { revision } = await studio.state(), steps = await history();
  await studio.page.keyboard.press("Enter"); // the plane is still where it was refused
  await studio.told(/did not work/i);
  assert.match(await studio.page.evaluate(() => window.studio.flash.last), /^(contour|vertex|chart) \d+$/);
  const offer = studio.page.locator(".toast .remedy");
  await offer.waitFor();
  assert.equal(await offer.count(), 1);
  assert.match(await offer.innerText(), /instead$/);
  await offer.hover();
  await studio.page.waitForFunction(() => window.studio.remedy.preview.curve.object.visible); // what it would make
  await studio.picture("offer");
  assert.equal((await studio.state()).revision, revision);
  const name = await offer.getAttribute("data-offer"), state = await studio.after(() => offer.click());
  assert.deepEqual(await history(), [...steps.slice(0, state.applied - 1), name]);
  assert.equal(state.certificate.passed, true);
  assert.equal(await studio.page.locator(".toast.bad").count(), 0);
  const back = await studio.after(() => studio.page.keyboard.press("Control+z"));
  assert.equal(back.applied, state.applied - 1);
});

test("a saddle is moved with all its contours, however the plane is tilted", async () => {
  await studio.page.keyboard.press("Escape");
  await studio.tool("plane");
  await studio.page.click('[data-choice="saddle"]');
  const [saddle] = await critical(1), distance = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));
  const pressed = () => studio.page.evaluate(() => window.studio.tools.current.held?.saddle?.vertex ?? -1);
  await studio.clickOn(saddle, 0.5); // from inside the hole
  assert.ok((await pressed()) >= 0);
  await studio.lookAt(saddle, (await studio.normalAt(saddle)).map((x, i) => x + (i === 2 ? 0.5 : 0)), 1.2);
  const { x, y } = await studio.screen(saddle);
  await studio.page.mouse.move(x, y);
  await studio.page.mouse.down();
  for (let i = 1; i <= 4; ++i) await studio.page.mouse.move(x + 9 * i, y);
  await studio.page.mouse.up();
  await answered();
  const { charts, contours } = await studio.page.evaluate(async () => {
    const tool = window.studio.tools.current;
    return window.studio.connection.request("preview", { edit: tool.edit(tool.held) });
  });
  assert.equal(charts, (await studio.state()).facts.charts.length);
  assert.equal(contours.length, 2); // both loops
  await studio.picture("saddle_moves");
  // Tilted far, its contours still follow; then it touches again.
  await studio.page.evaluate(() => window.studio.tools.current.turn(1.2));
  await answered();
  assert.equal(await studio.page.locator(".hint-line.bad").count(), 0);
  await studio.picture("saddle_tilted");
  await studio.page.keyboard.press("n");
  await answered();
  const state = await studio.after(() => studio.page.keyboard.press("Enter"));
  assert.equal((await history()).at(-1), "move_saddle");
  assert.equal(state.certificate.passed, true);
  const drawn = await studio.page.evaluate(() => window.studio.stage.contours.map((c) => c.points.map((p) => p.toArray()).flat()));
  for (const contour of contours) assert.ok(drawn.some((c) => c.length === contour.length && c.every((v, i) => v === Math.fround(contour[i]))), "as it was shown");
  const moved = (await critical(1)).map((p) => distance(p, saddle)).sort((a, b) => a - b)[0];
  assert.ok(moved > 0.03, `${moved}`);
  const undone = await studio.after(() => studio.page.keyboard.press("Control+z"));
  assert.equal(undone.applied, state.applied - 1);
  assert.ok((await critical(1)).some((p) => distance(p, saddle) === 0));
  await studio.after(() => studio.page.keyboard.press("Control+Shift+z"));
  // A key changes what is taken: of a saddle one of its loops.
  await studio.page.keyboard.press("l");
  assert.equal(await studio.page.getAttribute('[data-choice="contour"]', "aria-checked"), "true");
});

test("a saddle becomes two half-saddles", async () => {
  await studio.tool("saddle", "Halves");
  const [saddle] = await critical(1);
  const state = await studio.after(() => studio.clickOn(saddle, 0.5)); // from inside the hole
  assert.equal((await critical(3)).length, 2);
  assert.equal(state.budget.interior["6"], 2);
  await studio.lookAt(saddle, (await studio.normalAt(saddle)).map((x, i) => x + (i === 2 ? 0.6 : 0)), 1.6);
  await studio.picture("half_saddles");
});

test("a pole becomes a seam", async () => {
  await studio.tool("pole", "Halves");
  const [maximum] = await critical(2);
  const state = await studio.after(() => studio.clickOn(maximum));
  assert.equal(state.budget.interior["2"], 2);
  await studio.view("quads");
  await studio.picture("half_pole");
});

test("counts of a chart by its box, and its texture beside it", async () => {
  await studio.tool("select");
  const tube = (await studio.state()).facts.charts.filter((c) => c.kind === "annulus").sort((a, b) => b.height - a.height)[0];
  await studio.page.click(`[data-chart="${tube.id}"]`);
  await studio.page.fill("#rows", String(tube.rows + 3));
  const state = await studio.after(() => studio.page.press("#rows", "Enter"));
  assert.equal(state.facts.charts.find((c) => c.id === tube.id).rows, tube.rows + 3);
  await studio.page.click("#open-texture");
  await studio.page.waitForSelector(".chart-view:not([hidden])");
  assert.equal(await studio.page.evaluate(() => window.studio.store.get("chart")), tube.id);
  await studio.face(await studio.insideTallestTube());
  await studio.page.hover(".chart-view canvas");
  await studio.picture("chart_view");
});

test("five are undone and redone", async () => {
  const last = await studio.state();
  assert.ok(last.applied >= 5);
  for (let i = 0; i < 5; ++i) await studio.after(() => studio.page.keyboard.press("Control+z"));
  assert.equal((await studio.state()).applied, last.applied - 5);
  for (let i = 0; i < 5; ++i) await studio.after(() => studio.page.keyboard.press("Control+Shift+z"));
  const again = await studio.state();
  assert.equal(again.applied, last.applied);
  assert.deepEqual(again.statistics, last.statistics);
});

test("a whole pole has a fan of triangles", async () => {
  await studio.tool("pole", "Whole");
  const [minimum] = await critical(0);
  const state = await studio.after(() => studio.clickOn(minimum));
  assert.match(state.facts.fans, /1 whole pole/);
  assert.equal(state.certificate.passed, true);
  await studio.view("quads");
  await studio.face(minimum);
  await studio.picture("whole_pole");
});

test("what changed of the layers, put in edit by edit, makes what a new page is sent", async () => {
  // But the chart's own, and the deviation, which comes when it has been measured.
  const layers = () => studio.page.evaluate(() => [...window.studio.connection.layers.values()].filter((f) => f.layer !== "chart" && f.layer !== "deviation").map((frame) => {
    let hash = 0;
    for (const array of frame.arrays.values()) for (const byte of new Uint8Array(array.buffer, array.byteOffset, array.byteLength)) hash = (31 * hash + byte) | 0;
    return `${frame.layer} ${[...frame.arrays].map(([name, array]) => `${name}: ${array.length}`).join(" ")} ${hash}`;
  }).sort());
  const patched = await layers();
  await studio.page.reload();
  await studio.page.waitForFunction(() => window.studio?.store.get("state")?.finished);
  assert.equal(patched.length, 9);
  assert.deepEqual(await layers(), patched);
});

test("the exported quads are those of the replayed recipe, byte for byte", async () => {
  await studio.page.reload();
  await studio.page.waitForFunction(() => window.studio?.store.get("state")?.finished);
  const quads = await studio.download(() => studio.page.click("#export"));
  const recipe = await studio.download(() => studio.page.click("#recipe"));
  writeFileSync(studio.path("saved.json"), recipe);
  const made = JSON.parse(recipe).edits.map((edit) => edit.edit);
  for (const edit of ["move_contour", "move_saddle", "split_saddle", "split_pole"]) assert.ok(made.includes(edit), edit);
  reebquad("replay", mesh, studio.path("saved.json"), "-o", studio.path("replayed.obj"), "--quiet");
  assert.ok(quads.equals(readFileSync(studio.path("replayed.obj"))));
});

test("the torus of figure 9 has no extraordinary vertex", async () => {
  await studio.tab("history");
  await studio.page.click('[data-step="1"]');
  await studio.page.waitForFunction(() => {
    const state = window.studio.store.get("state");
    return state.applied === 1 && state.finished;
  });
  const extrema = [...(await critical(0)), ...(await critical(2))];
  await studio.tool("saddle", "Halves");
  for (const saddle of await critical(1)) await studio.after(() => studio.clickOn(saddle, 0.5));
  await studio.tool("saddle", "Make regular");
  let state;
  for (const tip of extrema) state = await studio.after(() => studio.clickOn(tip));
  assert.deepEqual(Object.keys(state.budget.interior), ["4"]);
  await studio.view("quads");
  await studio.lookAt([0, 0, 0], [0.3, 0.2, 1], 4);
  await studio.picture("torus_of_figure_9");
});

test("the page reported no errors", () => assert.deepEqual(studio.errors, []));
