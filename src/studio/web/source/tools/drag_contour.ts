// SPDX-License-Identifier: GPL-3.0-or-later
import type { Workbench } from "../workbench";
import { isFree } from "../scene/stage";
import { icons } from "../ui/icons";
import { pick, surfacePoint, type Picked } from "./pick";
import type { Tool } from "./tool";

/** Drags a contour without saddles along its charts. */
export class DragContourTool implements Tool {
  readonly id = "drag";
  readonly name = "Drag contour";
  readonly key = "w";
  readonly icon = icons.drag;
  private grabbed: Picked | null = null;
  private moves = false;

  constructor(private readonly app: Workbench) {}

  hint(): string {
    return "Drag a contour with a light middle to where it is to run.";
  }
  begin(): void {
    if (!this.app.store.get("layers").has("contours")) this.app.showLayersOf("atlas");
  }
  end(): void {
    this.app.stage.choose([]);
  }
  hover(event: PointerEvent): void {
    this.app.stage.chooseAt(event, isFree);
  }
  press(event: PointerEvent): boolean {
    this.grabbed = pick(this.app, event, "free");
    this.moves = false;
    return this.grabbed !== null;
  }
  drag(event: PointerEvent): void {
    this.moves = true;
    this.send(event, true);
  }
  release(event: PointerEvent): void {
    if (this.moves) this.send(event, false);
    this.grabbed = null;
  }

  abandon(): void {
    this.grabbed = null;
  }

  private send(event: PointerEvent, live: boolean): void {
    const hit = pick(this.app, event, "surface");
    if (!this.grabbed) return;
    if (!hit) return live ? undefined : this.app.endDrag();
    this.app.dragEdit({ edit: "drag_contour", at: surfacePoint(this.app, this.grabbed.point), to: surfacePoint(this.app, hit.point) }, live);
  }
}
