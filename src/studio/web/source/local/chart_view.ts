// SPDX-License-Identifier: GPL-3.0-or-later
// One chart beside its unit square: the texture in the plane and on the surface, with what shines shining in both.
import * as THREE from "three";
import type { Frame } from "../net/frame";
import { Lines, markers } from "../scene/lines";
import { markerMaterial, Shape } from "../scene/materials";
import type { Workbench } from "../workbench";
import { h, icon, readable, replace } from "../ui/dom";
import { icons } from "../ui/icons";
import type { ChartDisplay, PlaneListener, Shine } from "./chart_display";
import { Texture, type PlanePoint } from "./texture";

const margin = 26;
const closest = 40, zoomStride = 1.25, panStride = 40;
const glowColour = "#ffb454", anchorColour = "#4aa8ff";

export class ChartView implements ChartDisplay {
  readonly panel = h("section", { className: "chart-view", hidden: true, "aria-label": "The texture of a chart" });
  texture: Texture | null = null;
  /** Gets the pointer instead of the view's own highlight. */
  listener: PlaneListener | null = null;
  private readonly canvas = h("canvas", {});
  private readonly title = h("strong", {});
  private readonly facts = h("span", { className: "time" });
  private readonly glow = new Lines(4, 0xffb454, { hidden: true });
  private readonly mesh = new Lines(1.6, 0x16181d);
  private readonly dots = new THREE.Group();
  private readonly dotMaterial = markerMaterial();
  /** How many times larger than as a whole, and what of the plane is in the middle; null: all of it. */
  private zoom = 1;
  private middle: PlanePoint | null = null;
  private panned: { x: number; y: number } | null = null;
  private proportion = 1;
  private shine: Shine = { places: [], vertices: [], anchors: [] };
  private pressed = false;

