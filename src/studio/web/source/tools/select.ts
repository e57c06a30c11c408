// SPDX-License-Identifier: GPL-3.0-or-later
import type { Workbench } from "../workbench";
import type { Edit } from "../net/messages";
import { PlaceMark } from "../scene/place_mark";
import { isFree, type Contour, type CriticalPoint } from "../scene/stage";
import { h, icon } from "../ui/dom";
import { icons } from "../ui/icons";
import { whatNext } from "../ui/steps_bar";
import type { KeyNotes } from "../ui/keyboard";
import { pick, surfacePoint, type Picked } from "./pick";
import type { Tool } from "./tool";

/** What a click chooses beside charts. */
type Chosen = { contour: Contour; at: Picked } | { point: CriticalPoint };

/** Shows what the pointer is on: a chart, a contour, an extremum, another part of the file. A click chooses it; what is chosen can be deleted. */
export class SelectTool implements Tool {
  readonly id = "select";
  readonly name = "Select";
  readonly key = "v";
  readonly icon = icons.select;
  readonly keys: KeyNotes = [["Delete", "delete the chosen contour or extremum"]];

  /** The other part of the file that the pointer is on, or 0. */
  private part = 0;
  private chosen: Chosen | null = null;
  private readonly mark: PlaceMark;

  constructor(private readonly app: Workbench) {
    this.mark = new PlaceMark(app.viewport, [0.24, 0.55, 1]);
  }

  hint(): string {
    if (this.part > 0) return `Click to work on part ${this.part}.`;
    if (this.chosen) return this.deletion ? "Press Delete to delete it, or click something else." : "This contour runs through a saddle: “Move contour” moves it.";
    return whatNext(this.app.store.get("step"), this.app.store.get("state"));
  }

  begin(): void {
    this.choose(null);
  }

  hover(event: PointerEvent): void {
    const { stage, viewport, store, chartView } = this.app, under = this.under(event);
    stage.choose([...(this.chosen && "contour" in this.chosen ? [this.chosen.contour] : []), ...(under && "contour" in under ? [under.contour] : [])]);
    const ray = viewport.ray(event), hit = stage.surface.pick(ray);
    this.hoverPart(hit ? 0 : stage.others.pick(ray));
    stage.setHovered(hit && !under ? hit.chart : -1);
    viewport.canvas.style.cursor = under ? "pointer" : "";
    chartView.hoverOnSurface(hit && hit.chart === store.get("chart") ? hit.point : null);
  }

  click(event: PointerEvent): void {
    const under = this.under(event);
    this.choose(under);
    if (under) return this.app.store.set("chart", -1);
    const ray = this.app.viewport.ray(event), hit = this.app.stage.surface.pick(ray);
    const part = hit ? 0 : this.app.stage.others.pick(ray);
    if (part > 0) return void this.app.ask("component", { component: part });
    const chart = hit ? hit.chart : -1;
    this.app.store.set("chart", chart === this.app.store.get("chart") ? -1 : chart);
  }

  key_(event: KeyboardEvent): boolean {
    if ((event.key !== "Delete" && event.key !== "Backspace") || !this.deletion) return false;
    this.remove();
    return true;
  }

  end(): void {
    this.app.stage.setHovered(-1);
    this.app.viewport.canvas.style.cursor = "";
    this.hoverPart(0);
    this.choose(null);
  }

  /** What is chosen stays so while work ends that does not change it. */
  refresh(): void {
    const { chosen } = this, { contours, critical } = this.app.stage;
    this.hoverPart(0);
    if (chosen && ("point" in chosen ? !critical.includes(chosen.point) : !contours.includes(chosen.contour))) this.choose(null);
  }

  /** The sign or the contour that the pointer is on, of those that are shown. */
  private under(event: PointerEvent): Chosen | null {
    const { stage, store } = this.app, layers = store.get("layers");
    const point = layers.has("critical") ? stage.criticalAt(event) : null;
    if (point && (point.kind === 0 || point.kind === 2)) return { point };
    const contour = layers.has("contours") ? stage.contourAt(event) : null, at = contour && pick(this.app, event, "contour");
    return contour && at && { contour, at };
  }

  private choose(chosen: Chosen | null): void {
    this.chosen = chosen;
    this.app.stage.choose(chosen && "contour" in chosen ? [chosen.contour] : []);
    this.mark.show(chosen && "point" in chosen ? chosen.point.position : null);
    if (this.app.store.get("tool") !== this.id) return;
    this.app.tools.setBox(chosen && this.box(chosen));
    this.app.tools.tellHint();
  }

  /** The edit that deletes what is chosen, or null where nothing can. */
  private get deletion(): Edit | null {
    const { chosen } = this;
    if (!chosen) return null;
    if ("point" in chosen) return { edit: "remove_extremum", at: surfacePoint(this.app, chosen.point.position), scope: "chart" };
    return isFree(chosen.contour) ? { edit: "remove_contour", at: surfacePoint(this.app, chosen.at.point) } : null;
  }

  private remove(): void {
    const { deletion } = this;
    if (deletion) void this.app.edit(deletion);
  }

  private box(chosen: Chosen): HTMLElement {
    const name = "point" in chosen ? (chosen.point.kind === 2 ? "Maximum" : "Minimum") : isFree(chosen.contour) ? "Contour" : "Contour of a saddle";
    const act = (name: string, edit: string): HTMLElement | null => ("contour" in chosen ? h("button", { className: "small", onclick: () => void this.app.edit({ edit, at: surfacePoint(this.app, chosen.at.point) }) }, name) : null);
    return h(
      "div", { className: "tool-box" }, h("strong", {}, name),
      h("div", { className: "row" }, h("button", { className: "small", id: "delete-chosen", disabled: !this.deletion, title: "Delete it (Delete)", onclick: () => this.remove() }, icon(icons.remove), "Delete"), act("Straighten", "straighten_contour"), act("Snap", "snap_contour")),
    );
  }

  private hoverPart(part: number): void {
    if (part === this.part) return;
    this.part = part;
    this.app.stage.setHoveredPart(part);
    this.app.tools.tellHint();
  }
}
