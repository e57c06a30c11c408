// SPDX-License-Identifier: GPL-3.0-or-later
// What a user does on the whole surface: drops a file, flies to what is odd, adds and moves extrema, turns the plane by its rings,
// splits a saddle in four, stops a long work; and what can be done without a mouse.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import test, { after, before } from "node:test";
import { Studio } from "./harness.mjs";

let studio;
before(async () => (studio = await Studio.start()));
after(() => studio.close());

const critical = (kind) =>
  studio.page.evaluate((k) => window.studio.stage.critical.filter((c) => c.kind === k).map((c) => c.position.toArray()), kind);
const edits = async () => (await studio.state()).history.map((step) => step.edit);

/** Moves the pointer in circles until one of the plane's handles takes it; where that was, and which. */
async function findGizmo() {
  const middle = await studio.page.evaluate(() => {
    const { tools, viewport } = window.studio;
    return viewport.project(tools.current.plane.position);
  });
  for (let radius = 30; radius < 140; radius += 4)
    for (let turn = 0; turn < 2 * Math.PI; turn += 0.35) {
      const [x, y] = [middle.x + radius * Math.cos(turn), middle.y + radius * Math.sin(turn)];
      await studio.page.mouse.move(x, y);
      const axis = await studio.page.evaluate(() => window.studio.tools.current.gizmo.axis);
      if (axis) return { x, y, middle, axis };
    }
  throw new Error("the plane has no ring under the pointer");
}

test("a file is dropped onto the page", async () => {
  const text = studio.read(studio.shape("sphere", 3000));
  const state = await studio.after(() =>
    studio.page.evaluate((content) => {
      const data = new DataTransfer();
      data.items.add(new File([content], "dropped.off"));
      for (const kind of ["dragover", "drop"]) {
        document.querySelector(".canvas").dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
        if (document.body.classList.contains("dropping") !== (kind === "dragover")) throw new Error("the page does not say where to drop");
      }
    }, text),
  );
  assert.equal(state.file.name, "dropped.off");
});

test("the line below tells how many extraordinary vertices there must be", async () => {
  await studio.suggest();
  assert.match(await studio.page.innerText(".budget"), /index 8 of 8/);
  assert.match(await studio.page.getAttribute(".budget", "title"), /4χ = 8/);
});

test("an extremum is added by a click, moved live by a drag, and deleted by a key", async () => {
  await studio.tool("extremum");
  const before = (await studio.state()).facts.extrema.length;
  const side = await studio.page.evaluate(() => {
    const { surface } = window.studio.stage;
    let best = 0;
    for (let v = 0; v < surface.positions.length / 3; ++v) if (surface.vertex(v).x > surface.vertex(best).x) best = v;
    return surface.vertex(best).toArray();
  });
  const added = await studio.after(() => studio.clickOn(side));
  assert.equal(added.facts.extrema.length, before + 1);
  assert.equal(added.certificate.passed, true);
  const [maximum] = (await critical(2)).sort((a, b) => b[0] - a[0]);
  await studio.face(maximum);
  const at = await studio.screen(maximum);
  const steps = (await edits()).length;
  await studio.after(async () => {
    await studio.page.mouse.move(at.x, at.y);
    await studio.page.mouse.down();
    for (let i = 1; i <= 5; ++i) {
      await studio.page.mouse.move(at.x + 8 * i, at.y + 5 * i);
      await studio.settle();
    }
    await studio.page.mouse.up();
  });
  await studio.page.waitForFunction(() => !window.studio.store.get("busy"));
  assert.equal((await edits()).length, steps + 1);
  assert.equal((await edits()).at(-1).edit, "move_extremum");
  const [moved] = (await critical(2)).sort((a, b) => b[0] - a[0]);
  assert.ok(Math.hypot(...moved.map((x, i) => x - maximum[i])) > 0.05);
  await studio.picture("extremum_moved");
  await studio.clickOn(moved);
  assert.match(await studio.page.innerText(".hint-line"), /Delete/);
  const removed = await studio.after(() => studio.page.keyboard.press("Delete"));
  assert.equal(removed.facts.extrema.length, before);
});

