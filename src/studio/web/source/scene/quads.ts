// SPDX-License-Identifier: GPL-3.0-or-later
// The quad mesh: faces, edges, and markers at the vertices whose valence is not regular.
import * as THREE from "three";
import { bytesOf, floats, indices, integers, type Frame } from "../net/frame";
import { chartColour, deviationColour, qualityColour, valenceColour, type Rgb } from "./colours";
import { Lines, markers } from "./lines";
import { markerMaterial, quadMaterial } from "./materials";
import { cornerNormals, type Shading } from "./normals";

/** Quads that shine are seen through the others if they are fewer than one in so many. */
const fewOf = 10;

export type QuadColour = "plain" | "quality" | "charts" | "deviation";

export class Quads {
  readonly group = new THREE.Group();
  readonly edges = new Lines(1.1, 0x23262d, { opacity: 0.8 });
  /** Of the few quads that shine, wherever they are. */
  readonly litEdges = new Lines(2, 0xffa726, { hidden: true });
  readonly faces = new THREE.Mesh(new THREE.BufferGeometry(), quadMaterial());
  positions = new Float32Array();
  corners = new Uint32Array();
  quality = new Float32Array();
  private charts = new Int32Array();
  private irregular: THREE.Points | null = null;
  private readonly markerMaterial = markerMaterial();
  private lit: ((quality: number) => boolean) | null = null;
  private colour: QuadColour = "plain";
  private shading: Shading = "crease";
  /** Of each quad, where it was measured, and the end of the scale. */
  private deviation: Float32Array = new Float32Array();
  private deviationTop = 1;
  private showsFaces = false;
  private showsValences = false;
  private isPainted = false;
  /** The layer, if it is newer than what is drawn. */
  private fresh: Frame | null = null;
  plain: Rgb = [0.88, 0.86, 0.82];

  constructor() {
    this.faces.frustumCulled = false;
    this.edges.object.renderOrder = 1;
    this.litEdges.object.renderOrder = 4;
    this.markerMaterial.uniforms.size!.value = 15;
    this.markerMaterial.uniforms.ratio!.value = Math.min(devicePixelRatio, 2);
    this.group.add(this.faces, this.edges.object, this.litEdges.object);
  }

  private get shows(): boolean {
    return this.showsFaces || this.showsValences;
  }
  get isEmpty(): boolean {
    return this.corners.length === 0;
  }

  clear(): void {
    this.corners = new Uint32Array();
    this.show(false, false);
  }

  set(frame: Frame): void {
    this.positions = floats(frame, "position") as Float32Array<ArrayBuffer>;
    this.corners = indices(frame, "quad") as Uint32Array<ArrayBuffer>;
    this.quality = floats(frame, "quality") as Float32Array<ArrayBuffer>;
    this.charts = integers(frame, "chart") as Int32Array<ArrayBuffer>;
    this.fresh = frame;
  }

  /** Brings what is drawn up to date, if it is seen; called before a picture. */
  update(): void {
    if (!this.shows || this.isEmpty) return;
    if (this.fresh) {
      const frame = this.fresh;
      this.fresh = null;
      this.makeFaces();
      this.edges.set(edgePairs(this.positions, this.corners));
      this.makeMarkers(indices(frame, "irregular_vertex"), bytesOf(frame, "irregular_valence"), bytesOf(frame, "irregular_on_boundary"));
      this.isPainted = false;
      this.show(this.showsFaces, this.showsValences);
    }
    if (!this.isPainted) this.paint();
  }

  setColour(colour: QuadColour): void {
    if (this.colour !== colour) this.isPainted = false;
    this.colour = colour;
  }

  /** Distances of the quads to the surface; none if they are not known any more. */
  setDeviation(distances: Float32Array): void {
    this.deviation = distances;
    this.isPainted = false;
  }
  scaleDeviation(top: number): void {
    this.deviationTop = top;
    this.isPainted = false;
  }

  setShading(shading: Shading, frame: Frame | null): void {
    if (this.shading === shading) return;
    this.shading = shading;
    this.fresh ??= frame;
  }

  /** Lets only the quads shine whose quality passes; null: all. */
  light(lit: ((quality: number) => boolean) | null): void {
    this.lit = lit;
    this.isPainted = false;
    const shining: number[] = [];
    if (lit) this.quality.forEach((quality, q) => lit(quality) && shining.push(q));
    const isFew = shining.length * fewOf < this.quality.length;
    this.litEdges.set(isFew ? edgePairs(this.positions, new Uint32Array(shining.flatMap((q) => [...this.corners.subarray(4 * q, 4 * q + 4)]))) : new Float32Array());
    this.show(this.showsFaces, this.showsValences);
  }