  /** `bar` is what stands between this view and the model. */
  constructor(private readonly app: Workbench, private readonly bar: HTMLElement) {
    const button = (text: string, id: string, title: string, run: () => void): HTMLElement => h("button", { className: "ghost small", id, title, "aria-label": title, onclick: run }, text);
    const close = h("button", { className: "ghost small", title: "Close", "aria-label": "Close the chart", onclick: () => app.store.set("chart", -1) }, icon(icons.close));
    replace(this.panel, h("header", {}, this.title, this.facts, h("span", { className: "spring" }), button("−", "chart-further", "Smaller (−)", () => this.zoomBy(1 / zoomStride)), button("+", "chart-nearer", "Larger (+)", () => this.zoomBy(zoomStride)), button("All", "chart-all", "All of the chart (0)", () => this.fit()), close), this.canvas);
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("aria-label", "The chart's texture: wheel, + and − zoom, arrows or a drag with the right button move");
    this.listen();
    this.listenToMoves();
    this.glow.object.renderOrder = 9;
    this.mesh.object.renderOrder = 3;
    this.dotMaterial.depthTest = false;
    this.dotMaterial.uniforms.ratio!.value = Math.min(devicePixelRatio, 2);
    app.viewport.scene.add(this.glow.object, this.mesh.object, this.dots);
    app.store.watch(["chart", "state", "tool"], () => this.follow());
    app.store.watch(["layers"], () => this.showOnSurface());
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  /** Takes the program's frame of a chart. */
  take(frame: Frame): void {
    const texture = new Texture(frame);
    if (texture.id !== this.wanted) return;
    const opens = texture.id !== this.texture?.id;
    if (opens) [this.zoom, this.middle] = [1, null];
    this.proportion = texture.proportion;
    const isOther = texture.id !== this.texture?.id || texture.size !== this.texture.size;
    this.texture = texture;
    this.title.textContent = `${texture.kind === "disc" ? "Cap" : "Tube"} ${texture.id}`;
    this.facts.textContent = `${readable(texture.size)} quads`;
    this.panel.hidden = this.bar.hidden = false;
    if (opens) this.app.frameChart(); // in the room that is left
    this.app.tools.tellHint();
    this.mesh.set(this.app.stage.surface.drape(texture.edgesInSpace(Array.from({ length: texture.size }, (_, q) => q))));
    this.showOnSurface();
    this.light(isOther ? { places: [], vertices: [], anchors: this.shine.anchors } : this.shine);
  }

  /** The quad under the pointer on the surface shines in the plane too. */
  hoverOnSurface(point: THREE.Vector3 | null): void {
    this.light({ places: this.texture && point ? [this.texture.placeNear("quad", point)] : [], vertices: [], anchors: [] });
  }

  light(shine: Shine): void {
    this.shine = shine;
    const t = this.texture;
    const pairs: number[] = [];
    for (const place of t ? shine.places : []) {
      const corners = t!.cornersInSpace(place.quad);
      if (place.kind === "quad") pairs.push(...t!.edgesInSpace([place.quad]));
      if (place.kind === "edge") pairs.push(...corners[place.corner]!.toArray(), ...corners[(place.corner + 1) % 4]!.toArray());
    }
    this.glow.set(pairs.length > 0 ? this.app.stage.surface.drape(new Float32Array(pairs)) : new Float32Array());
    this.glow.show(pairs.length > 0);
    this.drawDots();
    this.app.viewport.invalidate();
    this.draw();
  }

  private showOnSurface(): void {
    this.mesh.show(this.texture !== null && this.app.store.get("layers").has("surface"));
    this.app.viewport.invalidate();
  }

  /** The chart that is to be shown, or -1. */
  private get wanted(): number {
    const { store } = this.app, chart = store.get("chart");
    return store.get("tool") === "texture" && store.get("state")?.facts?.charts.some((c) => c.id === chart) ? chart : -1;
  }

  private follow(): void {
    const chart = this.wanted;
    if (chart < 0) {
      if (this.panel.hidden && !this.texture) return;
      this.texture = null;
      this.panel.hidden = this.bar.hidden = true;
      this.mesh.set(new Float32Array());
      this.mesh.show(false);
      this.light({ places: [], vertices: [], anchors: [] });
      return;
    }
    void this.app.connection.request("chart", { chart }).catch(() => undefined);
  }

  private listen(): void {
    const own: PlaneListener = {
      hover: (at) => this.light({ places: at && this.texture ? [this.texture.placeAt("quad", at)].filter((p) => p !== null) : [], vertices: [], anchors: [] }),
    };
    const listener = (): PlaneListener => this.listener ?? own;
    this.canvas.addEventListener("pointermove", (event) => {
      const at = this.planePoint(event);
      if (this.panned) return this.panTo(event);
      if (at && this.pressed) listener().drag?.(at);
      else listener().hover(at);
    });
    this.canvas.addEventListener("pointerleave", () => !this.pressed && listener().hover(null));
    this.canvas.addEventListener("pointerdown", (event) => {
      const at = this.planePoint(event);
      this.canvas.setPointerCapture(event.pointerId);
      if (event.button !== 0 || event.shiftKey) return void (this.panned = { x: event.clientX, y: event.clientY });
      if (!at) return;
      this.pressed = true;
      listener().press?.(at);
    });
    this.canvas.addEventListener("pointerup", (event) => {
      const at = this.planePoint(event);
      if (this.pressed && at) listener().release?.(at);
      this.pressed = false;
      this.panned = null;
    });
  }

  /** What moves and enlarges the plane. */
  private listenToMoves(): void {
    this.canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    this.canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      if (!event.ctrlKey && (event.shiftKey || Math.abs(event.deltaX) > 2 * Math.abs(event.deltaY))) return this.panBy(-event.deltaX, -event.deltaY);
      this.zoomBy(1.0015 ** -event.deltaY, event);
    }, { passive: false });
    this.canvas.addEventListener("keydown", (event) => {
      const moves: Record<string, () => void> = {
        "+": () => this.zoomBy(zoomStride), "-": () => this.zoomBy(1 / zoomStride), "0": () => this.fit(),
        ArrowLeft: () => this.panBy(panStride, 0), ArrowRight: () => this.panBy(-panStride, 0), ArrowUp: () => this.panBy(0, panStride), ArrowDown: () => this.panBy(0, -panStride),
      };
      const move = event.ctrlKey || event.metaKey || event.altKey ? undefined : moves[event.key];
      if (!move) return;
      event.preventDefault();
      event.stopPropagation();
      move();
    });
  }

  /** Shows all of the chart. */
  private fit(): void {
    [this.zoom, this.middle] = [1, null];
    this.draw();
  }

  /** Larger by a factor above 1; what is under the pointer stays there, or without one what is in the middle. */
  private zoomBy(factor: number, pointer?: MouseEvent): void {
    const t = this.texture, at = pointer && this.planePoint(pointer);
    if (!t) return;
    const before = this.zoom, [v, u] = this.centre(t);
    this.zoom = Math.min(Math.max(before * factor, 1), closest);
    const kept = before / this.zoom; // of the way from what stays to the middle
    if (at) this.middle = [at[0] + (v - at[0]) * kept, at[1] + (u - at[1]) * kept];
    if (this.zoom === 1) this.middle = null;
    this.draw();
  }

  private panTo(event: PointerEvent): void {
    const from = this.panned!;
    this.panned = { x: event.clientX, y: event.clientY };
    this.panBy(event.clientX - from.x, event.clientY - from.y);
  }

  /** Moves what is drawn by pixels; something of it stays in sight. */
  private panBy(x: number, y: number): void {
    const t = this.texture;
    if (!t) return;
    const s = this.scale(t), [v, u] = this.centre(t);
    this.middle = [Math.min(Math.max(v - x / s.a, 0), t.width), Math.min(Math.max(u + y / s.b, 0), t.height)];
    this.draw();
  }

  private centre(t: Texture): PlanePoint {
    return this.middle ?? [t.width / 2, t.height / 2];
  }

  private drawDots(): void {
    for (const child of [...this.dots.children]) {
      (child as THREE.Points).geometry.dispose();
      this.dots.remove(child);
    }
    const points: THREE.Vector3[] = [], colours: [number, number, number][] = [], scales: number[] = [];
    const add = (point: THREE.Vector3, colour: [number, number, number], scale: number): void => {
      points.push(point);
      colours.push(colour);
      scales.push(scale);
    };
    const t = this.texture;
    if (t) {
      for (const v of this.shine.vertices) add(t.inSpace(v), [1, 0.83, 0.5], 0.6);
      for (const place of this.shine.places) if (place.kind === "corner") add(t.inSpace(t.vertexOf(place)), [1, 0.7, 0.33], 1);
      for (const anchor of this.shine.anchors) add(anchor, [0.29, 0.66, 1], 0.9);
    }
    if (points.length === 0) return;
    const dots = markers(this.dotMaterial, new Float32Array(points.flatMap((p) => p.toArray())), colours, points.map(() => Shape.disc), scales);
    dots.renderOrder = 10;
    this.dots.add(dots);
  }

  private scale(t: Texture): { x: (v: number) => number; y: (u: number) => number; a: number; b: number } {
    const { clientWidth, clientHeight } = this.canvas, wide = Math.max(clientWidth - 2 * margin, 1), high = Math.max(clientHeight - 2 * margin, 1);
    const a = this.zoom * Math.min(wide / t.width, high / (t.height * this.proportion)), b = a * this.proportion, [v0, u0] = this.centre(t);
    return { x: (v) => clientWidth / 2 + (v - v0) * a, y: (u) => clientHeight / 2 - (u - u0) * b, a, b };
  }

  private planePoint(event: MouseEvent): PlanePoint | null {
    const t = this.texture;
    if (!t) return null;
    const box = this.canvas.getBoundingClientRect(), s = this.scale(t);
    return [(event.clientX - box.left - s.x(0)) / s.a, (s.y(0) - (event.clientY - box.top)) / s.b];
  }

  /** Where a vertex is on the screen, in pixels of the page; for tests. */
  screen(vertex: number): { x: number; y: number } {
    const t = this.texture!, box = this.canvas.getBoundingClientRect(), s = this.scale(t), [v, u] = t.inPlane(vertex);
    return { x: box.left + s.x(v), y: box.top + s.y(u) };
  }

  private draw(): void {
    const t = this.texture, context = this.canvas.getContext("2d");
    if (!t || !context || this.panel.hidden) return;
    const ratio = devicePixelRatio;
    this.canvas.width = this.canvas.clientWidth * ratio;
    this.canvas.height = this.canvas.clientHeight * ratio;
    context.scale(ratio, ratio);
    const css = getComputedStyle(document.documentElement), colour = (name: string): string => css.getPropertyValue(name);
    const s = this.scale(t);
    context.save();
    context.beginPath();
    context.rect(s.x(0) - 1, s.y(t.height) - 1, s.a * t.width + 2, s.b * t.height + 2);
    context.clip();
    const lit = new Set(this.shine.places.filter((p) => p.kind === "quad").map((p) => p.quad));
    context.lineWidth = 1;
    context.strokeStyle = colour("--soft");
    for (let q = 0; q < t.size; ++q) {
      context.fillStyle = lit.has(q) ? glowColour : t.holes[q] ? colour("--ground") : colour("--raised");
      this.eachTurn(t, q, (corners) => {
        path(context, corners, s);
        context.fill();
        context.setLineDash(t.holes[q] ? [3, 3] : []);
        context.stroke();
      });
    }
    context.setLineDash([]);
    this.drawShine(context, t, s);
    context.restore();
    context.lineWidth = 2.5;
    context.strokeStyle = colour("--ink");
    if (t.kind === "disc") context.strokeRect(s.x(0), s.y(t.height), s.a * t.width, s.b * t.height);
    else this.drawTubeFrame(context, t, s, colour("--soft"));
    context.fillStyle = colour("--soft");
    this.drawLabels(context, t, s);
  }

  /** What the upper and the lower side of the plane are, beside them, where they are in sight. */
  private drawLabels(context: CanvasRenderingContext2D, t: Texture, s: ReturnType<ChartView["scale"]>): void {
    context.font = "12px system-ui, sans-serif";
    context.textAlign = "center";
    const middle = this.canvas.clientWidth / 2, below = t.kind === "annulus" ? "lower contour: the left and right ends are joined" : "the other three sides follow";
    const fits = context.measureText(below).width < this.canvas.clientWidth - 8;
    context.fillText(t.kind === "annulus" ? "upper contour" : "one side of the square", middle, s.y(t.height) - 9);
    context.fillText(fits ? below : below.replace(/:.*/, ""), middle, s.y(0) + 18);
  }

  private drawShine(context: CanvasRenderingContext2D, t: Texture, s: ReturnType<ChartView["scale"]>): void {
    const dot = ([v, u]: PlanePoint, colour: string, radius: number): void => {
      context.fillStyle = colour;
      context.beginPath();
      context.arc(s.x(v), s.y(u), radius, 0, 2 * Math.PI);
      context.fill();
    };
    for (const v of this.shine.vertices) dot(t.inPlane(v), glowColour, 2.6);
    for (const place of this.shine.places) {
      if (place.kind === "corner") dot(t.inPlane(t.vertexOf(place)), glowColour, 5);
      if (place.kind !== "edge") continue;
      context.lineWidth = 4;
      context.strokeStyle = glowColour;
      this.eachTurn(t, place.quad, (corners) => {
        path(context, [corners[place.corner]!, corners[(place.corner + 1) % 4]!], s);
        context.stroke();
      });
    }
    for (const anchor of this.shine.anchors) {
      const [vertex] = [t.vertexOf(t.placeNear("corner", anchor))];
      dot(t.inPlane(vertex), anchorColour, 5);
    }
  }

  /** The two contours as bold lines, the seam as a thin one on both sides. */
  private drawTubeFrame(context: CanvasRenderingContext2D, t: Texture, s: ReturnType<ChartView["scale"]>, soft: string): void {
    for (const u of [0, t.height]) {
      path(context, [[0, u], [t.width, u]], s);
      context.stroke();
    }
    context.lineWidth = 1;
    context.setLineDash([4, 4]);
    context.strokeStyle = soft;
    for (const v of [0, t.width]) {
      path(context, [[v, 0], [v, t.height]], s);
      context.stroke();
    }
    context.setLineDash([]);
  }

  /** A quad that steps over the seam is drawn at both ends. */
  private eachTurn(t: Texture, quad: number, draw: (corners: PlanePoint[]) => void): void {
    const corners = t.corners(quad);
    draw(corners);
    if (t.kind === "annulus" && corners.some(([v]) => v > 1)) draw(corners.map(([v, u]) => [v - 1, u]));
  }
}

function path(context: CanvasRenderingContext2D, corners: PlanePoint[], s: { x: (v: number) => number; y: (u: number) => number }): void {
  context.beginPath();
  for (const [v, u] of corners) context.lineTo(s.x(v), s.y(u));
  context.closePath();
}
