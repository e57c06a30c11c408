// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the program and a browser without a screen, and says in a line each what a user does.
import { execFileSync, spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";

const program = process.env.REEBQUAD_PROGRAM;
export const pageModules = createRequire(join(process.env.STUDIO_PAGE_DIR, "package.json"));
const artefacts = process.env.STUDIO_ARTEFACTS;
mkdirSync(artefacts, { recursive: true });
const patience = 60000;

/** Where a picture of that name is kept. */
export function artefact(name) {
  return join(artefacts, `${name}.png`);
}

export function reebquad(...args) {
  return execFileSync(program, args, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
}

export class Studio {
  folder = mkdtempSync(join(tmpdir(), "reebquad-page-"));
  errors = [];

  static async start({ theme = "dark", width = 1400, height = 860 } = {}) {
    const studio = new Studio();
    const { chromium } = pageModules("playwright-core");
    studio.browser = await chromium.launch({
      executablePath: process.env.CHROMIUM,
      // Software for the pictures, so that they are the same everywhere; containers have no user namespaces for the sandbox.
      args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage"],
    });
    const context = await studio.browser.newContext({ viewport: { width, height }, colorScheme: theme, acceptDownloads: true });
    studio.page = await context.newPage();
    studio.page.on("pageerror", (error) => studio.errors.push(error.message));
    studio.page.on("console", (message) => {
      if (message.type() === "error") studio.errors.push(message.text());
    });
    await studio.startProgram();
    await studio.page.goto(studio.url);
    await studio.page.waitForFunction(() => window.studio?.store.get("connected"), null, { timeout: patience });
    return studio;
  }

  async startProgram() {
    this.program = spawn(program, ["studio", "--no-browser", "--port", "0"], { cwd: this.folder, stdio: ["ignore", "pipe", "inherit"] });
    this.url = await new Promise((resolve, reject) => {
      let text = "";
      this.program.stdout.on("data", (bytes) => {
        text += bytes;
        if (text.includes("\n")) resolve(text.split("\n")[0]);
      });
      this.program.on("exit", (code) => reject(new Error(`the program ended with ${code}`)));
    });
  }

  async stopProgram(signal = "SIGKILL") {
    const ended = new Promise((resolve) => this.program.on("exit", resolve));
    this.program.kill(signal);
    await ended;
  }

  async close() {
    await this.browser.close();
    await this.stopProgram();
    rmSync(this.folder, { recursive: true, force: true });
  }

  path(name) {
    return join(this.folder, name);
  }

  read(file) {
    return readFileSync(file, "utf8");
  }

  /**
   * Turns the camera for some pictures: the milliseconds that the page itself takes for one (the median), without what the graphics
   * processor does, which is none here; and what is drawn.
   */
  costOfPictures(pictures = 40) {
    return this.page.evaluate(async (pictures) => {
      const { viewport } = window.studio, { renderer, camera } = viewport, gl = renderer.getContext();
      const drawing = ["drawArrays", "drawElements", "drawArraysInstanced", "drawElementsInstanced", "clear"];
      for (const name of drawing) gl[name] = () => {};
      const times = [], render = renderer.render, frame = viewport.frame;
      let info;
      viewport.frame = function (time) {
        const start = performance.now(), more = frame.call(this, time);
        times.push(performance.now() - start);
        return more;
      };
      renderer.render = function (...all) {
        render.apply(this, all);
        info ??= { ...this.info.render };
      };
      for (let i = 0; i < pictures; ++i) {
        await new Promise((resolve) => requestAnimationFrame(resolve));
        camera.position.applyAxisAngle(camera.up, 0.02);
        viewport.invalidate();
      }
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      delete viewport.frame;
      renderer.render = render;
      for (const name of drawing) delete gl[name];
      times.sort((a, b) => a - b);
      return { milliseconds: times[times.length >> 1], pictures: times.length, calls: info.calls, triangles: info.triangles, points: info.points };
    }, pictures);
  }

  /** Turns on exactly these layers. */
  layers(...ids) {
    return this.page.evaluate((ids) => window.studio.store.set("layers", new Set(ids)), ids);
  }

  /** A built-in shape as a file in the folder. */
  shape(name, triangles) {
    const file = this.path(`${name}.off`);
    reebquad("shape", name, "-o", file, "--triangles", String(triangles));
    return file;
  }

  state() {
    return this.page.evaluate(() => window.studio.store.get("state"));
  }

  /** Does something and waits until the program's state has changed and nothing runs. */
  async after(action) {
    const before = (await this.state())?.revision ?? 0;
    await action();
    await this.page.waitForFunction((r) => {
      const { store } = window.studio, state = store.get("state");
      return (state?.revision ?? 0) > r && state.finished !== false && !store.get("busy");
    }, before, { timeout: patience });
    return this.state();
  }

  async upload(file) {
    return this.after(() => this.page.setInputFiles("#file-input", file));
  }
  async suggest() {
    return this.after(() => this.page.click("#suggest"));
  }
  async view(id) {
    await this.page.click(`[data-view="${id}"]`);
  }
  async tool(id, variant) {
    await this.page.click(`[data-tool="${id}"]`);
    if (variant) await this.page.click(`[data-variant="${variant}"]`);
  }

  /** Where a point of the picture's space is on the screen. */
  screen(point) {
    return this.page.evaluate(([x, y, z]) => {
      const { viewport } = window.studio;
      return viewport.project(viewport.controls.target.clone().set(x, y, z));
    }, point);
  }
  /** Turns the camera so that it looks at a point from outside along a direction. */
  async lookAt(point, from, radii = 2.6) {
    await this.page.evaluate(([p, d, r]) => {
      const { viewport, stage } = window.studio;
      viewport.controls.target.set(...p);
      viewport.camera.position.set(...p).add(viewport.controls.target.clone().set(...d).setLength(r * stage.surface.radius));
      viewport.controls.target.set(...p);
      viewport.controls.update();
      viewport.invalidate();
    }, [point, from, radii]);
    await this.settle();
  }
  /** The surface's normal in the face nearest to a point. */
  normalAt(point) {
    return this.page.evaluate(([x, y, z]) => {
      const { surface } = window.studio.stage, t = surface.triangles;
      const at = surface.vertex(0).clone().set(x, y, z);
      let best = 0, nearest = Infinity;
      for (let f = 0; f < t.length; f += 3) {
        const d = surface.vertex(t[f]).distanceToSquared(at);
        if (d < nearest) [nearest, best] = [d, f];
      }
      const [a, b, c] = [0, 1, 2].map((k) => surface.vertex(t[best + k]));
      return b.sub(a).cross(c.sub(a)).normalize().toArray();
    }, point);
  }
  /** Looks at a point of the surface from outside. */
  async face(point, radii) {
    await this.lookAt(point, await this.normalAt(point), radii);
  }
  async clickOn(point, radii) {
    await this.face(point, radii);
    await this.clickAt(point);
  }
  /** A point inside the tallest tube. */
  insideTallestTube() {
    return this.page.evaluate(() => {
      const { store, stage } = window.studio;
      const { id } = store.get("state").facts.charts.filter((c) => c.kind === "annulus").sort((a, b) => b.height - a.height)[0];
      return stage.surface.insideOf(id).toArray();
    });
  }

  async clickAt(point) {
    const { x, y } = await this.screen(point);
    await this.page.mouse.move(x, y);
    await this.page.mouse.click(x, y);
  }

  /** Waits for two more pictures. */
  async settle() {
    await this.page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(resolve, 60)))));
  }

  async picture(name) {
    await this.settle();
    await this.page.screenshot({ path: artefact(name) });
  }

  async download(action) {
    const [download] = await Promise.all([this.page.waitForEvent("download", { timeout: patience }), action()]);
    return readFileSync(await download.path());
  }

  async toast() {
    const toast = this.page.locator(".toast").last();
    await toast.waitFor({ timeout: patience });
    return toast.innerText();
  }
}
