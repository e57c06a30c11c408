// SPDX-License-Identifier: GPL-3.0-or-later
// The HTML report opens from disk without a network and shows what the run found: of `reebquad run`, and of the studio.
import assert from "node:assert/strict";
import { statSync, writeFileSync } from "node:fs";
import test, { after, before } from "node:test";
import { pathToFileURL } from "node:url";
import { drawn, newPage, reebquad, Studio, takePicture } from "./harness.mjs";

let studio;
before(async () => (studio = await Studio.start()));
after(() => studio.close());

/** Opens a report in a browser that has no network; what it asks for and its errors are noted. */
async function open(file, { width = 1400, height = 860 } = {}) {
  const page = await newPage(studio.browser, { viewport: { width, height }, colorScheme: "light", offline: true });
  const asked = [], errors = [];
  page.on("request", (request) => asked.push(request.url()));
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  const url = pathToFileURL(file).href;
  await page.goto(url);
  await page.waitForFunction(() => window.report);
  return { page, asked: () => asked.filter((u) => u !== url && !u.startsWith("blob:") && !u.startsWith("data:")), errors, picture: (name) => takePicture(page, name), canvas: () => drawn(page) };
}

test("the report of a run", async () => {
  const mesh = studio.shape("hand", 8000), html = studio.path("hand.html");
  reebquad("run", mesh, "-o", studio.path("hand.obj"), "--quads", "2500", "--html", html, "--quiet");
  const report = await open(html);
  assert.equal(await report.page.getAttribute("[data-light]", "data-light") === "red", false);
  // Warnings of the shape stand above the certificate's checks; they are no failures.
  assert.equal(await report.page.locator(".check:not([data-warning])").count(), 15);
  assert.equal(await report.page.locator(".check.failed:not([data-warning])").count(), 0);
  assert.match(await report.page.innerText(".numbers"), /scaled Jacobian/);
  await report.picture("report_quads");
  const seen = new Set();
  for (const view of ["surface", "field", "atlas", "quads", "quality"]) {
    await report.page.click(`[data-view="${view}"]`);
    seen.add(await report.canvas());
  }
  assert.equal(seen.size, 5);
  const before = await report.canvas();
  await report.page.locator(".bar:not([disabled])").first().click();
  assert.notEqual(await report.canvas(), before);
  await report.picture("report_quality_lit");
  await report.page.click('[data-view="atlas"]');
  await report.page.keyboard.press("7");
  await report.page.evaluate(() => document.querySelectorAll("details").forEach((d, i) => (d.open = i > 3)));
  await report.picture("report_atlas");
  assert.deepEqual(report.asked(), []);
  assert.deepEqual(report.errors, []);
});

test("two parts are shown together, on a narrow screen too", async () => {
  const sphere = studio.shape("sphere", 1500), torus = studio.shape("torus", 2000);
  const both = studio.path("both.obj");
  writeFileSync(both, joined(sphere, torus, 2.6));
  reebquad("run", both, "-o", studio.path("both_quads.obj"), "--quads", "1200", "--html", studio.path("both.html"), "--quiet");
  const report = await open(studio.path("both.html"), { width: 700, height: 860 });
  const sizes = await report.page.evaluate(() => window.report.stages.map((s) => s.quads.corners.length / 4));
  assert.equal(sizes.length, 2);
  assert.ok(sizes.every((n) => n > 100));
  await report.picture("report_two_parts");
  assert.deepEqual(report.errors, []);
});

test("the studio gives the report of its design", async () => {
  await studio.upload(studio.path("torus.off"));
  await studio.suggest();
  const bytes = await studio.download(() => studio.page.click("#report"));
  const file = studio.path("studio_report.html");
  writeFileSync(file, bytes);
  const report = await open(file);
  await report.page.evaluate(() => document.querySelectorAll("details").forEach((d) => (d.open = /Edits|Certificate/.test(d.textContent))));
  assert.match(await report.page.innerText(".edits"), /suggest/);
  assert.equal(await report.page.locator(".check.passed").count() >= 14, true);
  await report.picture("report_of_the_studio");
  assert.deepEqual(report.asked(), []);
  assert.deepEqual(report.errors, []);
  assert.deepEqual(studio.errors, []);
});

test("a report of a large surface leaves it out, says so, and stays small", async () => {
  const html = studio.path("large.html");
  reebquad("run", studio.shape("torus", 400000), "-o", studio.path("large.obj"), "--quads", "6000", "--html", html, "--quiet");
  assert.ok(statSync(html).size < 4e6);
  const report = await open(html);
  assert.equal(await report.page.isDisabled('[data-view="atlas"]'), true);
  assert.match(await report.page.innerText(".side"), /not in this report/);
  await report.picture("report_large");
  assert.deepEqual(report.errors, []);
});

/** Two OFF files as one OBJ, the second shifted along x. */
function joined(first, second, shift) {
  let offset = 1;
  const parts = [first, second].map((file, i) => {
    const rows = studio.read(file).trim().split("\n").filter((l) => !l.startsWith("#"));
    const [points, faces] = rows[1].split(/\s+/).map(Number);
    const vertices = rows.slice(2, 2 + points).map((row) => {
      const [x, y, z] = row.split(/\s+/).map(Number);
      return `v ${x + i * shift} ${y} ${z}`;
    });
    const triangles = rows.slice(2 + points, 2 + points + faces).map((row) => `f ${row.split(/\s+/).slice(1, 4).map((v) => Number(v) + offset).join(" ")}`);
    offset += points;
    return [...vertices, ...triangles].join("\n");
  });
  return parts.join("\n") + "\n";
}
