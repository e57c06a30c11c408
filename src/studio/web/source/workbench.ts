// SPDX-License-Identifier: GPL-3.0-or-later
// What tools and panels get of the page. app.ts implements it; they do not know who does, and app.ts is imported by main.ts alone.
import type * as THREE from "three";
import type { ChartDisplay } from "./local/chart_display";
import type { Connection } from "./net/connection";
import type { Edit } from "./net/messages";
import type { ViewId } from "./scene/layers";
import type { Stage } from "./scene/stage";
import type { Viewport } from "./scene/viewport";
import type { Store } from "./store";
import type { Tools } from "./tools/tool";
import type { Toasts } from "./ui/toasts";

export interface Workbench {
  readonly store: Store;
  readonly toasts: Toasts;
  readonly connection: Connection;
  readonly viewport: Viewport;
  readonly stage: Stage;
  readonly tools: Tools;
  readonly chartView: ChartDisplay;

  /** Sends a request and tells the user if it fails; null then. */
  ask(command: string, members?: Record<string, unknown>): Promise<unknown>;
  edit(edit: Edit, live?: boolean): Promise<unknown>;
  /** An edit that follows the pointer; the last one of a drag is not `live`. */
  dragEdit(edit: Edit, live: boolean): void;
  /** The pointer was let go where nothing is: what was dragged stays where it was last. */
  endDrag(): void;
  /** What is dragged goes back to where it was. */
  cancelDrag(): void;
  /** Looks at a place of the surface from outside. */
  flyTo(place: THREE.Vector3, distance?: number): void;
  /** Sees all of the chosen chart, or everything where none is. */
  frameChart(): void;
  /** Lets only the quads shine whose quality passes; null: all. */
  lightQuads(lit: ((quality: number) => boolean) | null): void;
  /** Goes to the step of that view. */
  setView(view: ViewId): void;
  /** Shows the layers of a view, whatever the step. */
  showLayersOf(view: ViewId): void;
}