test("the plane is turned by its rings and shifted by its arrow with the mouse, and has no handle that does nothing", async () => {
  await studio.upload(studio.shape("torus", 3000));
  await studio.suggest();
  await studio.view("atlas");
  await studio.tool("subdivide");
  await studio.after(async () => studio.clickOn(await studio.insideTallestTube()));
  await studio.tool("plane");
  const contour = await studio.page.evaluate(() => {
    const c = window.studio.stage.contours.filter((c) => c.kind === "regular").sort((a, b) => b.points.length - a.points.length)[0];
    return c.points[c.points.length >> 1].toArray();
  });
  await studio.clickOn(contour, 4);
  await studio.page.waitForSelector("#apply-plane:not([disabled])");
  const pose = () => studio.page.evaluate(() => [...window.studio.tools.current.plane.quaternion.toArray(), ...window.studio.tools.current.plane.position.toArray()]);
  await studio.page.keyboard.press("t");
  const arrow = await findGizmo(), unmoved = await pose();
  assert.equal(arrow.axis, "Z");
  await studio.page.mouse.down();
  const away = [arrow.x - arrow.middle.x, arrow.y - arrow.middle.y].map((d) => 0.05 * d);
  for (let i = 1; i <= 3; ++i) await studio.page.mouse.move(arrow.x + i * away[0], arrow.y + i * away[1]);
  await studio.page.mouse.up();
  const shifted = await pose();
  assert.deepEqual(shifted.slice(0, 4), unmoved.slice(0, 4));
  assert.ok(Math.hypot(...shifted.slice(4).map((v, i) => v - unmoved[4 + i])) > 1e-3);
  await studio.page.keyboard.press("r");
  const { x, y, middle, axis } = await findGizmo();
  assert.match(axis, /^[XY]$/);
  const before = await studio.page.evaluate(() => window.studio.tools.current.plane.quaternion.toArray());
  await studio.page.mouse.down();
  // Along the ring, a little.
  const [rx, ry] = [x - middle.x, y - middle.y];
  for (let i = 1; i <= 4; ++i) await studio.page.mouse.move(x - 0.03 * i * ry, y + 0.03 * i * rx);
  await studio.picture("plane_ring");
  await studio.page.mouse.up();
  const after = await studio.page.evaluate(() => window.studio.tools.current.plane.quaternion.toArray());
  assert.notDeepEqual(after, before);
  const state = await studio.after(() => studio.page.keyboard.press("Enter"));
  assert.equal((await edits()).at(-1).edit, "move_contour");
  assert.equal(state.certificate.passed, true);
});

test("a saddle becomes four vertices of valence 5", async () => {
  await studio.tool("saddle", "Quarters");
  const [saddle] = await critical(1);
  const state = await studio.after(() => studio.clickOn(saddle, 0.5));
  assert.equal(state.budget.interior["5"], 4);
  await studio.view("quads");
  await studio.lookAt(saddle, (await studio.normalAt(saddle)).map((x, i) => x + (i === 2 ? 0.6 : 0)), 1.1);
  await studio.picture("quarter_saddles");
});

test("two saddles are aligned by two clicks", async () => {
  await studio.upload(studio.shape("bitorus", 3000));
  await studio.page.selectOption("#axis", { label: "X is up" });
  const before = await studio.suggest();
  await studio.view("atlas");
  // The two beside the tube between the holes.
  const [first, second] = (await critical(1)).sort((a, b) => Math.abs(a[0]) - Math.abs(b[0]));
  await studio.tool("align");
  await studio.clickOn(first, 0.4);
  assert.match(await studio.page.innerText(".hint-line"), /other side/);
  const state = await studio.after(() => studio.clickOn(second, 0.4));
  assert.equal((await edits()).at(-1).edit, "align_saddles");
  assert.equal(state.facts.charts.length, before.facts.charts.length - 1);
  assert.equal(state.budget.interior["8"], before.budget.interior["8"]); // they keep their valence
  assert.equal(state.certificate.passed, true);
  await studio.page.selectOption("#axis", { label: "Y is up" });
  await studio.picture("aligned_saddles");
});

