// SPDX-License-Identifier: GPL-3.0-or-later
// Work is never lost: each mesh has its session, which cards bring back; recipes are opened, saved and dropped; and only where
// something would be lost is there a question.
import assert from "node:assert/strict";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import test, { after, before } from "node:test";
import { Studio } from "./harness.mjs";

let studio, torus, made;
before(async () => {
  studio = await Studio.start();
  torus = studio.shape("torus", 1500);
  studio.shape("bitorus", 1500);
});
after(() => studio.close());

const steps = async () => (await studio.state()).history.map((step) => step.edit.edit);
const answer = (id) => studio.page.click(`dialog.question [data-answer="${id}"]`);
const asks = () => studio.page.locator("dialog.question[open]").count();

/** Drops files with these names and texts onto the page. */
const drop = (files) =>
  studio.page.evaluate((files) => {
    const data = new DataTransfer();
    for (const { name, text } of files) data.items.add(new File([text], name));
    document.querySelector(".canvas").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, files);

test("a recipe without a mesh is answered with what to do", async () => {
  await drop([{ name: "lonely.recipe.json", text: "{}" }]);
  await studio.told(/Open the mesh first/);
});

test("opening another mesh keeps the work and says so", async () => {
  await studio.upload(torus);
  await studio.suggest();
  await studio.page.fill("#quads", "800");
  made = await studio.after(() => studio.page.press("#quads", "Enter"));
  assert.deepEqual(await steps(), ["suggest", "set_target"]);
  // Its picture is taken when nothing changes any more.
  await studio.page.waitForFunction(async () => (await window.studio.connection.request("list_files")).sessions.some((s) => s.picture));
  await studio.upload(studio.path("bitorus.off"));
  assert.deepEqual(await steps(), []);
  await studio.told(/work on torus\.off is kept.*2 edits/s);
});

test("a card with a picture, the name, the number of edits and the time brings it back", async () => {
  await studio.page.click("#open");
  const card = studio.page.locator(".open-dialog .card", { hasText: "torus.off" }).filter({ hasNotText: "bitorus" });
  await card.waitFor();
  assert.match(await card.innerText(), /2 edits · (just now|\d+ min ago)/);
  assert.ok((await card.locator("img").getAttribute("src")).startsWith("data:image/"));
  assert.ok((await card.locator("img").evaluate((image) => image.decode().then(() => image.naturalWidth))) > 100);
  await studio.picture("open_dialog");
  const back = await studio.after(() => card.click());
  assert.deepEqual(await steps(), ["suggest", "set_target"]);
  assert.deepEqual(back.statistics, made.statistics);
});

test("a recipe is saved under a name, and over a file only if that is said", async () => {
  await studio.page.keyboard.press("Control+s");
  await studio.page.fill("#save-name", "mine.recipe.json");
  await answer("folder");
  await studio.told(/mine\.recipe\.json is saved/);
  const saved = readFileSync(studio.path("mine.recipe.json"), "utf8");
  assert.deepEqual(JSON.parse(saved).edits.map((edit) => edit.edit), ["suggest", "set_target"]);
  writeFileSync(studio.path("mine.recipe.json"), "else");
  await studio.page.click("#save-as");
  await studio.page.fill("#save-name", "mine");
  await answer("folder"); // mine.recipe.json
  await studio.page.waitForSelector("text=Replace the file?");
  await studio.picture("question");
  await answer("replace");
  await studio.told(/mine\.recipe\.json is saved/);
  assert.equal(readFileSync(studio.path("mine.recipe.json"), "utf8"), saved);
});

test("a recipe in the folder is followed; the question comes only where there are edits", async () => {
  await studio.tab("history");
  await studio.after(() => studio.page.click('[data-step="0"]'));
  await studio.after(() => studio.suggest());
  await studio.page.click("#open");
  await studio.page.click('[data-file="mine.recipe.json"]');
  await studio.page.waitForSelector("text=Follow the recipe?");
  await answer("cancel");
  assert.deepEqual(await steps(), ["suggest"]);
  await studio.page.click("#open");
  await studio.page.click('[data-file="mine.recipe.json"]');
  const followed = await studio.after(() => answer("follow"));
  assert.deepEqual(await steps(), ["suggest", "set_target"]);
  assert.deepEqual(followed.statistics, made.statistics);
});

/** From now on whatever the program says over the socket comes that much later, in its order; 0: as it comes. */
const delay = (milliseconds) =>
  studio.page.evaluate((milliseconds) => {
    const { connection } = window.studio, { take } = Object.getPrototypeOf(connection);
    if (milliseconds > 0) connection.take = (data) => setTimeout(() => take.call(connection, data), milliseconds);
    else delete connection.take;
  }, milliseconds);

test("a mesh and its recipe are dropped together, and nothing is asked, however late the program's state comes", async () => {
  const other = studio.shape("sphere", 800);
  const recipe = JSON.parse(readFileSync(studio.path("mine.recipe.json"), "utf8"));
  recipe.options.quads = 300;
  recipe.edits.pop();
  await delay(1500);
  await drop([{ name: "dropped.recipe.json", text: JSON.stringify(recipe) }, { name: "dropped.off", text: readFileSync(other, "utf8") }]);
  await studio.page.waitForFunction(() => {
    const state = window.studio.store.get("state");
    return document.querySelector("dialog.question[open]") || (state.file?.name === "dropped.off" && state.history.length === 1 && state.finished);
  });
  await delay(0);
  assert.equal(await asks(), 0);
  const state = await studio.state();
  assert.ok(Math.abs(state.statistics.quads - 300) < 60, `${state.statistics.quads} of the recipe's 300`);
});

test("with a mesh that cannot be opened its recipe is not followed on what is open", async () => {
  const recipe = readFileSync(studio.path("mine.recipe.json"), "utf8"), { revision } = await studio.state();
  await drop([{ name: "broken.recipe.json", text: recipe }, { name: "broken.obj", text: "f 1 2 3\n" }]);
  await studio.told(/line 1/);
  await studio.settle();
  assert.equal(await asks(), 0);
  assert.equal((await studio.state()).revision, revision);
});

test("a recipe that cannot be followed says at which step, and changes nothing", async () => {
  const recipe = JSON.parse(readFileSync(studio.path("mine.recipe.json"), "utf8"));
  recipe.edits.push({ edit: "set_target", quads: -5 });
  const { revision } = await studio.state();
  await drop([{ name: "wrong.recipe.json", text: JSON.stringify(recipe) }]);
  await studio.page.waitForSelector("text=Follow the recipe?");
  await answer("follow");
  await studio.told(/step 3 of 3 \(set number: -5 quads/);
  assert.equal((await studio.state()).revision, revision);
});

test("after a kill the cards stand on the first page, and the options of a followed recipe are kept", async () => {
  const quads = (await studio.state()).statistics.quads;
  await studio.stopProgram("SIGKILL");
  await studio.startProgram();
  await studio.page.goto(studio.url);
  await studio.page.waitForSelector(".welcome .card");
  await studio.picture("welcome_cards");
  assert.deepEqual((await studio.page.locator(".welcome .card .name").allInnerTexts()).sort(), ["dropped.off", "torus.off"]);
  const state = await studio.after(() => studio.page.locator(".welcome .card", { hasText: "dropped.off" }).click());
  assert.equal(state.statistics.quads, quads);
  assert.ok(existsSync(studio.path(".reebquad")));
});

test("the page reported no errors", () => assert.deepEqual(studio.errors.filter((e) => !/WebSocket|ERR_CONNECTION|422/.test(e)), []));
