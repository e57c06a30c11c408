// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of constant width on the screen: contours, the Reeb graph, the quads' edges.
import * as THREE from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Rgb } from "./colours";

export class Lines {
  readonly material: LineMaterial;
  readonly object: LineSegments2;
  segments = 0;

  constructor(width: number, private readonly colour: number, options: { hidden?: boolean; opacity?: number } = {}) {
    this.material = new LineMaterial({
      color: colour,
      linewidth: width,
      transparent: true,
      opacity: options.opacity ?? 1,
      depthTest: !(options.hidden ?? false),
      depthWrite: false,
      polygonOffset: true, // before the surface that they lie on
      polygonOffsetFactor: -2,
      polygonOffsetUnits: -12,
    });
    this.object = new LineSegments2(new LineSegmentsGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.visible = false;
  }

  /** Pairs of points. */
  set(pairs: Float32Array): void {
    this.object.geometry.dispose();
    const geometry = new LineSegmentsGeometry();
    this.segments = pairs.length / 6;
    if (this.segments > 0) geometry.setPositions(pairs);
    this.object.geometry = geometry;
  }

  show(visible: boolean): void {
    this.object.visible = visible && this.segments > 0;
  }

  /** Seen through a surface; in contrast to the ground then. */
  setXray(on: boolean, isDark: boolean): void {
    this.material.depthTest = !on;
    this.material.color.setHex(on && isDark ? 0xd5dde8 : this.colour);
  }
}

/** The pairs of neighbouring points of polylines that lie one after the other; line `i` is points begin[i] .. begin[i + 1] - 1. */
export function polylinePairs(points: Float32Array, begin: Uint32Array): Float32Array {
  const pairs: number[] = [];
  for (let i = 0; i + 1 < begin.length; ++i)
    for (let p = begin[i]!; p + 1 < begin[i + 1]!; ++p)
      for (let k = 3 * p; k < 3 * p + 6; ++k) pairs.push(points[k]!);
  return new Float32Array(pairs);
}

/** Markers of constant size on the screen. */
export function markers(
  material: THREE.ShaderMaterial, points: Float32Array, colours: Rgb[], shapes: number[], scales: number[],
): THREE.Points {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(points, 3));
  geometry.setAttribute("colour", new THREE.BufferAttribute(new Float32Array(colours.flat()), 3));
  geometry.setAttribute("shape", new THREE.BufferAttribute(new Float32Array(shapes), 1));
  geometry.setAttribute("scale", new THREE.BufferAttribute(new Float32Array(scales), 1));
  const object = new THREE.Points(geometry, material);
  object.frustumCulled = false;
  return object;
}
