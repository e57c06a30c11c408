// SPDX-License-Identifier: GPL-3.0-or-later
// How things are shown: shading, views along the axes, the orthographic lens, the border of what is chosen; what is preferred is kept by
// the program; the header is one line; a program that is gone, and a file that is too large, are told.
import assert from "node:assert/strict";
import test, { after, before } from "node:test";
import { Studio } from "./harness.mjs";

let studio;
before(async () => (studio = await Studio.start({ width: 1024, height: 640 })));
after(() => studio.close());

const menu = async (id) => {
  if (!(await studio.page.isVisible(".menu"))) await studio.page.click("#display");
  await studio.page.click(id);
};
const camera = () => studio.page.evaluate(() => {
  const { camera, controls, flight } = window.studio.viewport, eye = camera.position.clone().sub(controls.target);
  return { direction: eye.clone().normalize().toArray(), distance: eye.length(), fov: camera.fov, flies: flight !== null, target: controls.target.toArray() };
});
/** How large the surface is on the screen: the greatest distance of two of its points. */
const extent = () => studio.page.evaluate(() => {
  const { viewport, stage } = window.studio, xs = [];
  for (let v = 0; v < stage.surface.positions.length / 3; ++v) xs.push(viewport.project(stage.surface.vertex(v)).x);
  return Math.max(...xs) - Math.min(...xs);
});

test("the header is one line at 1024 pixels, and every control of it is in sight", async () => {
  await studio.upload(studio.shape("torus", 1200));
  await studio.suggest();
  const { height } = await studio.page.locator(".top").boundingBox();
  assert.ok(height < 50, `${height}`);
  for (const control of await studio.page.locator(".top > button, .top .view, .top .joined > *").all()) {
    const box = await control.boundingBox();
    assert.ok(box && box.x >= 0 && box.x + box.width <= 1024);
  }
  await studio.picture("header_1024");
});

test("six steps lead from the mesh to the check: each has its view, and says what to do next", async () => {
  const names = await studio.page.locator(".top .view").allTextContents();
  assert.deepEqual(names, ["1Mesh", "2Limbs", "3Contours", "4Vertices", "5Quads", "6Check"]);
  const seen = new Set(), drawn = new Set();
  for (const step of ["surface", "field", "atlas", "quads", "quality", "deviation"]) {
    await studio.view(step);
    assert.equal(await studio.page.getAttribute(`[data-view="${step}"]`, "aria-current"), "step");
    seen.add(await studio.page.innerText(".hint-line"));
    drawn.add(await studio.drawn());
    await studio.picture(`step_${step}`);
  }
  assert.equal(seen.size, 6);
  assert.equal(drawn.size, 6);
  assert.ok([...seen].every((sentence) => sentence.length > 20));
  assert.equal(await studio.page.isVisible(".deviation"), true, "the last step has the panels that tell how good the quads are");
  // A tool of the step stays, one of another is put away.
  await studio.tool("drag");
  await studio.view("atlas");
  assert.equal(await studio.page.locator('[data-tool="drag"].on').count(), 1);
  await studio.view("quality");
  assert.equal(await studio.page.locator('[data-tool="select"].on').count(), 1);
  assert.equal(await studio.page.isVisible("#quads"), true);
});

test("a tool leads to the step that it stands under, and the surface is there to be clicked", async () => {
  for (const [tool, step] of [["texture", "quads"], ["plane", "atlas"], ["saddle", "quads"], ["extremum", "field"], ["pole", "quads"]]) {
    await studio.view("quality");
    await studio.tool(tool);
    assert.equal(await studio.page.locator(".top .view.on").getAttribute("data-view"), step, tool);
    assert.ok(await studio.page.evaluate(() => window.studio.store.get("layers").has("surface")), tool);
  }
  await studio.tool("select");
  assert.equal(await studio.page.locator(".top .view.on").getAttribute("data-view"), "quads", "one that belongs to all steps stays where it is");
  await studio.view("quality");
});

test("shading is smooth, splits at creases, or is flat", async () => {
  const normals = () => studio.page.evaluate(() => {
    const { normals } = window.studio.stage.surface; // how much they differ within a face
    let least = 1;
    for (let c = 0; c < normals.length; c += 9) least = Math.min(least, normals[c] * normals[c + 3] + normals[c + 1] * normals[c + 4] + normals[c + 2] * normals[c + 5]);
    return least;
  });
  await menu('[data-shading="flat"]');
  assert.ok((await normals()) > 0.9999);
  await menu('[data-shading="smooth"]');
  assert.ok((await normals()) < 0.9999);
  assert.equal(await studio.page.getAttribute('[data-shading="smooth"]', "aria-checked"), "true");
  await studio.picture("display_menu");
  await studio.page.keyboard.press("Escape");
});

