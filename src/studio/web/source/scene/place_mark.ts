// SPDX-License-Identifier: GPL-3.0-or-later
// A sign at the place that a list speaks of: a hint's, a finding's.
import * as THREE from "three";
import type { Rgb } from "./colours";
import { markers } from "./lines";
import { markerMaterial, Shape } from "./materials";
import type { Viewport } from "./viewport";

export class PlaceMark {
  private readonly material = markerMaterial();
  private mark: THREE.Points | null = null;

  constructor(private readonly viewport: Viewport, private readonly colour: Rgb = [1, 0.71, 0.33]) {
    this.material.depthTest = false;
    this.material.uniforms.size!.value = 26;
    this.material.uniforms.ratio!.value = Math.min(devicePixelRatio, 2);
  }

  show(place: THREE.Vector3 | null): void {
    if (this.mark) {
      this.viewport.scene.remove(this.mark);
      this.mark.geometry.dispose();
    }
    this.mark = place && markers(this.material, new Float32Array(place.toArray()), [this.colour], [Shape.disc], [1]);
    if (this.mark) {
      this.mark.renderOrder = 11;
      this.viewport.scene.add(this.mark);
    }
    this.viewport.invalidate();
  }
}
