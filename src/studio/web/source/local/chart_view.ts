// SPDX-License-Identifier: GPL-3.0-or-later
// One chart beside its unit square: the texture's vertices and quads in the plane, mirrored on the surface.
import * as THREE from "three";
import { floats, indices, type Frame } from "../net/frame";
import { Lines } from "../scene/lines";
import type { App } from "../app";
import { h, icon, readable, replace } from "../ui/dom";
import { icons } from "../ui/icons";

interface Texture {
  id: number;
  kind: "annulus" | "disc";
  /** Across and up, in the plane: V and U. */
  plane: Float32Array;
  space: Float32Array;
  quads: Uint32Array;
  width: number;
  height: number;
}

const margin = 26;

export class ChartView {
  readonly panel = h("section", { className: "chart-view", hidden: true, "aria-label": "The texture of a chart" });
  private readonly canvas = h("canvas", {});
  private readonly title = h("strong", {});
  private readonly facts = h("span", { className: "time" });
  private readonly glow = new Lines(4, 0xffb454, { hidden: true });
  private readonly mesh = new Lines(1.6, 0x16181d);
  private texture: Texture | null = null;
  private hovered = -1;
  private wantedChart = -1;

  constructor(private readonly app: App) {
    const close = h("button", { className: "ghost small", title: "Close", "aria-label": "Close", onclick: () => app.store.set("chart", -1) }, icon(icons.close));
    replace(this.panel, h("header", {}, this.title, this.facts, h("span", { className: "spring" }), close), this.canvas);
    this.canvas.addEventListener("pointermove", (event) => this.hover(this.quadInPlane(event)));
    this.canvas.addEventListener("pointerleave", () => this.hover(-1));
    this.glow.object.renderOrder = 9;
    this.mesh.object.renderOrder = 3;
    app.viewport.scene.add(this.glow.object, this.mesh.object);
    app.store.watch(["chart", "state"], () => this.follow());
    app.store.watch(["layers"], () => this.showOnSurface());
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  private showOnSurface(): void {
    this.mesh.show(this.texture !== null && this.app.store.get("layers").has("surface"));
    this.app.viewport.invalidate();
  }

  /** Takes the program's frame of a chart. */
  take(frame: Frame): void {
    const { id, kind, width, height } = frame.data as { id: number; kind: "annulus" | "disc"; width: number; height: number };
    this.texture = { id, kind, width, height, plane: floats(frame, "plane"), space: floats(frame, "position"), quads: indices(frame, "quad") };
    this.title.textContent = `${kind === "disc" ? "Cap" : "Tube"} ${id}`;
    this.facts.textContent = `${readable(this.texture.quads.length / 4)} quads`;
    this.hovered = -1;
    this.panel.hidden = false;
    this.drawOnSurface();
    this.draw();
  }

  private follow(): void {
    const chart = this.app.store.get("chart");
    const charts = this.app.store.get("state")?.facts?.charts ?? [];
    if (chart < 0 || !charts.some((c) => c.id === chart)) {
      this.wantedChart = -1;
      this.texture = null;
      this.panel.hidden = true;
      this.mesh.set(new Float32Array());
      this.mesh.show(false);
      this.hover(-1);
      return;
    }
    this.wantedChart = chart;
    void this.app.connection.request("chart", { chart }).catch(() => (this.panel.hidden = true));
  }

  /** The quad under the pointer on the surface shines in the plane too. */
  hoverOnSurface(point: THREE.Vector3 | null): void {
    const t = this.texture;
    if (!t || !point || this.wantedChart < 0) return this.hover(-1);
    let best = -1, nearest = Infinity;
    for (let q = 0; q < t.quads.length / 4; ++q) {
      let x = 0, y = 0, z = 0;
      for (let i = 0; i < 4; ++i) {
        const v = 3 * t.quads[4 * q + i]!;
        x += t.space[v]! / 4;
        y += t.space[v + 1]! / 4;
        z += t.space[v + 2]! / 4;
      }
      const d = (x - point.x) ** 2 + (y - point.y) ** 2 + (z - point.z) ** 2;
      if (d < nearest) [nearest, best] = [d, q];
    }
    this.hover(best);
  }

  private hover(quad: number): void {
    if (quad === this.hovered) return;
    this.hovered = quad;
    const t = this.texture;
    const pairs: number[] = [];
    if (t && quad >= 0)
      for (let i = 0; i < 4; ++i)
        for (const v of [t.quads[4 * quad + i]!, t.quads[4 * quad + ((i + 1) % 4)]!])
          for (let k = 0; k < 3; ++k) pairs.push(t.space[3 * v + k]!);
    this.glow.set(new Float32Array(pairs));
    this.glow.show(pairs.length > 0);
    this.app.viewport.invalidate();
    this.draw();
  }

  private drawOnSurface(): void {
    const t = this.texture!;
    const pairs: number[] = [];
    for (let q = 0; q < t.quads.length; q += 4)
      for (let i = 0; i < 4; ++i)
        for (const v of [t.quads[q + i]!, t.quads[q + ((i + 1) % 4)]!]) for (let k = 0; k < 3; ++k) pairs.push(t.space[3 * v + k]!);
    this.mesh.set(new Float32Array(pairs));
    this.showOnSurface();
    this.app.viewport.invalidate();
  }

  /** A quad's corners in the plane. On a tube a quad may step over the seam: its corners are brought to one side. */
  private corners(t: Texture, quad: number): [number, number][] {
    const corners: [number, number][] = [];
    for (let i = 0; i < 4; ++i) {
      const v = t.quads[4 * quad + i]!;
      corners.push([t.plane[2 * v]!, t.plane[2 * v + 1]!]);
    }
    if (t.kind === "annulus" && Math.max(...corners.map((c) => c[0])) - Math.min(...corners.map((c) => c[0])) > 0.5)
      for (const corner of corners) if (corner[0] < 0.5) corner[0] += 1;
    return corners;
  }

  private scale(t: Texture): { x: (v: number) => number; y: (u: number) => number; a: number; b: number } {
    const w = this.canvas.clientWidth - 2 * margin, hgt = this.canvas.clientHeight - 2 * margin;
    return { x: (v) => margin + (v / t.width) * w, y: (u) => margin + (1 - u / t.height) * hgt, a: w / t.width, b: hgt / t.height };
  }

  private quadInPlane(event: PointerEvent): number {
    const t = this.texture;
    if (!t) return -1;
    const box = this.canvas.getBoundingClientRect(), s = this.scale(t);
    const p: [number, number] = [(event.clientX - box.left - margin) / s.a, t.height - (event.clientY - box.top - margin) / s.b];
    for (let q = 0; q < t.quads.length / 4; ++q) {
      const corners = this.corners(t, q);
      if (inside(corners, p) || (t.kind === "annulus" && inside(corners, [p[0] + 1, p[1]]))) return q;
    }
    return -1;
  }

  private draw(): void {
    const t = this.texture, context = this.canvas.getContext("2d");
    if (!t || !context || this.panel.hidden) return;
    const ratio = devicePixelRatio;
    this.canvas.width = this.canvas.clientWidth * ratio;
    this.canvas.height = this.canvas.clientHeight * ratio;
    context.scale(ratio, ratio);
    const style = getComputedStyle(document.documentElement), s = this.scale(t);
    context.lineWidth = 1;
    context.strokeStyle = style.getPropertyValue("--soft");
    for (let q = 0; q < t.quads.length / 4; ++q) {
      path(context, this.corners(t, q), s);
      context.fillStyle = q === this.hovered ? "#ffb454" : style.getPropertyValue("--raised");
      context.fill();
      context.stroke();
    }
    context.lineWidth = 2.5;
    context.strokeStyle = style.getPropertyValue("--ink");
    context.strokeRect(s.x(0), s.y(t.height), s.a * t.width, s.b * t.height);
    context.fillStyle = style.getPropertyValue("--soft");
    context.font = "11px system-ui, sans-serif";
    context.textAlign = "center";
    const middle = this.canvas.clientWidth / 2;
    context.fillText(t.kind === "annulus" ? "upper contour" : "one side of the square", middle, 15);
    context.fillText(t.kind === "annulus" ? "lower contour: the left and right ends are joined" : "the other three sides follow", middle, this.canvas.clientHeight - 9);
  }
}

function path(context: CanvasRenderingContext2D, corners: [number, number][], s: { x: (v: number) => number; y: (u: number) => number }): void {
  context.beginPath();
  for (const [v, u] of corners) context.lineTo(s.x(v), s.y(u));
  context.closePath();
}

function inside(corners: [number, number][], [x, y]: [number, number]): boolean {
  let crossings = 0;
  for (let i = 0, j = corners.length - 1; i < corners.length; j = i++) {
    const [xi, yi] = corners[i]!, [xj, yj] = corners[j]!;
    if (yi > y !== yj > y && x < ((xj - xi) * (y - yi)) / (yj - yi) + xi) ++crossings;
  }
  return crossings % 2 === 1;
}
