// SPDX-License-Identifier: GPL-3.0-or-later
// What a tool sees of the view of a chart.
import type * as THREE from "three";
import type { Place, PlanePoint, Texture } from "./texture";

/** Takes the pointer in the plane; null where it left. */
export interface PlaneListener {
  hover(at: PlanePoint | null): void;
  press?(at: PlanePoint): void;
  drag?(at: PlanePoint): void;
  release?(at: PlanePoint): void;
}

/** What shines in both views. */
export interface Shine {
  places: Place[];
  vertices: number[];
  /** Points of the surface that stay. */
  anchors: THREE.Vector3[];
}

export interface ChartDisplay {
  /** The texture of the chart that is chosen. */
  readonly texture: Texture | null;
  /** Gets the pointer instead of the view's own highlight. */
  listener: PlaneListener | null;
  /** The quad under the pointer on the surface shines in the plane too. */
  hoverOnSurface(point: THREE.Vector3 | null): void;
  light(shine: Shine): void;
}
