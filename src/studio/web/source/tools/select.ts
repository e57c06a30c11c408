// SPDX-License-Identifier: GPL-3.0-or-later
import type { Workbench } from "../workbench";
import { icons } from "../ui/icons";
import type { Tool } from "./tool";

/** Shows which chart the pointer is on; a click chooses it. */
export class SelectTool implements Tool {
  readonly id = "select";
  readonly name = "Select";
  readonly key = "v";
  readonly icon = icons.select;

  /** The other part of the file that the pointer is on, or 0. */
  private part = 0;

  constructor(private readonly app: Workbench) {}

  hint(): string {
    if (this.part > 0) return `Click to work on part ${this.part}.`;
    return this.app.store.get("state")?.statistics ? "Click a chart to choose it. Double click to turn around a point." : "Press “Suggest a design” to begin, or place extrema by hand.";
  }

  hover(event: PointerEvent): void {
    const ray = this.app.viewport.ray(event), hit = this.app.stage.surface.pick(ray);
    this.hoverPart(hit ? 0 : this.app.stage.others.pick(ray));
    this.app.stage.setHovered(hit ? hit.chart : -1);
    this.app.chartView.hoverOnSurface(hit && hit.chart === this.app.store.get("chart") ? hit.point : null);
  }

  click(event: PointerEvent): void {
    const ray = this.app.viewport.ray(event), hit = this.app.stage.surface.pick(ray);
    const part = hit ? 0 : this.app.stage.others.pick(ray);
    if (part > 0) return void this.app.ask("component", { component: part });
    const chart = hit ? hit.chart : -1;
    this.app.store.set("chart", chart === this.app.store.get("chart") ? -1 : chart);
  }

  end(): void {
    this.app.stage.setHovered(-1);
    this.hoverPart(0);
  }

  refresh(): void {
    this.hoverPart(0);
  }

  private hoverPart(part: number): void {
    if (part === this.part) return;
    this.part = part;
    this.app.stage.setHoveredPart(part);
    this.app.tools.tellHint();
  }
}
