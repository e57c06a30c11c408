// SPDX-License-Identifier: GPL-3.0-or-later
// A chart's texture: quads in the plane and on the surface, and what a point of either means.
import * as THREE from "three";
import { bytesOf, floats, indices, type Frame } from "../net/frame";

export type PlanePoint = [number, number];
export type PlaceKind = "quad" | "edge" | "corner";

/** A quad, the edge that begins at one of its corners, or that corner. */
export interface Place {
  kind: PlaceKind;
  quad: number;
  corner: number;
}

export class Texture {
  readonly id: number;
  readonly kind: "annulus" | "disc";
  readonly width: number;
  readonly height: number;
  readonly quads: Uint32Array;
  readonly holes: Uint8Array;
  /** Across and up, in the plane: V and U. */
  private readonly plane: Float32Array;
  private readonly space: Float32Array;
  private readonly names: Record<PlaceKind, Float32Array>;

  constructor(frame: Frame) {
    const data = frame.data as { id: number; kind: "annulus" | "disc"; width: number; height: number };
    [this.id, this.kind, this.width, this.height] = [data.id, data.kind, data.width, data.height];
    this.quads = indices(frame, "quad");
    this.holes = bytesOf(frame, "hole");
    this.plane = floats(frame, "plane");
    this.space = floats(frame, "position");
    this.names = { quad: floats(frame, "quad_point"), edge: floats(frame, "edge_point"), corner: floats(frame, "corner_point") };
  }

  /** How much longer a unit of U is on the surface than one of V. */
  get proportion(): number {
    const along = { plane: 0, space: 0 }, up = { plane: 0, space: 0 }; // of the edges that run along V, and along U
    for (let q = 0; q < this.size; ++q) {
      const flat = this.corners(q), space = this.cornersInSpace(q);
      for (let c = 0; c < 4; ++c) {
        const d = (c + 1) % 4, [dv, du] = [Math.abs(flat[c]![0] - flat[d]![0]), Math.abs(flat[c]![1] - flat[d]![1])];
        const sum = dv > du ? along : up;
        sum.plane += Math.max(dv, du);
        sum.space += space[c]!.distanceTo(space[d]!);
      }
    }
    const ratio = (up.space / up.plane) * (along.plane / along.space);
    return Number.isFinite(ratio) && ratio > 0 ? ratio : 1;
  }

  get size(): number {
    return this.quads.length / 4;
  }

  /** The point on the surface by which edits name a place. */
  name(place: Place): THREE.Vector3 {
    return new THREE.Vector3().fromArray(this.names[place.kind], 3 * (place.kind === "quad" ? place.quad : 4 * place.quad + place.corner));
  }

  vertexOf(place: Place): number {
    return this.quads[4 * place.quad + place.corner]!;
  }

  inSpace(vertex: number): THREE.Vector3 {
    return new THREE.Vector3().fromArray(this.space, 3 * vertex);
  }

  /** The corners of a quad on the surface. */
  cornersInSpace(quad: number): THREE.Vector3[] {
    return [0, 1, 2, 3].map((c) => this.inSpace(this.quads[4 * quad + c]!));
  }

  /** A quad's corners in the plane. On a tube a quad may step over the seam: its corners are brought to one side. */
  corners(quad: number): PlanePoint[] {
    const corners: PlanePoint[] = [];
    for (let i = 0; i < 4; ++i) {
      const v = this.quads[4 * quad + i]!;
      corners.push([this.plane[2 * v]!, this.plane[2 * v + 1]!]);
    }
    if (this.kind === "annulus" && Math.max(...corners.map((c) => c[0])) - Math.min(...corners.map((c) => c[0])) > 0.5)
      for (const corner of corners) if (corner[0] < 0.5) corner[0] += 1;
    return corners;
  }

  /** The quad that contains a point of the plane, or -1. */
  quadAt(p: PlanePoint): number {
    for (let q = 0; q < this.size; ++q) if (this.turnOf(q, p) !== null) return q;
    return -1;
  }

  /** The place of a kind that is nearest to a point of the plane. */
  placeAt(kind: PlaceKind, p: PlanePoint): Place | null {
    const quad = this.quadAt(p);
    if (quad < 0) return null;
    const at = this.turnOf(quad, p)!, corners = this.corners(quad).map(([v, u]) => new THREE.Vector3(v / this.width, u / this.height, 0));
    return nearest(kind, quad, corners, new THREE.Vector3(at[0] / this.width, at[1] / this.height, 0));
  }

