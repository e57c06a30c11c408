// SPDX-License-Identifier: GPL-3.0-or-later
// What a click can mean, and how it is written in an edit.
import type { Workbench } from "../workbench";
import type { Vector } from "../net/messages";
import type * as THREE from "three";
import { isFree } from "../scene/stage";

export type Target = "surface" | "saddle" | "extremum" | "contour" | "free";

export interface Picked {
  point: THREE.Vector3;
  chart: number;
}

/** The words for a target that was missed. */
export const missed: Record<Target, string> = {
  surface: "That was beside the surface.",
  saddle: "There is no saddle here: they are the yellow diamonds.",
  extremum: "There is no extremum here: they are the blue and red triangles.",
  contour: "There is no contour here: they are the dark curves.",
  free: "There is no contour here that this can be done with: those have a light line in their middle, and run through no saddle.",
};

export function pick(app: Workbench, event: PointerEvent, target: Target): Picked | null {
  const { stage, viewport } = app;
  if (target === "saddle" || target === "extremum") {
    const point = stage.criticalAt(event);
    const isExtremum = point?.kind === 0 || point?.kind === 2;
    return point && isExtremum === (target === "extremum") ? { point: point.position, chart: -1 } : null;
  }
  const hit = stage.surface.pick(viewport.ray(event));
  if (target === "surface") return hit && { point: hit.point, chart: hit.chart };
  const contour = stage.contourAt(event);
  if (target === "free" && contour && !isFree(contour)) return null;
  return contour && { point: nearest(contour.points, hit?.point ?? contour.points[0]!), chart: hit?.chart ?? -1 };
}

function nearest(points: THREE.Vector3[], to: THREE.Vector3): THREE.Vector3 {
  return points.reduce((best, p) => (p.distanceToSquared(to) < best.distanceToSquared(to) ? p : best));
}

/** A point of the picture as edits name it: in the coordinates of the file. */
export function surfacePoint(app: Workbench, point: THREE.Vector3): { point: Vector } {
  return { point: filePoint(app, point) };
}

export function filePoint(app: Workbench, point: THREE.Vector3): Vector {
  const [x, y, z] = app.store.get("state")?.file?.origin ?? [0, 0, 0];
  return [point.x + x, point.y + y, point.z + z];
}
