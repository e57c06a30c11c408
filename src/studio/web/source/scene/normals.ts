// SPDX-License-Identifier: GPL-3.0-or-later
// Normals for shading. At a crease each side has its own, or a sharp edge would look like a bulge.

export type Shading = "smooth" | "crease" | "flat";

/** Faces that meet at less than this are shaded as one, in degrees. */
const creaseAngle: Record<Shading, number> = { smooth: 180, crease: 40, flat: 0 };

/** The normal of each corner of each triangle: of the faces around its vertex that do not differ by more than the crease's angle, by area. */
export function cornerNormals(p: Float32Array, triangles: Uint32Array, shading: Shading): Float32Array<ArrayBuffer> {
  const faces = triangles.length / 3, areas = new Float32Array(triangles.length), units = new Float32Array(triangles.length);
  faceNormals(p, triangles, areas, units);
  const out = new Float32Array(3 * triangles.length), least = Math.cos((creaseAngle[shading] * Math.PI) / 180) - 1e-6;
  const { begin, corner } = cornersAround(triangles, p.length / 3);
  for (let c = 0; c < triangles.length; ++c) {
    const f = 3 * ((c / 3) | 0), v = triangles[c]!;
    let x = 0, y = 0, z = 0;
    if (shading === "flat") [x, y, z] = [units[f]!, units[f + 1]!, units[f + 2]!];
    else
      for (let i = begin[v]!; i < begin[v + 1]!; ++i) {
        const g = 3 * ((corner[i]! / 3) | 0);
        if (shading === "crease" && g !== f && units[f]! * units[g]! + units[f + 1]! * units[g + 1]! + units[f + 2]! * units[g + 2]! < least) continue;
        x += areas[g]!;
        y += areas[g + 1]!;
        z += areas[g + 2]!;
      }
    const length = Math.hypot(x, y, z) || 1;
    out[3 * c] = x / length;
    out[3 * c + 1] = y / length;
    out[3 * c + 2] = z / length;
  }
  return faces > 0 ? out : new Float32Array();
}

/** Of each triangle the normal, as long as twice its area and of length one. */
function faceNormals(p: Float32Array, triangles: Uint32Array, areas: Float32Array, units: Float32Array): void {
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t]!, b = 3 * triangles[t + 1]!, c = 3 * triangles[t + 2]!;
    const ux = p[b]! - p[a]!, uy = p[b + 1]! - p[a + 1]!, uz = p[b + 2]! - p[a + 2]!;
    const vx = p[c]! - p[a]!, vy = p[c + 1]! - p[a + 1]!, vz = p[c + 2]! - p[a + 2]!;
    areas[t] = uy * vz - uz * vy;
    areas[t + 1] = uz * vx - ux * vz;
    areas[t + 2] = ux * vy - uy * vx;
    const length = Math.hypot(areas[t]!, areas[t + 1]!, areas[t + 2]!) || 1;
    for (let k = t; k < t + 3; ++k) units[k] = areas[k]! / length;
  }
}

/** The corners of triangles at each vertex: those of v are corner[begin[v]] .. corner[begin[v + 1] - 1]. */
function cornersAround(triangles: Uint32Array, vertices: number): { begin: Uint32Array; corner: Uint32Array } {
  const begin = new Uint32Array(vertices + 1), corner = new Uint32Array(triangles.length);
  for (const v of triangles) ++begin[v + 1]!;
  for (let v = 0; v < vertices; ++v) begin[v + 1]! += begin[v]!;
  const next = begin.slice();
  triangles.forEach((v, c) => (corner[next[v]!++] = c));
  return { begin, corner };
}
