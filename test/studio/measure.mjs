// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how long the studio takes at many triangles: from the end of a click to the next picture, while dragging, to stop, and
// how many pictures a second the browser draws. MEASURE_TRIANGLES chooses the size (400000); MEASURE_DRAW=0 draws no pictures.
// No test: times depend on the machine.
import { Studio } from "./harness.mjs";

const triangles = Number(process.env.MEASURE_TRIANGLES ?? 400000);
const studio = await Studio.start();
const { page } = studio;
const print = (what, value) => console.log(`${what.padEnd(52)} ${value}`);
const ms = (value) => `${Math.round(value)} ms`;

/** When the socket took the last request, and when the state that follows came out of it: before the page looks. */
const socket = { asked: 0, state: 0 };
page.on("websocket", (line) => {
  line.on("framesent", () => (socket.asked = performance.now()));
  line.on("framereceived", ({ payload }) => {
    if (typeof payload === "string" && payload.includes('"event":"state"')) socket.state = performance.now();
  });
});
await page.reload();
await page.waitForFunction(() => window.studio?.store.get("connected"));
// Without pictures, what is measured is the program, the socket and the page: nothing waits for a graphics processor that is none.
const draws = process.env.MEASURE_DRAW !== "0";
if (!draws) await page.evaluate(() => (window.studio.viewport.renderer.render = () => {}));

/**
 * Does something; the time from its last pointer event (or its call) until the page has taken what changed and handed the next picture
 * to the graphics processor, and until that picture is shown. Of it, what the program took for the edit, when all was through the
 * socket, what the page took, and how much was sent; the rest is the wait for a picture that the software draws. The best of some
 * tries: other work on the machine only adds.
 */
async function timed(what, action) {
  tell(what, [await timeOf(action)]);
}

function tell(what, all) {
  const best = (of) => ms(Math.min(...all.map(of)));
  const { bytes } = all[0];
  print(what, `edit ${best((t) => t.edit)}, through the socket ${best((t) => t.socket)} (${Math.round(bytes / 1000)} kB), page ${best((t) => t.page)}; ready ${best((t) => t.ready)}${draws ? `, shown ${best((t) => t.shown)} (software GL)` : ""}`);
}

async function timeOf(action) {
  await page.evaluate(() => {
    const { store, viewport, stage, connection } = window.studio, before = store.get("state").revision;
    window.begun = performance.now();
    window.addEventListener("pointerup", () => (window.begun = performance.now()), { capture: true, once: true });
    window.arrived = new Promise((resolve) => {
      const take = Object.getPrototypeOf(connection).take;
      let bytes = 0, inPage = 0;
      connection.take = function (data) {
        const start = performance.now();
        if (data instanceof ArrayBuffer) bytes += data.byteLength;
        take.call(this, data);
        inPage += performance.now() - start;
        if (store.get("state").revision === before) return;
        delete connection.take;
        const edit = store.get("state").last.milliseconds, drawing = performance.now();
        stage.surface.update();
        viewport.renderer.render(viewport.scene, viewport.camera);
        const ready = performance.now();
        viewport.renderer.getContext().finish();
        resolve({ edit, bytes, page: inPage + ready - drawing, ready: ready - window.begun, shown: performance.now() - window.begun });
      };
    });
  });
  await action();
  const times = { ...(await page.evaluate(() => window.arrived)), socket: socket.state - socket.asked };
  await page.waitForFunction(() => window.studio.store.get("state").finished !== false && !window.studio.store.get("busy"), null, { timeout: 120000 });
  return times;
}

/** Presses at a place, moves with every picture for three seconds and lets go: how often the design follows, and the end of it. */
async function dragged(what, { x, y }, dx, dy) {
  await page.mouse.move(x, y);
  await page.mouse.down();
  const { updates, edits, busy } = await page.evaluate(async ({ x, y, dx, dy }) => {
    const { store, connection, stage } = window.studio, take = Object.getPrototypeOf(connection).take;
    let updates = 0, busy = 0, edits = 0;
    store.watch(["state"], () => {
      ++updates;
      edits += store.get("state").last.milliseconds;
    });
    connection.take = function (data) {
      const start = performance.now();
      take.call(this, data);
      busy += performance.now() - start;
    };
    const start = performance.now();
    [updates, edits] = [0, 0];
    for (let i = 1; performance.now() - start < 3000; ++i) {
      const at = 20 * Math.sin(i / 40); // there and back
      window.dispatchEvent(new PointerEvent("pointermove", { clientX: x + dx * at, clientY: y + dy * at, buttons: 1 }));
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const begun = performance.now();
      stage.surface.update();
      busy += performance.now() - begun;
    }
    delete connection.take;
    const seconds = (performance.now() - start) / 1000;
    return { updates: updates / seconds, edits: edits / updates, busy: busy / updates };
  }, { x, y, dx, dy });
  print(`dragging ${what}`, `${updates.toFixed(1)} updates a second; of one, the edit ${ms(edits)}, the page ${ms(busy)}`);
  await timed(`end of dragging ${what}`, () => page.mouse.up());
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
if (draws) for (const view of ["surface", "atlas", "quads"]) await rate(view);
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
  await dragged("a contour", onContour, 0.5, 1);
  await studio.tool("plane");
  const regular = await page.evaluate(() => {
    const { stage } = window.studio, c = stage.contours.filter((c) => c.kind === "regular").sort((a, b) => b.points.length - a.points.length)[0];
    return c.points[c.points.length >> 1].toArray();
  });
  await studio.clickOn(regular);
  await page.waitForSelector("#apply-plane:not([disabled])", { timeout: 60000 });
  await page.evaluate(() => window.studio.tools.current.turn(0.03));
  await page.waitForFunction(() => !window.studio.store.get("busy"));
  await timed("move contour", () => page.keyboard.press("Enter"));
}
await studio.tool("extremum");
const tip = await page.evaluate(() => window.studio.stage.critical.find((c) => c.kind === 2).position.toArray());
await studio.face(tip);
await dragged("an extremum", await studio.screen(tip), 0.4, 0.4);

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
