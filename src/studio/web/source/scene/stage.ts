// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that is drawn: takes the program's layers and shows those that are turned on.
import * as THREE from "three";
import { bytesOf, floats, indices, integers, type Frame } from "../net/frame";
import { criticalColours } from "./colours";
import type { LayerId } from "./layers";
import { Lines, markers, polylinePairs } from "./lines";
import { markerMaterial, setGround, Shape, SurfaceColour } from "./materials";
import { Others } from "./others";
import type { Shading } from "./normals";
import { edgePairs, Quads } from "./quads";
import { Surface } from "./surface";
import type { Viewport } from "./viewport";

export interface CriticalPoint {
  vertex: number;
  /** 0 minimum, 1 saddle, 2 maximum, 3 half-saddle, 4 quarter-saddle. */
  kind: number;
  multiplicity: number;
  position: THREE.Vector3;
}

export interface Contour {
  edge: number;
  kind: string;
  count: number;
  points: THREE.Vector3[];
}

const contourWidth = 3.2;

/** A contour that runs through no saddle and is no boundary. */
export function isFree(contour: Contour): boolean {
  return contour.kind === "regular";
}

/** The pairs of neighbouring points of contours. */
export function pairsOf(contours: readonly Contour[]): Float32Array {
  const pairs: number[] = [];
  for (const { points } of contours)
    for (let i = 0; i + 1 < points.length; ++i) pairs.push(...points[i]!.toArray(), ...points[i + 1]!.toArray());
  return new Float32Array(pairs);
}

export class Stage {
  readonly surface = new Surface();
  readonly quads = new Quads();
  readonly others = new Others();
  readonly contourLines = new Lines(contourWidth, 0x16181d);
  /** In the middle of contours that run through no saddle: these can be dragged and removed. */
  readonly freeLines = new Lines(1.4, 0xffffff);
  readonly textureLines = new Lines(1.4, 0x16181d, { opacity: 0.85 });
  /** The quads' edges on the surface, and sharp edges that none of them follows. */
  readonly wireframe = new Lines(1.2, 0x23262d, { opacity: 0.85 });
  readonly lostEdges = new Lines(4, 0xd1470a);
  /** Around the chosen chart. */
  readonly outline = new Lines(4, 0x3d8bff);
  readonly chosenContour = new Lines(5, 0xffb454, { hidden: true });
  readonly reebLines = new Lines(4.5, 0x2f7de0, { hidden: true });
  critical: CriticalPoint[] = [];
  contours: Contour[] = [];
  shown: ReadonlySet<LayerId> = new Set(["surface"]);
  private criticalPoints: THREE.Points | null = null;
  private reebNodes: THREE.Points | null = null;
  /** The textures' edges, if they are newer than what is drawn. */
  private textures: Float32Array | null = null;
  private quadFrame: Frame | null = null;
  private wireframeIsStale = false;
  private outlineIsStale = false;
  private readonly criticalMaterial = markerMaterial();
  private readonly nodeMaterial = markerMaterial();

  constructor(readonly viewport: Viewport) {
    const ratio = Math.min(devicePixelRatio, 2);
    this.criticalMaterial.uniforms.size!.value = 20;
    this.criticalMaterial.uniforms.ratio!.value = ratio;
    this.nodeMaterial.uniforms.size!.value = 13;
    this.nodeMaterial.uniforms.ratio!.value = ratio;
    this.nodeMaterial.depthTest = false;
    this.textureLines.object.renderOrder = 1;
    this.wireframe.object.renderOrder = 1;
    this.lostEdges.object.renderOrder = 3;
    this.contourLines.object.renderOrder = 2;
    this.freeLines.object.renderOrder = 2;
    this.reebLines.object.renderOrder = 7;
    this.chosenContour.object.renderOrder = 6;
    this.outline.object.renderOrder = 3;
    viewport.onRender.push(() => {
      this.drawOutline();
      this.surface.update();
      this.quads.update();
    });
    viewport.scene.add(
      this.others.group, this.surface.group, this.quads.group, this.wireframe.object, this.lostEdges.object, this.outline.object, this.textureLines.object, this.contourLines.object, this.freeLines.object, this.chosenContour.object, this.reebLines.object,
    );
  }

