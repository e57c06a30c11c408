// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the way of an edit flashes: a chart's outline, a contour, or a place such as a saddle's.
import * as THREE from "three";
import { Lines, markers } from "./lines";
import { markerMaterial, Shape } from "./materials";
import { pairsOf, type Stage } from "./stage";

const red: [number, number, number] = [0.95, 0.25, 0.22];
const blinks = 4, blink = 260; // how often, and milliseconds of light and of dark

export class Flash {
  /** What flashed last: "contour 12", or nothing. */
  last = "";
  private readonly lines = new Lines(6, 0xf2403a, { hidden: true });
  private readonly material = markerMaterial();
  private mark: THREE.Points | null = null;
  private timer = 0;

  constructor(private readonly stage: Stage) {
    this.lines.object.renderOrder = 9;
    this.material.depthTest = false;
    this.material.uniforms.size!.value = 30;
    this.material.uniforms.ratio!.value = Math.min(devicePixelRatio, 2);
    stage.viewport.scene.add(this.lines.object);
  }

  /** Lets an element that the program names flash; whether it is one that can be seen. */
  show(element: string, index: number): boolean {
    this.stop();
    const { surface, contours } = this.stage;
    const contour = element === "contour" ? contours.find((c) => c.edge === index) : undefined;
    const vertex = element === "vertex" ? index : element === "face" ? (surface.triangles[3 * index] ?? -1) : -1;
    if (contour) this.lines.set(pairsOf([contour]));
    else if (element === "chart") this.lines.set(surface.outlineOf(index));
    else if (vertex >= 0 && 3 * vertex < surface.positions.length) this.put(surface.vertex(vertex));
    if (this.lines.segments === 0 && !this.mark) return false;
    this.last = `${element} ${index}`;
    this.blink(matchMedia("(prefers-reduced-motion: reduce)").matches ? 1 : blinks);
    return true;
  }

  stop(): void {
    clearTimeout(this.timer);
    this.last = "";
    this.lines.set(new Float32Array());
    this.put(null);
    this.light(false);
  }

  private blink(times: number): void {
    this.light(true);
    this.timer = window.setTimeout(() => {
      this.light(false);
      if (times > 1) this.timer = window.setTimeout(() => this.blink(times - 1), blink);
    }, times === 1 ? 4 * blink : blink);
  }

  private light(on: boolean): void {
    this.lines.show(on);
    if (this.mark) this.mark.visible = on;
    this.stage.viewport.invalidate();
  }

  private put(place: THREE.Vector3 | null): void {
    if (this.mark) {
      this.stage.viewport.scene.remove(this.mark);
      this.mark.geometry.dispose();
    }
    this.mark = place && markers(this.material, new Float32Array(place.toArray()), [red], [Shape.disc], [1]);
    if (!this.mark) return;
    this.mark.renderOrder = 12;
    this.stage.viewport.scene.add(this.mark);
  }
}
