// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the program and a browser without a screen, and says in a line each what a user does.
// Whatever is waited for is waited for as a condition, and with patience: machines of continuous integration are slow, and do other work
// beside. What is told for a while only is noted by the page, so that nobody can come too late to read it.
import { execFileSync, spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";

const program = process.env.REEBQUAD_PROGRAM;
export const pageModules = createRequire(join(process.env.STUDIO_PAGE_DIR, "package.json"));
const artefacts = process.env.STUDIO_ARTEFACTS;
mkdirSync(artefacts, { recursive: true });
/** Whether pictures are kept, for people to look at: software takes a second or more for one. */
const takesPictures = Boolean(process.env.STUDIO_PICTURES);
/** How long anything may take, in milliseconds. */
const patience = Number(process.env.PATIENCE ?? 150000);

/** Where a picture of that name is kept. */
function artefact(name) {
  return join(artefacts, `${name}.png`);
}

export function reebquad(...args) {
  return execFileSync(program, args, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
}

/** A page in a context of its own, which waits with patience. */
export async function newPage(browser, options) {
  const context = await browser.newContext(options);
  context.setDefaultTimeout(patience);
  await context.addInitScript(noteMessages);
  await context.addInitScript(keepDrawing, takesPictures);
  return context.newPage();
}

/** Keeps what a page shows as a picture of that name, where pictures are wanted. */
export async function takePicture(page, name) {
  if (!takesPictures) return;
  await settle(page);
  await page.screenshot({ path: artefact(name) });
}

/** Waits for two more pictures. */
export function settle(page) {
  return page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(resolve, 60)))));
}

/** A number that is another one when something else is drawn in space: what the page has drawn last, not what it would draw. */
export async function drawn(page) {
  await settle(page);
  return page.evaluate(() => {
    const gl = document.querySelector(".canvas canvas").getContext("webgl2"), { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
    const pixels = new Int32Array(width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(pixels.buffer));
    return pixels.reduce((hash, pixel) => (Math.imul(hash, 31) + pixel) | 0, 0);
  });
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
    studio.page = await newPage(studio.browser, { viewport: { width, height }, colorScheme: theme, acceptDownloads: true });
    studio.page.on("pageerror", (error) => studio.errors.push(error.message));
    studio.page.on("console", (message) => {
      if (message.type() === "error") studio.errors.push(message.text());
    });
    await studio.startProgram();
    await studio.page.goto(studio.url);
    await studio.page.waitForFunction(() => window.studio?.store.get("connected"));
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
    }, before);
    return this.state();
  }

  async upload(file) {
    return this.after(() => this.page.setInputFiles("#file-input", file));
  }
  /** Shows these panels. */
  async tab(id) {
    await this.page.click(`[data-tab="${id}"]`);
  }
  async suggest() {
    await this.tab("design");
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
      viewport.flight = null;
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

  settle() {
    return settle(this.page);
  }
  picture(name) {
    return takePicture(this.page, name);
  }
  drawn() {
    return drawn(this.page);
  }

  async download(action) {
    const [download] = await Promise.all([this.page.waitForEvent("download"), action()]);
    return readFileSync(await download.path());
  }

  /** Waits until the page has told something like this, after what was told the last time that this was asked. */
  async told(pattern) {
    const message = await this.page.waitForFunction(([source, flags]) => {
      const at = window.told.findIndex((text, i) => i >= window.heard && new RegExp(source, flags).test(text));
      if (at < 0) return null;
      window.heard = at + 1;
      return window.told[at];
    }, [pattern.source, pattern.flags]).catch(async (error) => {
      throw new Error(`${pattern} was not told, but: ${JSON.stringify(await this.page.evaluate(() => window.told))}`, { cause: error });
    });
    return message.jsonValue();
  }

  /** Waits until nothing runs, and all is relaxed. */
  async quiet() {
    await this.page.waitForFunction(() => window.studio.store.get("state").finished !== false && !window.studio.store.get("busy"));
  }

  /** Waits until the camera flies no more and its turn has died away. */
  async landed() {
    await this.page.waitForFunction(() => window.studio.viewport.flight === null && !window.studio.viewport.turns);
  }

  /** Looks at everything. */
  async home() {
    await this.page.keyboard.press("h");
    await this.landed();
  }
}

/** In the page: what was drawn can be read; and where nobody looks, edges are not smooth: software draws several times as fast so. */
function keepDrawing(isSmooth) {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return getContext.call(this, kind, /webgl/.test(kind) ? { ...options, antialias: isSmooth, preserveDrawingBuffer: true } : options);
  };
}

/** In the page: keeps what it tells, though it tells it for a moment. */
function noteMessages() {
  [window.told, window.heard] = [[], 0];
  new MutationObserver((changes) => {
    for (const { addedNodes } of changes) for (const node of addedNodes) if (node.matches?.(".toast")) window.told.push(node.textContent);
  }).observe(document, { subtree: true, childList: true });
}