  /** Takes a layer of the program. */
  take(frame: Frame): void {
    if (frame.layer === "surface") this.surface.setSurface(frame);
    else if (frame.layer === "cuts") this.surface.setCuts(frame);
    else if (frame.layer === "field") this.surface.setField(frame);
    else if (frame.layer === "charts") {
      this.surface.setCharts(frame);
      this.outlineIsStale = true;
    }
    else if (frame.layer === "contours") this.setContours(frame);
    else if (frame.layer === "critical") this.setCritical(frame);
    else if (frame.layer === "reeb") this.setReeb(frame);
    else if (frame.layer === "textures") this.textures = edgePairs(floats(frame, "position"), indices(frame, "quad"));
    else if (frame.layer === "quads") this.takeQuads(frame);
    else if (frame.layer === "others") this.others.set(frame);
    this.show(this.shown);
  }

  remove(layer: string): void {
    if (layer === "cuts") {
      this.surface.clearDesign();
      this.outlineIsStale = true;
    }
    if (layer === "quads") {
      this.quads.clear();
      this.wireframe.set(new Float32Array());
      this.quadFrame = null;
    }
    if (layer === "others") this.others.clear();
    if (layer === "textures") this.textures = new Float32Array();
    if (layer === "contours") this.clearContours();
    if (layer === "critical") this.removePoints("criticalPoints");
    if (layer === "reeb") {
      this.reebLines.set(new Float32Array());
      this.removePoints("reebNodes");
    }
    this.show(this.shown);
  }

  show(shown: ReadonlySet<LayerId>): void {
    this.shown = shown;
    const on = (layer: LayerId): boolean => shown.has(layer);
    const colour = on("deviation") ? SurfaceColour.deviation : on("charts") ? SurfaceColour.charts : on("field") ? SurfaceColour.field : SurfaceColour.plain;
    this.surface.group.visible = !this.surface.isEmpty && (on("surface") || (this.quads.isEmpty && on("quads")));
    this.surface.setColour(colour, on("isolines") ? 40 : 0);
    const seeThrough = on("xray") || on("reeb"), isDark = document.documentElement.dataset.theme === "dark";
    setGround(isDark);
    this.surface.setXray(seeThrough);
    this.quads.setXray(seeThrough, isDark);
    this.quads.setColour(on("quality") ? "quality" : on("deviation") ? "deviation" : on("charts") ? "charts" : "plain");
    this.quads.show(on("quads"), on("valences"));
    this.contourLines.show(on("contours"));
    this.contourLines.setXray(seeThrough, isDark);
    this.freeLines.show(on("contours") && !(seeThrough && isDark)); // the contours are light there
    this.freeLines.material.depthTest = !seeThrough;
    if (on("textures") && this.textures) {
      this.textureLines.set(this.surface.drape(this.textures));
      this.textures = null;
    }
    this.textureLines.show(on("textures"));
    this.textureLines.setXray(seeThrough, isDark);
    this.textureLines.material.opacity = seeThrough ? 0.5 : 0.85;
    const edges = on("wireframe") && !on("quads");
    if (edges && this.wireframeIsStale && !this.quads.isEmpty) {
      this.wireframe.set(this.surface.drape(edgePairs(this.quads.positions, this.quads.corners)));
      this.wireframeIsStale = false;
    }
    this.wireframe.show(edges);
    this.wireframe.setXray(seeThrough, isDark);
    this.lostEdges.show(on("deviation"));
    this.reebLines.show(on("reeb"));
    if (this.criticalPoints) this.criticalPoints.visible = on("critical");
    this.criticalMaterial.depthTest = !seeThrough;
    if (this.reebNodes) this.reebNodes.visible = on("reeb");
    this.viewport.invalidate();
  }

