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
  private shine: Shine = { places: [], vertices: [], anchors: [] };
  private pressed = false;

  constructor(private readonly app: Workbench) {
    const close = h("button", { className: "ghost small", title: "Close", "aria-label": "Close", onclick: () => app.store.set("chart", -1) }, icon(icons.close));
    replace(this.panel, h("header", {}, this.title, this.facts, h("span", { className: "spring" }), close), this.canvas);
    this.listen();
    this.glow.object.renderOrder = 9;
    this.mesh.object.renderOrder = 3;
    this.dotMaterial.depthTest = false;
    this.dotMaterial.uniforms.ratio!.value = Math.min(devicePixelRatio, 2);
    app.viewport.scene.add(this.glow.object, this.mesh.object, this.dots);
    app.store.watch(["chart", "state"], () => this.follow());
    app.store.watch(["layers"], () => this.showOnSurface());
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  /** Takes the program's frame of a chart. */
  take(frame: Frame): void {
    const texture = new Texture(frame);
    if (texture.id !== this.app.store.get("chart")) return;
    const isOther = texture.id !== this.texture?.id || texture.size !== this.texture.size;
    this.texture = texture;
    this.title.textContent = `${texture.kind === "disc" ? "Cap" : "Tube"} ${texture.id}`;
    this.facts.textContent = `${readable(texture.size)} quads`;
    this.panel.hidden = false;
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

  private follow(): void {
    const chart = this.app.store.get("chart");
    const charts = this.app.store.get("state")?.facts?.charts ?? [];
    if (chart < 0 || !charts.some((c) => c.id === chart)) {
      this.texture = null;
      this.panel.hidden = true;
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
      if (at && this.pressed) listener().drag?.(at);
      else listener().hover(at);
    });
    this.canvas.addEventListener("pointerleave", () => !this.pressed && listener().hover(null));
    this.canvas.addEventListener("pointerdown", (event) => {
      const at = this.planePoint(event);
      if (event.button !== 0 || !at) return;
      this.canvas.setPointerCapture(event.pointerId);
      this.pressed = true;
      listener().press?.(at);
    });
    this.canvas.addEventListener("pointerup", (event) => {
      const at = this.planePoint(event);
      if (this.pressed && at) listener().release?.(at);
      this.pressed = false;
    });
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
    const w = this.canvas.clientWidth - 2 * margin, hgt = this.canvas.clientHeight - 2 * margin;
    return { x: (v) => margin + (v / t.width) * w, y: (u) => margin + (1 - u / t.height) * hgt, a: w / t.width, b: hgt / t.height };
  }

  private planePoint(event: PointerEvent): PlanePoint | null {
    const t = this.texture;
    if (!t) return null;
    const box = this.canvas.getBoundingClientRect(), s = this.scale(t);
    return [(event.clientX - box.left - margin) / s.a, t.height - (event.clientY - box.top - margin) / s.b];
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
    context.font = "12px system-ui, sans-serif";
    context.textAlign = "center";
    const middle = this.canvas.clientWidth / 2, below = t.kind === "annulus" ? "lower contour: the left and right ends are joined" : "the other three sides follow";
    const fits = context.measureText(below).width < this.canvas.clientWidth - 8;
    context.fillText(t.kind === "annulus" ? "upper contour" : "one side of the square", middle, 15);
    context.fillText(fits ? below : below.replace(/:.*/, ""), middle, this.canvas.clientHeight - 9);
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
