// SPDX-License-Identifier: GPL-3.0-or-later
// The surface with the field's colours or the charts', and what the pointer meets on it. An edit changes only how contours cut it:
// the surface itself, its normals and its search tree stay; the faces that are cut are hidden and drawn in pieces.
import * as THREE from "three";
import { MeshBVH, acceleratedRaycast } from "three-mesh-bvh";
import { floats, indices, integers, type Frame } from "../net/frame";
import { SurfaceColour, surfaceMaterial } from "./materials";
import { cornerNormals, type Shading } from "./normals";

export interface Hit {
  point: THREE.Vector3;
  chart: number;
}

const hidden = -2; // the chart of a face that is drawn in pieces

/** How many lines are laid onto the surface, how often one is halved, and how far beside it is too far, of the radius. */
const mostDraped = 40000, mostHalvings = 5, drapeTolerance = 2e-4;

interface Cuts {
  /** Of the vertices on contours, which are numbered after the surface's. */
  position: Float32Array;
  value: Float32Array;
  /** Of each piece: the face of the surface that it lies in, its corners and its chart. */
  base: Uint32Array;
  triangle: Uint32Array;
  chart: Int32Array;
}
const noCuts: Cuts = { position: new Float32Array(), value: new Float32Array(), base: new Uint32Array(), triangle: new Uint32Array(), chart: new Int32Array() };