test("a picture is saved", async () => {
  const png = await studio.download(() => studio.page.click("#screenshot"));
  assert.equal(png.subarray(1, 4).toString(), "PNG");
  assert.ok(png.length > 20000);
});

test("what is odd about a file is listed, and a click flies there", async () => {
  const rows = studio.read(studio.shape("sphere", 1000)).trim().split("\n").filter((l) => !l.startsWith("#"));
  const [points, faces] = rows[1].split(/\s+/).map(Number);
  const first = rows[2 + points].split(/\s+/);
  rows[2 + points] = [first[0], first[2], first[1], first[3]].join(" "); // one face turned over
  writeFileSync(studio.path("turned.off"), ["OFF", `${points} ${faces} 0`, ...rows.slice(2)].join("\n") + "\n");
  const state = await studio.upload(studio.path("turned.off"));
  assert.ok(state.file.defects.length > 0);
  assert.equal(await studio.page.innerText('[data-tab="check"] .badge'), String(state.file.defects.length));
  await studio.tab("check");
  const before = await studio.page.evaluate(() => window.studio.viewport.controls.target.toArray());
  await studio.page.locator(".finding").first().click();
  const where = state.file.defects[0].where;
  assert.ok(Math.hypot(...where.map((x, i) => x - before[i])) > 0.1);
  await studio.page.waitForFunction((there) => {
    const target = window.studio.viewport.controls.target.toArray();
    return Math.hypot(...target.map((x, i) => x - there[i])) < 1e-3;
  }, where);
  await studio.page.locator(".finding").first().hover();
  await studio.picture("defect");
});

test("a long work is stopped by Cancel, and everything is as it was", async () => {
  await studio.upload(studio.shape("hand", 400000));
  const before = await studio.state();
  // Cancel is pressed by the page itself as soon as it can be seen: however busy the browser is, the work goes on by then.
  await studio.page.evaluate(() => new Promise((resolve) => {
    let begun = false;
    const bar = document.querySelector(".progress");
    const watch = new MutationObserver(() => {
      if (!begun && !bar.hidden) {
        begun = true;
        bar.querySelector("button").click();
      }
      const stopped = [...document.querySelectorAll(".toast")].some((toast) => toast.textContent.includes("Stopped"));
      if (!begun || !stopped) return;
      watch.disconnect();
      resolve();
    });
    watch.observe(document.body, { subtree: true, childList: true, attributes: true });
    document.querySelector("#suggest").click();
  }));
  await studio.quiet();
  assert.equal((await studio.state()).revision, before.revision);
});