test("views along the axes show everything, and the orthographic lens keeps its size", async () => {
  await menu("#look-front");
  await studio.landed();
  const front = (await camera()).direction;
  await menu("#look-top");
  await studio.landed();
  const top = (await camera()).direction;
  assert.ok(Math.abs(top[1]) > 0.999 && Math.abs(front[1]) < 1e-6); // Y is up
  await menu("#look-side");
  await studio.landed();
  const side = (await camera()).direction;
  assert.ok(Math.abs(side[0] * front[0] + side[1] * front[1] + side[2] * front[2]) < 1e-6);
  const before = { ...(await camera()), extent: await extent() };
  await studio.page.keyboard.press("Escape");
  await studio.page.keyboard.press("o");
  await studio.settle();
  const now = { ...(await camera()), extent: await extent() };
  assert.ok(now.fov < 2 && now.distance > 15 * before.distance);
  assert.ok(Math.abs(now.extent / before.extent - 1) < 0.25, `${before.extent} ${now.extent}`);
  await studio.view("atlas");
  await studio.picture("orthographic");
});

test("the chosen chart has a border, and can fill the view", async () => {
  const outline = () => studio.page.evaluate(() => (window.studio.stage.outline.object.visible ? window.studio.stage.outline.segments : 0));
  assert.equal(await outline(), 0);
  await studio.tab("design");
  await studio.page.locator("[data-chart]").first().click();
  await studio.settle();
  assert.ok((await outline()) > 10);
  const { id } = await studio.page.evaluate(() => ({ id: window.studio.store.get("chart") }));
  // Each end of the border belongs to two of its lines: it is closed.
  const odd = await studio.page.evaluate((id) => {
    const pairs = window.studio.stage.surface.outlineOf(id), ends = new Map();
    for (let i = 0; i < pairs.length; i += 3) {
      const key = pairs.slice(i, i + 3).join();
      ends.set(key, (ends.get(key) ?? 0) + 1);
    }
    return [...ends.values()].filter((n) => n % 2 === 1).length;
  }, id);
  assert.equal(odd, 0);
  const before = (await camera()).target;
  await studio.page.keyboard.press(".");
  await studio.landed();
  await studio.settle();
  assert.notDeepEqual((await camera()).target, before);
  await studio.picture("chosen_chart");
});

test("a turn dies away in the same time, however many pictures it takes", async () => {
  const left = await studio.page.evaluate(() => {
    // What is left of a turn after 0.2 s in pictures of 10, and of 40 milliseconds.
    const { viewport } = window.studio, { controls } = viewport;
    return [10, 40].map((step) => {
      let time = viewport.lastFrame + 1, rest = 1;
      viewport.frame((time += step));
      for (let passed = 0; passed < 200; passed += step) {
        viewport.frame((time += step));
        rest *= 1 - controls.dampingFactor;
      }
      return rest;
    });
  });
  assert.ok(Math.abs(left[0] / left[1] - 1) < 1e-6, left.join(" "));
});

test("a file that is too large is refused with the limit", async () => {
  await studio.page.evaluate(() => {
    const file = new File(["v"], "huge.obj");
    Object.defineProperty(file, "size", { value: 3 * 2 ** 30 });
    return window.studio.take([file]);
  });
  await studio.told(/huge\.obj has 3\.0 GiB; at most 1 GiB/);
});

test("what is preferred outlasts the program, though the page's address changes", async () => {
  await studio.page.click("#theme");
  await studio.page.waitForFunction(() => document.documentElement.dataset.theme === "light");
  await studio.page.evaluate(() => window.studio.connection.request("list_files")); // the program has taken what was sent before
  await studio.stopProgram("SIGKILL");
  await studio.page.waitForSelector(".lost:not([hidden])");
  assert.match(await studio.page.innerText(".lost"), /does not answer.*same folder/is);
  await studio.picture("lost_light");
  await studio.startProgram();
  await studio.page.evaluate(() => localStorage.clear());
  await studio.page.goto(studio.url);
  await studio.page.waitForFunction(() => window.studio?.preferences.get("shading") === "smooth");
  assert.equal(await studio.page.evaluate(() => document.documentElement.dataset.theme), "light");
  assert.equal(await studio.page.getAttribute("#orthographic", "aria-checked"), "true");
  assert.ok((await camera()).fov < 2);
  assert.equal(await studio.page.isVisible(".lost"), false);
});

test("the page reported no errors", () => assert.deepEqual(studio.errors.filter((e) => !/WebSocket|ERR_CONNECTION/.test(e)), []));