export class Surface {
  readonly material = surfaceMaterial();
  readonly group = new THREE.Group();
  positions = new Float32Array();
  triangles = new Uint32Array();
  radius = 1;
  private values: Float32Array = new Float32Array();
  private chartOfFace: Int32Array = new Int32Array();
  private readonly mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material);
  private readonly pieces = new THREE.Mesh(new THREE.BufferGeometry(), this.material);
  /** Of each corner of each face. */
  private normals = new Float32Array();
  private shading: Shading = "crease";
  /** The distance of each vertex to the quads, where it was measured, and the end of its scale. */
  private deviation: Float32Array = new Float32Array();
  private deviationTop = 1;
  private cuts = noCuts;
  private piecesOf = new Map<number, number[]>();
  private stale = false;
  private picking: THREE.Mesh | null = null;
  private smoothNormals: Float32Array | null = null;

  constructor() {
    this.mesh.frustumCulled = this.pieces.frustumCulled = false;
    this.group.add(this.mesh, this.pieces);
  }

  get isEmpty(): boolean {
    return this.triangles.length === 0;
  }
  get hasField(): boolean {
    return this.values.length > 0;
  }

  /** Corners are not shared between triangles, so that a triangle has one colour. */
  setSurface(frame: Frame): void {
    this.positions = floats(frame, "position") as Float32Array<ArrayBuffer>;
    this.triangles = indices(frame, "triangle") as Uint32Array<ArrayBuffer>;
    this.picking = this.smoothNormals = null;
    this.normals = cornerNormals(this.positions, this.triangles, this.shading);
    this.deviation = new Float32Array();
    const geometry = new THREE.BufferGeometry(), corners = this.triangles.length;
    geometry.setAttribute("position", new THREE.BufferAttribute(spread(this.positions, this.triangles, 3), 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(this.normals, 3));
    geometry.setAttribute("field", new THREE.BufferAttribute(new Float32Array(corners), 1));
    geometry.setAttribute("chart", new THREE.BufferAttribute(new Float32Array(corners), 1));
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
    this.radius = ballOf(this.positions).radius;
    this.clearDesign();
  }

  clearDesign(): void {
    this.values = new Float32Array();
    this.chartOfFace = new Int32Array();
    this.cut(noCuts);
  }

  setCuts(frame: Frame): void {
    this.cut({
      position: floats(frame, "position"), value: floats(frame, "value"), base: indices(frame, "base"), triangle: indices(frame, "triangle"), chart: integers(frame, "chart"),
    });
  }

  setField(frame: Frame): void {
    this.values = floats(frame, "value");
    this.stale = true;
  }

  setCharts(frame: Frame): void {
    this.chartOfFace = integers(frame, "chart");
    this.stale = true;
  }

  /** Brings what is drawn up to date; called before a picture. */
  update(): void {
    if (!this.stale) return;
    this.stale = false;
    const charts = this.mesh.geometry.getAttribute("chart") as THREE.BufferAttribute | undefined;
    if (!charts) return;
    const faces = this.triangles.length / 3;
    const ofFace = this.chartOfFace.length === faces ? new Float32Array(this.chartOfFace) : new Float32Array(faces).fill(-1);
    for (const f of this.cuts.base) ofFace[f] = hidden;
    assign(charts, (corner) => ofFace[(corner / 3) | 0]!);
    const { triangles } = this;
    if (this.showsDeviation) {
      const { deviation } = this;
      assign(this.mesh.geometry.getAttribute("field") as THREE.BufferAttribute, (corner) => deviation[triangles[corner]!]!);
      this.material.uniforms.lowest!.value = 0;
      this.material.uniforms.highest!.value = this.deviationTop;
    } else if (this.hasField) {
      const { values } = this;
      assign(this.mesh.geometry.getAttribute("field") as THREE.BufferAttribute, (corner) => values[triangles[corner]!]!);
      const [low, high] = rangeOf(this.values, this.cuts.value);
      this.material.uniforms.lowest!.value = low;
      this.material.uniforms.highest!.value = high;
    }
    this.makePieces();
  }

  setColour(mode: SurfaceColour, isolines: number): void {
    const { mode: before, isolines: lines } = this.material.uniforms, hasColour = mode === SurfaceColour.deviation ? this.deviation.length > 0 : this.hasField;
    const now = hasColour ? mode : SurfaceColour.plain;
    if ((before!.value === SurfaceColour.deviation) !== (now === SurfaceColour.deviation)) this.stale = true;
    before!.value = now;
    lines!.value = this.hasField && now !== SurfaceColour.deviation ? isolines : 0;
  }

  /** Distances of the vertices to the quads; none if they are not known any more. */
  setDeviation(distances: Float32Array): void {
    this.deviation = distances.length === this.positions.length / 3 ? distances : new Float32Array();
    this.stale = true;
  }
  scaleDeviation(top: number): void {
    this.deviationTop = top;
    this.stale = true;
  }

  setShading(shading: Shading): void {
    if (this.shading === shading) return;
    this.shading = shading;
    if (this.isEmpty) return;
    this.normals = cornerNormals(this.positions, this.triangles, shading);
    this.mesh.geometry.setAttribute("normal", new THREE.BufferAttribute(this.normals, 3));
    this.stale = true;
  }

  private get showsDeviation(): boolean {
    return this.material.uniforms.mode!.value === SurfaceColour.deviation;
  }

  setXray(on: boolean): void {
    if (this.material.transparent === on) return;
    this.material.uniforms.opacity!.value = on ? 0.16 : 1;
    this.material.forceSinglePass = !on; // else the front and what is behind it would show in patches: faces are not sorted by depth
    this.material.transparent = on;
    this.material.depthWrite = !on;
    this.material.needsUpdate = true;
  }

  /** What the ray meets first. */
  pick(ray: THREE.Raycaster): Hit | null {
    if (this.isEmpty) return null;
    ray.firstHitOnly = true;
    const [hit] = ray.intersectObject(this.picker(), false);
    if (!hit || hit.faceIndex == null) return null;
    return { point: hit.point.clone(), chart: this.chartAt(hit.faceIndex, hit.point) };
  }

  /** A vertex of the surface, or one on a contour. */
  vertex(v: number): THREE.Vector3 {
    const { length } = this.positions;
    return 3 * v < length ? new THREE.Vector3().fromArray(this.positions, 3 * v) : new THREE.Vector3().fromArray(this.cuts.position, 3 * v - length);
  }

  /** A vertex well inside a chart: with only faces of it around, the middle one of these by the field's value. */
  insideOf(chart: number): THREE.Vector3 | null {
    const owner = new Int8Array(this.positions.length / 3); // 0 no face of it, 1 only such faces, 2 also others
    const claim = (triangles: Uint32Array, face: number, inside: boolean): void => {
      for (let i = 3 * face; i < 3 * face + 3; ++i) {
        const v = triangles[i]!;
        if (v >= owner.length) continue; // on a contour
        if (!inside) owner[v] = 2;
        else if (owner[v] === 0) owner[v] = 1;
      }
    };
    for (let f = 0; f < this.chartOfFace.length; ++f) claim(this.triangles, f, this.chartOfFace[f] === chart);
    this.cuts.chart.forEach((other, piece) => claim(this.cuts.triangle, piece, other === chart));
    const inner: number[] = [];
    owner.forEach((kind, v) => kind === 1 && inner.push(v));
    if (inner.length === 0) return null;
    inner.sort((a, b) => this.values[a]! - this.values[b]! || a - b);
    return this.vertex(inner[inner.length >> 1]!);
  }

  /** The corners of all faces of a chart. */
  pointsOf(chart: number): Float32Array {
    const out: number[] = [];
    this.eachTriangleOf(chart, (corners) => corners.forEach((v) => this.vertex(v).toArray(out, out.length)));
    return new Float32Array(out);
  }

  /** The border of a chart, as pairs of points: the edges that one of its triangles has alone. */
  outlineOf(chart: number): Float32Array {
    const all = this.positions.length / 3 + this.cuts.position.length / 3, alone = new Map<number, [number, number]>();
    this.eachTriangleOf(chart, (corners) => {
      for (let k = 0; k < 3; ++k) {
        const a = corners[k]!, b = corners[(k + 1) % 3]!, key = Math.min(a, b) * all + Math.max(a, b);
        if (!alone.delete(key)) alone.set(key, [a, b]);
      }
    });
    const out: number[] = [];
    for (const ends of alone.values()) for (const v of ends) this.vertex(v).toArray(out, out.length);
    return new Float32Array(out);
  }

  private eachTriangleOf(chart: number, visit: (corners: Uint32Array) => void): void {
    this.chartOfFace.forEach((other, f) => other === chart && !this.piecesOf.has(f) && visit(this.triangles.subarray(3 * f, 3 * f + 3)));
    this.cuts.chart.forEach((other, piece) => other === chart && visit(this.cuts.triangle.subarray(3 * piece, 3 * piece + 3)));
  }

  /** The segments in which a plane meets the surface, as pairs of points. */
  intersection(plane: THREE.Plane): Float32Array {
    const out: number[] = [];
    const corners = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()] as const;
    const sides: [number, number, number] = [0, 0, 0];
    (this.picker().geometry.boundsTree as MeshBVH | undefined)?.shapecast({
      intersectsBounds: (box) => plane.intersectsBox(box),
      intersectsTriangle: (triangle) => {
        corners[0].copy(triangle.a);
        corners[1].copy(triangle.b);
        corners[2].copy(triangle.c);
        for (let i = 0; i < 3; ++i) sides[i] = plane.distanceToPoint(corners[i]!);
        const points: THREE.Vector3[] = [];
        for (let i = 0; i < 3; ++i) {
          const a = sides[i]!, b = sides[(i + 1) % 3]!;
          if (a < 0 !== b < 0) points.push(corners[i]!.clone().lerp(corners[(i + 1) % 3]!, a / (a - b)));
        }
        if (points.length === 2) out.push(...points[0]!.toArray(), ...points[1]!.toArray());
        return false;
      },
    });
    return new Float32Array(out);
  }

  /** Segments between points of the surface, made to lie on it: halved where the middle is beside it, where there are few enough for that to be quick. */
  drape(pairs: Float32Array): Float32Array {
    if (this.isEmpty || pairs.length / 6 > mostDraped) return pairs;
    const tree = this.picker().geometry.boundsTree as MeshBVH, tolerance = drapeTolerance * this.radius;
    const out: number[] = [], found = { point: new THREE.Vector3(), distance: 0, faceIndex: 0 };
    const lay = (a: THREE.Vector3, b: THREE.Vector3, halvings: number): void => {
      const middle = a.clone().lerp(b, 0.5);
      if (halvings === 0 || !tree.closestPointToPoint(middle, found) || found.distance < tolerance) return void out.push(a.x, a.y, a.z, b.x, b.y, b.z);
      middle.copy(found.point);
      lay(a, middle, halvings - 1);
      lay(middle, b, halvings - 1);
    };
    for (let i = 0; i < pairs.length; i += 6) lay(new THREE.Vector3().fromArray(pairs, i), new THREE.Vector3().fromArray(pairs, i + 3), mostHalvings);
    return new Float32Array(out);
  }

  /** The normal where the surface is nearest to a point. */
  normalAt(point: THREE.Vector3): THREE.Vector3 | undefined {
    const tree = this.isEmpty ? undefined : (this.picker().geometry.boundsTree as MeshBVH);
    const found = tree?.closestPointToPoint(point);
    return found ? this.normalIn(found.faceIndex, found.point, new THREE.Vector3()).normalize() : undefined;
  }

  /** The vertex nearest to a point of the surface, of the face that the point lies in, and its normal. */
  vertexNear(point: THREE.Vector3): { point: THREE.Vector3; normal: THREE.Vector3 } | null {
    const found = this.isEmpty ? null : (this.picker().geometry.boundsTree as MeshBVH).closestPointToPoint(point);
    if (!found) return null;
    const corners = Array.from(this.triangles.subarray(3 * found.faceIndex, 3 * found.faceIndex + 3));
    const [nearest] = corners.sort((a, b) => this.vertex(a).distanceToSquared(point) - this.vertex(b).distanceToSquared(point)) as [number];
    this.smoothNormals ??= vertexNormals(this.positions, this.triangles);
    return { point: this.vertex(nearest), normal: new THREE.Vector3().fromArray(this.smoothNormals, 3 * nearest) };
  }

  /** The search tree takes a while on large surfaces: called when there is time. */
  prepare(): void {
    if (!this.isEmpty) this.picker();
  }

  private cut(cuts: Cuts): void {
    this.cuts = cuts;
    this.piecesOf = new Map();
    cuts.base.forEach((base, piece) => {
      const pieces = this.piecesOf.get(base);
      if (pieces) pieces.push(piece);
      else this.piecesOf.set(base, [piece]);
    });
    this.stale = true;
  }

  // A vertex on a contour has the normal that the surface's shading has there.
  private makePieces(): void {
    const { triangle, base, chart, value } = this.cuts, vertices = this.positions.length / 3;
    const positions = new Float32Array(3 * triangle.length), normals = new Float32Array(3 * triangle.length);
    const fields = new Float32Array(triangle.length), charts = new Float32Array(triangle.length), normal = new THREE.Vector3();
    triangle.forEach((v, corner) => {
      const piece = Math.floor(corner / 3), point = this.vertex(v);
      const own = v < vertices ? this.cornerOf(base[piece]!, v) : -1;
      if (own >= 0) normal.fromArray(this.normals, 3 * own);
      else this.normalIn(base[piece]!, point, normal);
      point.toArray(positions, 3 * corner);
      normal.toArray(normals, 3 * corner);
      fields[corner] = (this.showsDeviation ? this.deviationIn(base[piece]!, point) : v < vertices ? this.values[v] : value[v - vertices]) ?? 0;
      charts[corner] = chart[piece]!;
    });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(normals, 3));
    geometry.setAttribute("field", new THREE.BufferAttribute(fields, 1));
    geometry.setAttribute("chart", new THREE.BufferAttribute(charts, 1));
    this.pieces.geometry.dispose();
    this.pieces.geometry = geometry;
    this.pieces.visible = triangle.length > 0;
  }

  private normalIn(baseFace: number, point: THREE.Vector3, normal: THREE.Vector3): THREE.Vector3 {
    const at = this.weightsIn(baseFace, point);
    normal.set(0, 0, 0);
    for (let k = 0; k < 3; ++k) normal.addScaledVector(new THREE.Vector3().fromArray(this.normals, 3 * (3 * baseFace + k)), at.getComponent(k));
    return normal;
  }

  private deviationIn(baseFace: number, point: THREE.Vector3): number {
    const at = this.weightsIn(baseFace, point);
    return [0, 1, 2].reduce((sum, k) => sum + at.getComponent(k) * (this.deviation[this.triangles[3 * baseFace + k]!] ?? 0), 0);
  }

  private weightsIn(baseFace: number, point: THREE.Vector3): THREE.Vector3 {
    const [a, b, c] = [0, 1, 2].map((k) => this.vertex(this.triangles[3 * baseFace + k]!)) as [THREE.Vector3, THREE.Vector3, THREE.Vector3];
    return THREE.Triangle.getBarycoord(point, a, b, c, new THREE.Vector3()) ?? new THREE.Vector3(1, 0, 0);
  }

  /** The corner of a face at one of its vertices, or -1. */
  private cornerOf(face: number, vertex: number): number {
    for (let c = 3 * face; c < 3 * face + 3; ++c) if (this.triangles[c] === vertex) return c;
    return -1;
  }

  /** The chart of a face at one of its points; where contours cross the face, that of the piece there. */
  private chartAt(face: number, point: THREE.Vector3): number {
    let chart = this.chartOfFace[face] ?? -1, most = -Infinity;
    for (const piece of this.piecesOf.get(face) ?? []) {
      const [a, b, c] = [0, 1, 2].map((k) => this.vertex(this.cuts.triangle[3 * piece + k]!)) as [THREE.Vector3, THREE.Vector3, THREE.Vector3];
      const at = THREE.Triangle.getBarycoord(point, a, b, c, new THREE.Vector3());
      const least = at ? Math.min(at.x, at.y, at.z) : -Infinity;
      if (least > most) [most, chart] = [least, this.cuts.chart[piece]!];
    }
    return chart;
  }

  // Built when it is first needed.
  private picker(): THREE.Mesh {
    if (this.picking) return this.picking;
    this.picking = searchMesh(this.positions, this.triangles);
    return this.picking;
  }
}

