// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the pictures of the manual's page on the studio in STUDIO_ARTEFACTS: studio_01.png to studio_10.png, and studio_08_saddle.png.
import { Studio } from "./harness.mjs";

const studio = await Studio.start({ theme: "light", width: 1180, height: 740 });
let number = 0;
const take = async (name = String(++number).padStart(2, "0")) => {
  await studio.page.evaluate(() => document.querySelectorAll(".toast").forEach((toast) => toast.remove()));
  await studio.picture(`studio_${name}`);
};
const point = (find) => studio.page.evaluate(find);

await take();
await studio.upload(studio.shape("hand", 8000));
await studio.page.selectOption("#axis", { label: "Z is up" });
await studio.page.waitForTimeout(500);
await take();
await studio.suggest();
await studio.view("field");
await take();
await studio.view("atlas");
await take();
await studio.view("quads");
await take();
await studio.view("quality");
await take();
await studio.tool("subdivide");
const inside = await studio.insideTallestTube();
await studio.lookAt(inside, [0.3, -0.5, 1], 2.2);
await studio.after(() => studio.clickAt(inside));
await take();
await studio.tool("plane");
const contour = await point(() => {
  const { stage } = window.studio;
  const all = stage.contours.filter((c) => c.kind === "regular").flatMap((c) => c.points);
  const free = all.filter((p) => {
    const { x, y } = stage.viewport.project(p);
    return x > 380 && x < 800 && y > 250 && y < 600 && stage.contourAt({ clientX: x, clientY: y })?.kind === "regular";
  });
  return free[free.length >> 1].toArray();
});
await studio.clickAt(contour);
await take();
await studio.tool("pole", "Halves");
await take();
await studio.tool("texture");
await studio.page.click('[data-operator="insert_polychord"]');
await studio.page.locator(".chart").first().click();
await studio.page.waitForSelector(".chart-view:not([hidden])");
await studio.page.hover(".chart-view canvas");
await take();
await studio.upload(studio.shape("torus", 12000));
await studio.suggest();
await studio.view("atlas");
await studio.tool("plane");
await studio.page.click('[data-choice="saddle"]');
const saddle = await point(() => window.studio.stage.critical.find((c) => c.kind === 1).position.toArray());
await studio.lookAt([0.2 * saddle[0], 0.2 * saddle[1], 0], [-saddle[0], -saddle[1], 0.9], 3.4);
await studio.clickAt(saddle);
const { x, y } = await studio.screen(saddle);
await studio.page.mouse.move(x, y);
await studio.page.mouse.down();
await studio.page.mouse.move(x + 24, y, { steps: 3 });
await studio.page.mouse.up();
await studio.page.waitForTimeout(600);
await take("08_saddle");
await studio.close();