test("the parts of a file are listed; each has its design, and the export joins them", async () => {
  const parts = [["sphere", 0, 1000], ["torus", 4, 2000], ["tetrahedron", 8, 400]].map(([name, shift, triangles]) => {
    const rows = studio.read(studio.shape(name, triangles)).trim().split("\n").filter((l) => !l.startsWith("#"));
    const [points] = rows[1].split(/\s+/).map(Number);
    return { points: rows.slice(2, 2 + points).map((row) => row.split(/\s+/).map((x, i) => Number(x) + (i ? 0 : shift)).join(" ")), faces: rows.slice(2 + points).map((row) => row.split(/\s+/).slice(1).map(Number)) };
  });
  let first = 1;
  const text = parts.map(({ points, faces }) => {
    const lines = [...points.map((p) => `v ${p}`), ...faces.map((face) => `f ${face.map((v) => v + first).join(" ")}`)].join("\n");
    first += points.length;
    return lines;
  }).join("\n");
  writeFileSync(studio.path("parts.obj"), `${text}\n`);
  const opened = await studio.upload(studio.path("parts.obj"));
  assert.equal(opened.file.components.length, 3);
  assert.equal(opened.file.component, 2);
  const torus = await studio.suggest();
  const sphere = await studio.after(() => studio.page.click('[data-part="1"]'));
  assert.equal(sphere.applied, 0);
  assert.equal(await studio.page.isDisabled("#export"), false); // the torus has quads
  const both = await studio.suggest();
  assert.ok(both.statistics.quads > 100);
  await studio.picture("parts");
  const quads = (await studio.download(() => studio.page.click("#export"))).toString();
  await studio.told(/Without part 3/);
  assert.equal(quads.match(/^f /gm).length, torus.statistics.quads + both.statistics.quads);
  const recipe = JSON.parse(await studio.download(() => studio.page.click("#recipe")));
  assert.equal(recipe.component, 1);
  // The other parts are drawn, too: a click on one in the picture chooses it.
  await studio.tool("select");
  const onTorus = await studio.page.evaluate(() => {
    const { position, chart } = window.studio.stage.others.mesh.geometry.attributes;
    let best = -1;
    for (let v = 0; v < position.count; ++v) if (chart.getX(v) === 2 && (best < 0 || position.getZ(v) > position.getZ(best))) best = v;
    return [position.getX(best), position.getY(best), position.getZ(best)];
  });
  await studio.lookAt(onTorus, [0, 0.2, 1], 9);
  await studio.page.mouse.move(...Object.values(await studio.screen(onTorus)).slice(0, 2));
  assert.match(await studio.page.innerText(".hint-line"), /Click to work on part 2/);
  await studio.picture("other_parts");
  const back = await studio.after(() => studio.clickAt(onTorus));
  assert.equal(back.file.component, 2);
  assert.equal(back.applied, 1);
  assert.equal(back.statistics.quads, torus.statistics.quads);
  assert.equal(back.certificate.passed, true);
});

test("panels and tools are reached by the Tab key, and panels by arrows", async () => {
  await studio.page.focus('[data-tab="design"]');
  await studio.page.keyboard.press("ArrowRight");
  assert.equal(await studio.page.isVisible(".layer-list"), true);
  assert.equal(await studio.page.isVisible("#suggest"), false);
  await studio.page.keyboard.press("ArrowLeft");
  await studio.page.focus("#open");
  const reached = new Set();
  for (let i = 0; i < 80; ++i) {
    await studio.page.keyboard.press("Tab");
    reached.add(await studio.page.evaluate(() => document.activeElement.closest(".top, .rail, .side, .status")?.className ?? ""));
    const tag = await studio.page.evaluate(() => document.activeElement.id);
    if (tag === "suggest") break;
  }
  assert.ok(reached.has("rail") && reached.has("side"));
  await studio.after(() => studio.page.keyboard.press("Enter"));
  assert.equal((await edits()).at(-1).edit, "suggest");
});

test("keys alone place an extremum: arrows move the view under its middle, Space clicks there", async () => {
  await studio.upload(studio.shape("sphere", 1500));
  await studio.suggest();
  const { length } = (await studio.state()).facts.extrema;
  await studio.page.keyboard.press("e");
  for (let i = 0; i < 100 && (await studio.page.evaluate(() => document.activeElement.tagName)) !== "CANVAS"; ++i) await studio.page.keyboard.press("Tab");
  for (let i = 0; i < 6; ++i) await studio.page.keyboard.press("Shift+ArrowLeft");
  await studio.landed();
  assert.equal(await studio.page.evaluate(() => getComputedStyle(document.querySelector(".canvas"), "::after").width), "25px", "the middle is marked");
  await studio.picture("by_keys");
  const state = await studio.after(() => studio.page.keyboard.press("Space"));
  assert.equal((await edits()).at(-1).edit, "add_extremum");
  assert.equal(state.facts.extrema.length, length + 1);
});

test("the page reported no errors", () => assert.deepEqual(studio.errors, []));
