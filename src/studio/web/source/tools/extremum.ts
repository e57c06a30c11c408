// SPDX-License-Identifier: GPL-3.0-or-later
import type { Workbench } from "../workbench";
import type { CriticalPoint } from "../scene/stage";
import { h } from "../ui/dom";
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
  readonly keys: KeyNotes = [["Delete", "remove the chosen one"]];
  private isMaximum = true;
  private wholeSurface = false;
  private chosen: CriticalPoint | null = null;
  private dragged: CriticalPoint | null = null;
  private moves = false;

  constructor(private readonly app: Workbench) {}

  hint(): string {
    if (this.chosen) return "Press Delete to remove this extremum, or drag it elsewhere.";
    return `Click to add a ${this.isMaximum ? "maximum" : "minimum"}; drag one to move it.`;
  }

  begin(): void {
    this.app.setView("field");
    this.showBox();
  }
  end(): void {
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
    this.app.tools.tellHint();
  }

  click(event: PointerEvent): void {
    this.chosen = null;
    const hit = pick(this.app, event, "surface");
    if (hit) void this.app.edit({ edit: "add_extremum", at: surfacePoint(this.app, hit.point), maximum: this.isMaximum, scope: this.scope });
    this.app.tools.tellHint();
  }

  key_(event: KeyboardEvent): boolean {
    if ((event.key !== "Delete" && event.key !== "Backspace") || !this.chosen) return false;
    void this.app.edit({ edit: "remove_extremum", at: surfacePoint(this.app, this.chosen.position), scope: this.scope });
    this.chosen = null;
    return true;
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
        h("div", { className: "row", role: "radiogroup" }, choice("Only its chart", !this.wholeSurface, () => (this.wholeSurface = false), "chart"), choice("Whole surface", this.wholeSurface, () => (this.wholeSurface = true), "surface")),
        h("p", { className: "note" }, "Every limb that is to have quads of its own needs an extremum at its end. “Whole surface” designs all contours anew."),
      ),
    );
  }
}