  /** The place of a kind that is nearest to a point of the surface. */
  placeNear(kind: PlaceKind, point: THREE.Vector3): Place {
    let quad = 0, least = Infinity;
    for (let q = 0; q < this.size; ++q) {
      const d = distanceToQuad(this.cornersInSpace(q), point);
      if (d < least) [least, quad] = [d, q];
    }
    return nearest(kind, quad, this.cornersInSpace(quad), point);
  }

  /** Where a point of the plane is on the surface, or null beside the texture. */
  toSpace(p: PlanePoint): THREE.Vector3 | null {
    const quad = this.quadAt(p);
    if (quad < 0) return null;
    const [v, u] = this.turnOf(quad, p)!, flat = this.corners(quad), space = this.cornersInSpace(quad);
    let best: THREE.Vector3 | null = null, most = -Infinity;
    for (const [a, b, c] of [[0, 1, 2], [0, 2, 3], [0, 1, 3], [1, 2, 3]] as const) {
      const at = THREE.Triangle.getBarycoord(new THREE.Vector3(v, u, 0), flatPoint(flat[a]!), flatPoint(flat[b]!), flatPoint(flat[c]!), new THREE.Vector3());
      const least = at ? Math.min(at.x, at.y, at.z) : -Infinity;
      if (!at || least <= most) continue;
      most = least;
      best = new THREE.Vector3().addScaledVector(space[a]!, at.x).addScaledVector(space[b]!, at.y).addScaledVector(space[c]!, at.z);
    }
    return best;
  }

  /** The vertices within a distance of a point of the surface. */
  verticesWithin(point: THREE.Vector3, radius: number): number[] {
    const found: number[] = [];
    for (let v = 0; v < this.space.length / 3; ++v) if (this.inSpace(v).distanceTo(point) <= radius) found.push(v);
    return found;
  }

  inPlane(vertex: number): PlanePoint {
    return [this.plane[2 * vertex]!, this.plane[2 * vertex + 1]!];
  }

  /** The ends of all edges on the surface, as pairs of points. */
  edgesInSpace(quads: Iterable<number>): Float32Array {
    const pairs: number[] = [];
    for (const q of quads) {
      const corners = this.cornersInSpace(q);
      for (let i = 0; i < 4; ++i) pairs.push(...corners[i]!.toArray(), ...corners[(i + 1) % 4]!.toArray());
    }
    return new Float32Array(pairs);
  }

  /** The point, or the same point once around, that is in the quad; null if neither is. */
  private turnOf(quad: number, p: PlanePoint): PlanePoint | null {
    const corners = this.corners(quad);
    if (isInside(corners, p)) return p;
    const around: PlanePoint = [p[0] + 1, p[1]];
    return this.kind === "annulus" && isInside(corners, around) ? around : null;
  }
}

function flatPoint([v, u]: PlanePoint): THREE.Vector3 {
  return new THREE.Vector3(v, u, 0);
}

function distanceToQuad(corners: THREE.Vector3[], point: THREE.Vector3): number {
  const on = new THREE.Vector3();
  let least = Infinity;
  for (const [a, b, c] of [[0, 1, 2], [0, 2, 3]] as const) {
    new THREE.Triangle(corners[a]!, corners[b]!, corners[c]!).closestPointToPoint(point, on);
    least = Math.min(least, on.distanceToSquared(point));
  }
  return least;
}

function nearest(kind: PlaceKind, quad: number, corners: THREE.Vector3[], point: THREE.Vector3): Place {
  let corner = 0, least = Infinity;
  const on = new THREE.Vector3();
  for (let c = 0; c < 4 && kind !== "quad"; ++c) {
    if (kind === "corner") on.copy(corners[c]!);
    else new THREE.Line3(corners[c]!, corners[(c + 1) % 4]!).closestPointToPoint(point, true, on);
    const d = on.distanceToSquared(point);
    if (d < least) [least, corner] = [d, c];
  }
  return { kind, quad, corner };
}

function isInside(corners: PlanePoint[], [x, y]: PlanePoint): boolean {
  let crossings = 0;
  for (let i = 0, j = corners.length - 1; i < corners.length; j = i++) {
    const [xi, yi] = corners[i]!, [xj, yj] = corners[j]!;
    if (yi > y !== yj > y && x < ((xj - xi) * (y - yi)) / (yj - yi) + xi) ++crossings;
  }
  return crossings % 2 === 1;
}