  show(faces: boolean, valences: boolean): void {
    [this.showsFaces, this.showsValences] = [faces, valences];
    this.faces.visible = faces && !this.isEmpty;
    this.edges.show(faces && !this.isEmpty);
    this.litEdges.show(faces && !this.isEmpty);
    if (this.irregular) this.irregular.visible = valences && !this.isEmpty;
  }

  setXray(on: boolean, isDark: boolean): void {
    this.edges.setXray(on, isDark);
    this.edges.material.opacity = on ? 0.4 : 0.8;
    const material = this.faces.material;
    if (material.transparent === on) return;
    material.uniforms.opacity!.value = on ? 0.12 : 1;
    material.forceSinglePass = !on;
    material.transparent = on;
    material.depthWrite = !on;
    material.needsUpdate = true;
    this.markerMaterial.depthTest = !on;
  }

  private makeFaces(): void {
    const number = this.corners.length / 4;
    const triangles = new Uint32Array(6 * number);
    for (let q = 0; q < number; ++q) [0, 1, 2, 0, 2, 3].forEach((c, i) => (triangles[6 * q + i] = this.corners[4 * q + c]!));
    const normals = cornerNormals(this.positions, triangles, this.shading), positions = new Float32Array(18 * number);
    for (let i = 0; i < triangles.length; ++i) for (let k = 0; k < 3; ++k) positions[3 * i + k] = this.positions[3 * triangles[i]! + k]!;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(normals, 3));
    geometry.setAttribute("colour", new THREE.BufferAttribute(new Uint8Array(18 * number), 3, true));
    this.faces.geometry.dispose();
    this.faces.geometry = geometry;
  }

  private makeMarkers(vertices: Uint32Array, valences: Uint8Array, onBoundary: Uint8Array): void {
    if (this.irregular) {
      this.group.remove(this.irregular);
      this.irregular.geometry.dispose();
    }
    const points = new Float32Array(3 * vertices.length), colours: Rgb[] = [], shapes: number[] = [], scales: number[] = [];
    vertices.forEach((v, i) => {
      for (let k = 0; k < 3; ++k) points[3 * i + k] = this.positions[3 * v + k]!;
      colours.push(valenceColour(valences[i]!, onBoundary[i]! > 0));
      shapes.push(Math.min(Math.max(valences[i]!, 3), 12)); // as many corners as edges
      scales.push(valences[i]! >= 6 || valences[i]! === 2 ? 1.25 : 1);
    });
    this.irregular = markers(this.markerMaterial, points, colours, shapes, scales);
    this.irregular.renderOrder = 5;
    this.group.add(this.irregular);
  }

  private paint(): void {
    this.isPainted = true;
    const attribute = this.faces.geometry.getAttribute("colour") as THREE.BufferAttribute | undefined;
    if (!attribute) return;
    for (let q = 0; q < this.quality.length; ++q) {
      const colour = this.colourOf(q);
      for (let corner = 6 * q; corner < 6 * q + 6; ++corner) attribute.setXYZ(corner, colour[0], colour[1], colour[2]);
    }
    attribute.needsUpdate = true;
  }

  private colourOf(q: number): Rgb {
    const quality = this.quality[q]!;
    if (this.lit) return this.lit(quality) ? [1, 0.62, 0.15] : [0.45, 0.46, 0.48];
    if (this.colour === "quality" && !Number.isNaN(quality)) return qualityColour(quality); // a fan's triangles have none
    if (this.colour === "deviation" && this.deviation.length === this.quality.length) return deviationColour(this.deviation[q]! / this.deviationTop);
    if (this.colour === "charts") return chartColour(this.charts[q] ?? -1);
    return this.plain;
  }
}

/** The ends of the quads' edges, each edge once. */
export function edgePairs(positions: Float32Array, corners: Uint32Array): Float32Array {
  const points = positions.length / 3;
  const seen = new Set<number>(), pairs: number[] = [];
  for (let q = 0; q < corners.length; q += 4)
    for (let i = 0; i < 4; ++i) {
      const a = corners[q + i]!, b = corners[q + ((i + 1) % 4)]!;
      if (a === b) continue; // a triangle
      const key = Math.min(a, b) * points + Math.max(a, b);
      if (seen.has(key)) continue;
      seen.add(key);
      for (const v of [a, b]) for (let k = 0; k < 3; ++k) pairs.push(positions[3 * v + k]!);
    }
  return new Float32Array(pairs);
}
