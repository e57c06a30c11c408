// SPDX-License-Identifier: GPL-3.0-or-later
import * as THREE from "three";
import type { Workbench } from "../workbench";
import { criticalColours } from "../scene/colours";
import { markers } from "../scene/lines";
import { markerMaterial, Shape } from "../scene/materials";
import type { CriticalPoint } from "../scene/stage";
import { h, icon } from "../ui/dom";
import { icons } from "../ui/icons";
import type { KeyNotes } from "../ui/keyboard";
import { pick, surfacePoint } from "./pick";
import type { Tool } from "./tool";

/** Adds, moves and deletes the points where limbs end. */
export class ExtremumTool implements Tool {
  readonly id = "extremum";
  readonly name = "Extrema";
  readonly key = "e";
  readonly icon = icons.extremum;
  readonly keys: KeyNotes = [["Delete", "delete the chosen one"], ["Enter", "design with those placed"]];
  private isMaximum = true;
  private wholeSurface = false;
  private chosen: CriticalPoint | null = null;
  private dragged: CriticalPoint | null = null;
  private moves = false;
  /** Before there is a design: those that are placed by hand, which it will begin with. */
  private placed: { at: THREE.Vector3; isMaximum: boolean }[] = [];
  private readonly marks = new THREE.Group();
  private readonly material = markerMaterial();

  constructor(private readonly app: Workbench) {
    this.material.depthTest = false;
    this.material.uniforms.size!.value = 20;
    this.material.uniforms.ratio!.value = Math.min(devicePixelRatio, 2);
    app.viewport.scene.add(this.marks);
  }

  hint(): string {
    if (this.begins) return this.isComplete ? "Place more, or press Enter to design with these." : `Click the end of a limb: it becomes a ${this.isMaximum ? "maximum" : "minimum"}. A design needs one of each.`;
    if (this.chosen) return "Press Delete to delete this extremum, or drag it elsewhere.";
    return `Click to add a ${this.isMaximum ? "maximum" : "minimum"}; drag one to move it.`;
  }

  begin(): void {
    this.app.showLayersOf("field");
    this.showBox();
  }
  refresh(): void {
    if (!this.begins || !this.app.store.get("state")?.file) this.place([]);
    if (this.app.store.get("tool") === this.id) this.showBox();
  }
  end(): void {
    this.place([]);
    this.chosen = this.dragged = null;
    this.app.tools.setBox(null);
  }

  press(event: PointerEvent): boolean {
    const point = this.app.stage.criticalAt(event);
    this.dragged = point && (point.kind === 0 || point.kind === 2) ? point : null;
    this.moves = false;
    return this.dragged !== null;
  }

  drag(event: PointerEvent): void {
    this.moves = true;
    this.send(event, true);
  }

  release(event: PointerEvent): void {
    if (this.moves) this.send(event, false);
    else this.chosen = this.dragged;
    this.dragged = null;
    this.showBox();
    this.app.tools.tellHint();
  }

  abandon(): void {
    this.dragged = null;
  }

  click(event: PointerEvent): void {
    this.chosen = null;
    const hit = pick(this.app, event, "surface");
    if (hit && this.begins) this.place([...this.placed, { at: this.app.stage.surface.vertexNear(hit.point)?.point ?? hit.point, isMaximum: this.isMaximum }]);
    else if (hit) void this.app.edit({ edit: "add_extremum", at: surfacePoint(this.app, hit.point), maximum: this.isMaximum, scope: this.scope });
    this.showBox();
    this.app.tools.tellHint();
  }

  key_(event: KeyboardEvent): boolean {
    const deletes = event.key === "Delete" || event.key === "Backspace";
    if (event.key === "Enter" && this.begins && this.isComplete) this.design();
    else if (deletes && this.begins && this.placed.length > 0) this.place(this.placed.slice(0, -1));
    else if (deletes && this.chosen) this.remove();
    else return false;
    return true;
  }

  private remove(): void {
    if (this.chosen) void this.app.edit({ edit: "remove_extremum", at: surfacePoint(this.app, this.chosen.position), scope: this.scope });
    this.chosen = null;
    this.showBox();
  }

  /** Whether there is no design yet. */
  private get begins(): boolean {
    return !this.app.store.get("state")?.facts?.charts.length;
  }
  private get isComplete(): boolean {
    return this.placed.some((p) => p.isMaximum) && this.placed.some((p) => !p.isMaximum);
  }

  private design(): void {
    const extrema = this.placed.map(({ at, isMaximum }) => ({ at: surfacePoint(this.app, at), maximum: isMaximum }));
    void this.app.edit({ edit: "set_extrema", extrema, axis: this.app.store.get("up") });
  }

  private place(placed: { at: THREE.Vector3; isMaximum: boolean }[]): void {
    if (placed.length === 0 && this.placed.length === 0) return;
    this.placed = placed;
    for (const child of [...this.marks.children]) {
      (child as THREE.Points).geometry.dispose();
      this.marks.remove(child);
    }
    if (placed.length > 0)
      this.marks.add(markers(this.material, new Float32Array(placed.flatMap((p) => p.at.toArray())), placed.map((p) => criticalColours[p.isMaximum ? 2 : 0]!), placed.map((p) => (p.isMaximum ? Shape.triangleUp : Shape.triangleDown)), placed.map(() => 1)));
    this.app.viewport.invalidate();
    this.showBox();
    this.app.tools.tellHint();
  }

  private get scope(): string {
    return this.wholeSurface ? "surface" : "chart";
  }

  private send(event: PointerEvent, live: boolean): void {
    const hit = pick(this.app, event, "surface");
    if (!this.dragged) return;
    if (!hit) return live ? undefined : this.app.endDrag();
    this.app.dragEdit(
      { edit: "move_extremum", from: surfacePoint(this.app, this.dragged.position), to: surfacePoint(this.app, hit.point), scope: this.scope }, live,
    );
  }

  private showBox(): void {
    const choice = (name: string, on: boolean, set: () => void, id: string): HTMLElement =>
      h("button", { className: `small ${on ? "on" : ""}`, role: "radio", "aria-checked": String(on), "data-choice": id, onclick: () => (set(), this.showBox(), this.app.tools.tellHint()) }, name);
    this.app.tools.setBox(
      h(
        "div", { className: "tool-box" }, h("strong", {}, "Extrema"),
        h("div", { className: "row", role: "radiogroup" }, choice("▲ Maximum", this.isMaximum, () => (this.isMaximum = true), "maximum"), choice("▼ Minimum", !this.isMaximum, () => (this.isMaximum = false), "minimum")),
        this.begins && h("button", { className: "primary wide", id: "design-by-hand", disabled: !this.isComplete, onclick: () => this.design() }, `Design with these ${this.placed.length}`),
        this.begins && h("button", { className: "small", disabled: this.placed.length === 0, onclick: () => this.place(this.placed.slice(0, -1)) }, "Delete the last"),
        !this.begins && h("button", { className: "small", id: "delete-extremum", disabled: !this.chosen, title: "Click an extremum to choose it (Delete)", onclick: () => this.remove() }, icon(icons.remove), "Delete the chosen one"),
        !this.begins && h("div", { className: "row", role: "radiogroup" }, choice("Only its chart", !this.wholeSurface, () => (this.wholeSurface = false), "chart"), choice("Whole surface", this.wholeSurface, () => (this.wholeSurface = true), "surface")),
        h("p", { className: "note" }, this.begins ? "Minima where the field is lowest, maxima where it is highest: between them run the quads." : "Every limb that is to have quads of its own needs an extremum at its end. “Whole surface” designs all contours anew."),
      ),
    );
  }
}
