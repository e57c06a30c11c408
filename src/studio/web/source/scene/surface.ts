// SPDX-License-Identifier: GPL-3.0-or-later
// The input surface with the field's colours or the charts', and what the pointer meets on it.
import * as THREE from "three";
import { MeshBVH, acceleratedRaycast } from "three-mesh-bvh";
import { floats, indices, integers, type Frame } from "../net/frame";
import { chartColour } from "./colours";
import { SurfaceColour, surfaceMaterial } from "./materials";

export interface Hit {
  point: THREE.Vector3;
  face: number;
  /** The nearest vertex of that face. */
  vertex: number;
  chart: number;
  normal: THREE.Vector3;
}

export class Surface {
  readonly material = surfaceMaterial();
  readonly mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material);
  positions = new Float32Array();
  triangles = new Uint32Array();
  values = new Float32Array();
  chartOfFace = new Int32Array();
  radius = 1;
  private picking: THREE.Mesh | null = null;

  constructor() {
    this.mesh.frustumCulled = false;
  }

  get isEmpty(): boolean {
    return this.triangles.length === 0;
  }
  get hasField(): boolean {
    return this.values.length > 0;
  }
  get bvh(): MeshBVH | undefined {
    return this.picker().geometry.boundsTree as MeshBVH | undefined;
  }

  /** Corners are not shared between triangles, so that a triangle has one colour. */
  setSurface(frame: Frame): void {
    this.positions = floats(frame, "position") as Float32Array<ArrayBuffer>;
    this.triangles = indices(frame, "triangle") as Uint32Array<ArrayBuffer>;
    this.values = new Float32Array();
    this.chartOfFace = new Int32Array();
    this.picking = null;
    const normals = vertexNormals(this.positions, this.triangles);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(spread(this.positions, this.triangles, 3), 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(spread(normals, this.triangles, 3), 3));
    let square = 0;
    for (let i = 0; i < this.positions.length; i += 3)
      square = Math.max(square, this.positions[i]! ** 2 + this.positions[i + 1]! ** 2 + this.positions[i + 2]! ** 2);
    this.radius = Math.sqrt(square) || 1;
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
  }

  setField(frame: Frame): void {
    this.values = floats(frame, "value") as Float32Array<ArrayBuffer>;
    this.mesh.geometry.setAttribute("field", new THREE.BufferAttribute(spread(this.values, this.triangles, 1), 1));
    let low = Infinity, high = -Infinity;
    for (const value of this.values) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    this.material.uniforms.lowest!.value = low;
    this.material.uniforms.highest!.value = high;
  }

  setCharts(frame: Frame): void {
    this.chartOfFace = integers(frame, "chart") as Int32Array<ArrayBuffer>;
    const colours = new Uint8Array(3 * this.triangles.length), charts = new Float32Array(this.triangles.length);
    for (let f = 0; f < this.chartOfFace.length; ++f) {
      const chart = this.chartOfFace[f]!, colour = chartColour(chart);
      for (let corner = 3 * f; corner < 3 * f + 3; ++corner) {
        charts[corner] = chart;
        for (let i = 0; i < 3; ++i) colours[3 * corner + i] = 255 * colour[i]!;
      }
    }
    this.mesh.geometry.setAttribute("chartColour", new THREE.BufferAttribute(colours, 3, true));
    this.mesh.geometry.setAttribute("chart", new THREE.BufferAttribute(charts, 1));
  }

  setColour(mode: SurfaceColour, isolines: number): void {
    this.material.uniforms.mode!.value = this.hasField ? mode : SurfaceColour.plain;
    this.material.uniforms.isolines!.value = this.hasField ? isolines : 0;
  }

  setXray(on: boolean): void {
    this.material.uniforms.opacity!.value = on ? 0.16 : 1;
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
    const face = hit.faceIndex;
    let vertex = -1, nearest = Infinity;
    for (let i = 0; i < 3; ++i) {
      const v = this.triangles[3 * face + i]!;
      const d = this.vertex(v).distanceToSquared(hit.point);
      if (d < nearest) [nearest, vertex] = [d, v];
    }
    return {
      point: hit.point.clone(), face, vertex, chart: this.chartOfFace[face] ?? -1, normal: hit.face?.normal.clone() ?? new THREE.Vector3(0, 0, 1),
    };
  }

  vertex(v: number): THREE.Vector3 {
    return new THREE.Vector3().fromArray(this.positions, 3 * v);
  }

  /** A vertex well inside a chart: with only faces of it around, the middle one of these by the field's value. */
  insideOf(chart: number): THREE.Vector3 | null {
    const owner = new Int8Array(this.positions.length / 3); // 0 no face of it, 1 only such faces, 2 also others
    for (let f = 0; f < this.chartOfFace.length; ++f) {
      const inside = this.chartOfFace[f] === chart;
      for (let i = 3 * f; i < 3 * f + 3; ++i) {
        const v = this.triangles[i]!;
        if (!inside) owner[v] = 2;
        else if (owner[v] === 0) owner[v] = 1;
      }
    }
    const inner: number[] = [];
    owner.forEach((kind, v) => kind === 1 && inner.push(v));
    if (inner.length === 0) return null;
    inner.sort((a, b) => this.values[a]! - this.values[b]! || a - b);
    return this.vertex(inner[inner.length >> 1]!);
  }

  /** The segments in which a plane meets the surface, as pairs of points. */
  cut(plane: THREE.Plane): Float32Array {
    const out: number[] = [];
    const corners = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()] as const;
    const sides: [number, number, number] = [0, 0, 0];
    this.bvh?.shapecast({
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

  // Built when it is first needed: it takes a while on large surfaces.
  private picker(): THREE.Mesh {
    if (this.picking) return this.picking;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(this.positions, 3));
    geometry.setIndex(new THREE.BufferAttribute(this.triangles, 1));
    // `indirect` keeps the order of the faces.
    geometry.boundsTree = new MeshBVH(geometry, { indirect: true });
    this.picking = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
    this.picking.raycast = acceleratedRaycast;
    return this.picking;
  }
}

function spread(values: Float32Array, index: Uint32Array, size: number): Float32Array {
  const out = new Float32Array(size * index.length);
  for (let i = 0; i < index.length; ++i)
    for (let k = 0; k < size; ++k) out[size * i + k] = values[size * index[i]! + k]!;
  return out;
}

/** The sum of the normals of the faces around each vertex, weighted by area. */
export function vertexNormals(p: Float32Array, triangles: Uint32Array): Float32Array {
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
  return normals;
}