  /** Distances between surface and quads, and sharp edges that are lost, as pairs of points; nothing is known with empty ones. */
  setDeviation(ofSurface: Float32Array, ofQuads: Float32Array, lostEdges: Float32Array): void {
    this.surface.setDeviation(ofSurface);
    this.quads.setDeviation(ofQuads);
    this.lostEdges.set(lostEdges);
    this.show(this.shown);
  }
  /** The distance that has the last colour. */
  scaleDeviation(top: number): void {
    this.surface.scaleDeviation(top);
    this.quads.scaleDeviation(top);
  }
  setShading(shading: Shading): void {
    this.surface.setShading(shading);
    this.quads.setShading(shading, this.quadFrame);
    this.viewport.invalidate();
  }

  private drawOutline(): void {
    const chart = this.surface.material.uniforms.selected!.value as number;
    if (this.outlineIsStale) this.outline.set(chart < 0 ? new Float32Array() : this.surface.outlineOf(chart));
    this.outlineIsStale = false;
    this.outline.show(chart >= 0 && this.surface.group.visible);
  }

  private takeQuads(frame: Frame): void {
    this.quadFrame = frame;
    this.quads.set(frame);
    this.wireframeIsStale = true;
  }

  setHovered(chart: number): void {
    this.surface.material.uniforms.hovered!.value = chart;
    this.viewport.invalidate();
  }
  setHoveredPart(part: number): void {
    this.others.hover(part);
    this.viewport.invalidate();
  }
  setSelected(chart: number): void {
    this.surface.material.uniforms.selected!.value = chart;
    this.outlineIsStale = true;
    this.viewport.invalidate();
  }

  /** The critical point whose sign is within `pixels` of the pointer. */
  criticalAt(event: { clientX: number; clientY: number }, pixels = 14): CriticalPoint | null {
    let best: CriticalPoint | null = null, nearest = pixels;
    for (const point of this.critical) {
      const at = this.viewport.project(point.position);
      const d = Math.hypot(at.x - event.clientX, at.y - event.clientY);
      if (at.visible && d < nearest && this.isInSight(point.position)) [nearest, best] = [d, point];
    }
    return best;
  }

  /** The contour within `pixels` of the pointer, the nearest to the eye's ray. */
  contourAt(event: { clientX: number; clientY: number }, pixels = 10): Contour | null {
    let best: Contour | null = null, nearest = pixels;
    const box = this.viewport.canvas.getBoundingClientRect();
    for (const contour of this.contours)
      for (const p of contour.points) {
        const at = this.viewport.project(p, box);
        const d = Math.hypot(at.x - event.clientX, at.y - event.clientY);
        if (at.visible && d < nearest && this.isInSight(p)) [nearest, best] = [d, contour];
      }
    return best;
  }

  /** The contours that begin or end at a saddle. */
  contoursAt(saddle: CriticalPoint): Contour[] {
    const isThere = (p: THREE.Vector3): boolean => p.distanceTo(saddle.position) < 1e-6 * this.surface.radius;
    return this.contours.filter(({ points }) => isThere(points[0]!) || isThere(points.at(-1)!));
  }

  /** The saddle at the end of a contour that is the nearest to a point. */
  saddleOf(contour: Contour, near: THREE.Vector3): CriticalPoint | null {
    const ends = this.critical.filter((c) => c.kind === 1 && this.contoursAt(c).includes(contour));
    return ends.sort((a, b) => a.position.distanceToSquared(near) - b.position.distanceToSquared(near))[0] ?? null;
  }

  /** Lets contours shine. */
  choose(chosen: readonly Contour[]): void {
    this.chosenContour.set(pairsOf(chosen));
    this.chosenContour.show(chosen.length > 0);
    this.viewport.invalidate();
  }