/** A mesh with a search tree for rays, which is not drawn. */
export function searchMesh(positions: Float32Array, triangles: Uint32Array): THREE.Mesh {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
  // `indirect` keeps the order of the faces.
  geometry.boundsTree = new MeshBVH(geometry, { indirect: true });
  const mesh = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
  mesh.raycast = acceleratedRaycast;
  return mesh;
}

/** Sets all numbers of an attribute; what is between the first and the last that changed is sent to the graphics processor. */
function assign(attribute: THREE.BufferAttribute, value: (index: number) => number): void {
  const array = attribute.array as Float32Array;
  let first = -1, last = -1;
  for (let i = 0; i < array.length; ++i) {
    const now = value(i);
    if (array[i] === now) continue;
    array[i] = now;
    if (first < 0) first = i;
    last = i;
  }
  if (first < 0) return;
  attribute.addUpdateRange(first, last - first + 1);
  attribute.needsUpdate = true;
}

function rangeOf(...arrays: Float32Array[]): [number, number] {
  let low = Infinity, high = -Infinity;
  for (const values of arrays)
    for (let i = 0; i < values.length; ++i) {
      const value = values[i]!;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  return [low, high];
}

function spreadInto(out: Float32Array, values: Float32Array, index: Uint32Array, size: number): void {
  for (let i = 0; i < index.length; ++i)
    for (let k = 0; k < size; ++k) out[size * i + k] = values[size * index[i]! + k]!;
}

function spread(values: Float32Array, index: Uint32Array, size: number): Float32Array<ArrayBuffer> {
  const out = new Float32Array(size * index.length);
  spreadInto(out, values, index, size);
  return out;
}

/** The middle of the points' box, and the greatest distance of a point (x, y, z) from there. */
export function ballOf(points: Float32Array): { centre: THREE.Vector3; radius: number } {
  const box = new THREE.Box3().setFromArray(points);
  const centre = box.isEmpty() ? new THREE.Vector3() : box.getCenter(new THREE.Vector3()), p = new THREE.Vector3();
  let square = 0;
  for (let i = 0; i < points.length; i += 3) square = Math.max(square, p.fromArray(points, i).distanceToSquared(centre));
  return { centre, radius: Math.sqrt(square) || 1 };
}

/** The sum of the normals of the faces around each vertex, weighted by area. */
export function vertexNormals(p: Float32Array, triangles: Uint32Array): Float32Array<ArrayBuffer> {
  const normals = new Float32Array(p.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t]!, b = 3 * triangles[t + 1]!, c = 3 * triangles[t + 2]!;
    const ux = p[b]! - p[a]!, uy = p[b + 1]! - p[a + 1]!, uz = p[b + 2]! - p[a + 2]!;
    const vx = p[c]! - p[a]!, vy = p[c + 1]! - p[a + 1]!, vz = p[c + 2]! - p[a + 2]!;
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    for (const v of [a, b, c]) {
      normals[v] = normals[v]! + x;
      normals[v + 1] = normals[v + 1]! + y;
      normals[v + 2] = normals[v + 2]! + z;
    }
  }
  // Unit length, so that what is between two vertices is not ruled by the larger faces.
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i]!, normals[i + 1]!, normals[i + 2]!) || 1;
    for (let k = i; k < i + 3; ++k) normals[k] = normals[k]! / length;
  }
  return normals;
}
