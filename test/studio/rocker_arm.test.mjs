// SPDX-License-Identifier: GPL-3.0-or-later
// The rocker arm: the suggestion, then contours across its arms, finer rows, and a certified mesh. Skipped without the model.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { Studio } from "./harness.mjs";

const model = join(process.env.REEBQUAD_MODELS_DIR ?? "", "rocker_arm.obj");

test("the rocker arm is designed by mouse", { skip: !existsSync(model) && "the model is not here" }, async () => {
  const studio = await Studio.start();
  try {
    const file = await studio.upload(model);
    assert.equal(file.file.genus, 1);
    let state = await studio.suggest();
    assert.equal(state.certificate.passed, true);
    const suggested = state.facts.charts.length;

    // Two more contours, each across the tallest tube.
    await studio.tool("subdivide");
    for (let i = 0; i < 2; ++i) {
      const point = await studio.insideTallestTube();
      await studio.after(() => studio.clickOn(point, 1));
    }
    state = await studio.state();
    assert.equal(state.facts.charts.length, suggested + 2);

    // Finer quads, and the whole certificate.
    await studio.page.fill("#quads", "5000");
    await studio.after(() => studio.page.press("#quads", "Enter"));
    state = await studio.after(() => studio.page.click(".certificate"));
    assert.equal(state.certificate.passed, true);
    assert.ok(Math.abs(state.statistics.quads - 5000) < 500);
    await studio.tool("select");
    await studio.home();
    await studio.view("quads");
    await studio.picture("rocker_arm_quads");
    await studio.view("atlas");
    await studio.picture("rocker_arm_atlas");
    assert.deepEqual(studio.errors, []);
  } finally {
    await studio.close();
  }
});
