// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture costs the page at 400,000 triangles. What it costs a graphics processor cannot be measured without one: but that has
// few things to draw, and the page leaves it nearly all of the 33 ms that a picture may take. A machine that does nothing else
// takes about a millisecond; the limits on time are so far above it that slow and busy machines pass, and only defects do not: a page
// that does in each picture, or at each move of the pointer, what it should do once. The calls are counted exactly.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Studio } from "./harness.mjs";

const triangles = 400000, mostMilliseconds = 110, mostForPointer = 160, mostCalls = 16;
let studio;
before(async () => {
  studio = await Studio.start();
  await studio.page.evaluate(() => {
    const { renderer } = window.studio.viewport;
    window.draw = renderer.render;
    renderer.render = () => {}; // software would draw for seconds
  });
  await studio.upload(studio.shape("hand", triangles));
  await studio.suggest();
  await studio.page.evaluate(() => (window.studio.viewport.renderer.render = window.draw));
});
after(() => studio.close());

const combinations = {
  "the surface": ["surface"],
  "field, isolines, contours, critical points": ["surface", "field", "isolines", "contours", "critical"],
  "charts, contours, critical points": ["surface", "charts", "contours", "critical"],
  "textures on the charts": ["surface", "charts", "contours", "critical", "textures"],
  "quads with valences": ["quads", "valences"],
  "quality": ["quads", "quality"],
  "all that can be shown with the surface, see-through": ["surface", "charts", "isolines", "contours", "critical", "reeb", "textures", "valences", "xray"],
};

for (const [name, layers] of Object.entries(combinations))
  test(`a picture of ${name} takes the page little time and a few calls`, async (t) => {
    await studio.layers(...layers);
    const cost = await studio.costOfPictures();
    t.diagnostic(`${cost.milliseconds.toFixed(1)} ms, ${cost.calls} draw calls, ${cost.triangles} triangles, ${cost.points} signs`);
    assert.ok(cost.pictures >= 30, "pictures were made");
    assert.ok(layers.includes("quads") || cost.triangles >= triangles, "the whole surface is drawn");
    assert.ok(cost.milliseconds < mostMilliseconds, `${cost.milliseconds} ms`);
    assert.ok(cost.calls <= mostCalls, `${cost.calls} draw calls`);
  });

test("while nothing moves, nothing is drawn and nothing runs", async () => {
  await studio.landed();
  const frames = await studio.page.evaluate(async () => {
    const { viewport } = window.studio, { frame } = viewport;
    const until = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
    let frames = 0;
    viewport.frame = function (time) {
      ++frames;
      return frame.call(this, time);
    };
    /** Whether nothing is drawn for a while; what was asked for before may still be on its way at first. */
    const rests = async () => {
      for (let attempt = 0, before = -1; attempt < 60; ++attempt) {
        if (frames === before) return true;
        before = frames;
        await until(600);
      }
      return false;
    };
    const rested = await rests(), idle = frames;
    viewport.invalidate();
    for (let attempt = 0; frames === idle && attempt < 600; ++attempt) await until(100);
    const restsAgain = await rests();
    delete viewport.frame;
    return { rested, restsAgain, asked: frames - idle };
  });
  assert.ok(frames.rested && frames.restsAgain, "nothing is drawn unasked");
  assert.ok(frames.asked >= 1 && frames.asked <= 2, `one picture, when it is asked for: ${frames.asked}`);
});

test("the pointer over the surface and its contours is answered without a search of everything", async () => {
  const milliseconds = await studio.page.evaluate(() => {
    const { stage, viewport } = window.studio, box = viewport.canvas.getBoundingClientRect(), times = [];
    stage.surface.prepare();
    for (let i = 0; i < 40; ++i) {
      const at = { clientX: box.left + (box.width * (i % 8)) / 8, clientY: box.top + (box.height * Math.floor(i / 8)) / 5 };
      const start = performance.now();
      stage.surface.pick(viewport.ray(at));
      stage.contourAt(at);
      times.push(performance.now() - start);
    }
    return times.sort((a, b) => a - b)[20];
  });
  assert.ok(milliseconds < mostForPointer, `${milliseconds} ms`);
});

test("the page reported no errors", () => assert.deepEqual(studio.errors, []));
