// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how long the studio takes at many triangles: from the end of a click to the next picture, while dragging, to stop, and
// how many pictures a second the browser draws. MEASURE_TRIANGLES chooses the size (400000). No test: times depend on the machine.
import { Studio } from "./harness.mjs";

const triangles = Number(process.env.MEASURE_TRIANGLES ?? 400000);
const studio = await Studio.start();
const { page } = studio;
const print = (what, value) => console.log(`${what.padEnd(52)} ${value}`);
const ms = (value) => `${Math.round(value)} ms`;

/**
 * Does something; the time from its last pointer event (or its call) until the page has taken what changed and handed the next picture
 * to the graphics processor, until that picture is shown, and what the program took for the edit. The best of some tries: other
 * work on the machine only adds.
 */
async function timed(what, action) {
  tell(what, [await timeOf(action)]);
}

function tell(what, all) {
  const best = (of) => ms(Math.min(...all.map(of)));
  print(what, `edit ${best((t) => t.edit)}, page ready ${best((t) => t.ready)}, shown ${best((t) => t.shown)} (software GL)`);
}

async function timeOf(action) {
  await page.evaluate(() => {
    const { store, viewport, stage } = window.studio, before = store.get("state").revision;
    window.begun = performance.now();
    window.addEventListener("pointerup", () => (window.begun = performance.now()), { capture: true, once: true });
    window.arrived = new Promise((resolve) => {
      let done = false;
      store.watch(["state"], () => {
        if (done || store.get("state").revision === before) return;
        done = true;
        const edit = store.get("state").last.milliseconds;
        stage.surface.update();
        viewport.renderer.render(viewport.scene, viewport.camera);
        const ready = performance.now() - window.begun;
        viewport.renderer.getContext().finish();
        resolve({ edit, ready, shown: performance.now() - window.begun });
      });
    });
  });
  await action();
  const times = await page.evaluate(() => window.arrived);
  await page.waitForFunction(() => window.studio.store.get("state").finished !== false && !window.studio.store.get("busy"), null, { timeout: 120000 });
  return times;
}

/** Pictures a second while the camera turns. */
async function rate(view) {
  await studio.view(view);
  await studio.settle();
  const fps = await page.evaluate(() => new Promise((resolve) => {
    const { viewport } = window.studio;
    let pictures = 0;
    const start = performance.now();
    const turn = () => {
      viewport.camera.position.applyAxisAngle(viewport.camera.up, 0.02);
      viewport.invalidate();
      ++pictures;
      if (performance.now() - start < 3000) requestAnimationFrame(turn);
      else resolve(pictures / (performance.now() - start) * 1000);
    };
    requestAnimationFrame(turn);
  }));
  print(`turning, view ${view}`, `${fps.toFixed(1)} pictures a second (software GL)`);
}

const file = studio.shape(process.env.MEASURE_SHAPE ?? "hand", triangles);
let begin = Date.now();
await studio.upload(file);
print(`open ${triangles} triangles`, ms(Date.now() - begin));
await timed("suggest", () => page.click("#suggest"));
for (const view of ["surface", "atlas", "quads"]) await rate(view);
await studio.view("atlas");
const inside = await studio.insideTallestTube();
await studio.face(inside);
await studio.tool("subdivide");
await timed("subdivide", () => studio.clickAt(inside));
const undo = () => page.keyboard.press("Control+z"), redo = () => page.keyboard.press("Control+Shift+z");
const undone = [], redone = [];
for (let i = 0; i < 4; ++i) {
  undone.push(await timeOf(undo));
  redone.push(await timeOf(redo));
}
tell("undo", undone);
tell("redo", redone);

await studio.tool("drag");
const { x, y } = await studio.screen(inside);
const onContour = await page.evaluate(({ x, y }) => {
  for (let r = 0; r < 60; ++r) for (const [dx, dy] of [[0, r], [0, -r], [r, 0], [-r, 0]]) if (window.studio.stage.contourAt({ clientX: x + dx, clientY: y + dy })?.kind === "regular") return { x: x + dx, y: y + dy };
  return null;
}, { x, y });
if (onContour) {
  await page.mouse.move(onContour.x, onContour.y);
  await page.mouse.down();
  const first = (await studio.state()).revision;
  begin = Date.now();
  for (let i = 1; i <= 40; ++i) {
    await page.mouse.move(onContour.x + i / 2, onContour.y + i);
    await page.waitForTimeout(50);
  }
  const steps = (await studio.state()).revision - first;
  print("dragging a contour", `${(steps / (Date.now() - begin) * 1000).toFixed(1)} updates a second`);
  await timed("end of the drag", () => page.mouse.up());
}

await page.evaluate(() => (window.asked = window.studio.connection.request("edit", { edit: { edit: "suggest", persistence: 0.05, axis: [0, 0, 1] } }).catch(() => 0)));
await page.waitForTimeout(300);
const stop = await page.evaluate(async () => {
  const start = performance.now();
  await window.studio.connection.request("cancel");
  await window.asked;
  const told = performance.now() - start;
  await window.studio.connection.request("list_files"); // waits for the worker
  return { told, free: performance.now() - start };
});
print("cancel a suggestion", `told after ${ms(stop.told)}, the worker is free after ${ms(stop.free)}`);
print("errors of the page", studio.errors.length);
await studio.close();