  /** Lets the contour under the pointer shine, if it passes. */
  chooseAt(event: { clientX: number; clientY: number }, passes: (contour: Contour) => boolean = () => true): void {
    const contour = this.contourAt(event);
    this.choose(contour && passes(contour) ? [contour] : []);
  }

  private isInSight(point: THREE.Vector3): boolean {
    if (this.shown.has("xray") || this.shown.has("reeb")) return true;
    const eye = this.viewport.camera.position;
    const ray = new THREE.Raycaster(eye, point.clone().sub(eye).normalize());
    const hit = this.surface.pick(ray);
    return !hit || hit.point.distanceTo(eye) > point.distanceTo(eye) - 0.02 * this.surface.radius;
  }

  private setContours(frame: Frame): void {
    const points = floats(frame, "position"), begin = indices(frame, "begin");
    this.contourLines.set(polylinePairs(points, begin));
    const edges = integers(frame, "edge"), counts = integers(frame, "count"), kinds = frame.data.kind as string[];
    this.contours = Array.from(edges, (edge, i) => {
      const line: THREE.Vector3[] = [];
      for (let p = begin[i]!; p < begin[i + 1]!; ++p) line.push(new THREE.Vector3().fromArray(points, 3 * p));
      return { edge, kind: kinds[i] ?? "regular", count: counts[i] ?? 0, points: line };
    });
    this.freeLines.set(pairsOf(this.contours.filter(isFree)));
    this.choose([]);
  }

  private clearContours(): void {
    this.contours = [];
    this.contourLines.set(new Float32Array());
    this.freeLines.set(new Float32Array());
    this.choose([]);
  }

  private setCritical(frame: Frame): void {
    const points = floats(frame, "position") as Float32Array<ArrayBuffer>, kinds = bytesOf(frame, "kind");
    const vertices = integers(frame, "vertex"), multiplicities = bytesOf(frame, "multiplicity");
    this.critical = Array.from(vertices, (vertex, i) => ({
      vertex, kind: kinds[i]!, multiplicity: multiplicities[i]!, position: new THREE.Vector3().fromArray(points, 3 * i),
    }));
    this.removePoints("criticalPoints");
    const shapes = [Shape.triangleDown, Shape.diamond, Shape.triangleUp, Shape.diamond, Shape.diamond];
    this.criticalPoints = markers(
      this.criticalMaterial, points, Array.from(kinds, (k) => criticalColours[k]!), Array.from(kinds, (k) => shapes[k]!),
      Array.from(kinds, (k) => (k === 1 ? 0.85 : k > 2 ? 0.65 : 1.1)),
    );
    this.criticalPoints.renderOrder = 6;
    this.viewport.scene.add(this.criticalPoints);
  }

  private setReeb(frame: Frame): void {
    const points = floats(frame, "position"), begin = indices(frame, "begin");
    this.reebLines.set(polylinePairs(points, begin));
    const nodes = floats(frame, "node") as Float32Array<ArrayBuffer>, extremum = bytesOf(frame, "extremum");
    this.removePoints("reebNodes");
    this.reebNodes = markers(
      this.nodeMaterial, nodes, Array.from(extremum, (e) => (e ? [1, 0.62, 0.2] : [0.95, 0.96, 0.98])),
      Array.from(extremum, () => Shape.disc), Array.from(extremum, (e) => (e ? 1.1 : 0.9)),
    );
    this.reebNodes.renderOrder = 8;
    this.viewport.scene.add(this.reebNodes);
  }

  private removePoints(which: "criticalPoints" | "reebNodes"): void {
    const points = this[which];
    if (!points) return;
    this.viewport.scene.remove(points);
    points.geometry.dispose();
    this[which] = null;
    if (which === "criticalPoints" && !points.visible) this.viewport.invalidate();
  }
}
