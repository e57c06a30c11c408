// SPDX-License-Identifier: GPL-3.0-or-later
import type { App } from "../app";
import { icons } from "../ui/icons";
import type { Tool } from "./tool";

/** Shows which chart the pointer is on; a click chooses it. */
export class SelectTool implements Tool {
  readonly id = "select";
  readonly name = "Select";
  readonly key = "v";
  readonly icon = icons.select;

  constructor(private readonly app: App) {}

  hint(): string {
    return this.app.store.get("state")?.statistics ? "Click a chart to choose it. Double click to turn around a point." : "Press “Suggest a design” to begin.";
  }

  hover(event: PointerEvent): void {
    const hit = this.app.stage.surface.pick(this.app.viewport.ray(event));
    this.app.stage.setHovered(hit ? hit.chart : -1);
    this.app.chartView.hoverOnSurface(hit && hit.chart === this.app.store.get("chart") ? hit.point : null);
  }

  click(event: PointerEvent): void {
    const hit = this.app.stage.surface.pick(this.app.viewport.ray(event));
    const chart = hit ? hit.chart : -1;
    this.app.store.set("chart", chart === this.app.store.get("chart") ? -1 : chart);
  }

  end(): void {
    this.app.stage.setHovered(-1);
  }
}
