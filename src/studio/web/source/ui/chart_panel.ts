// SPDX-License-Identifier: GPL-3.0-or-later
import type { Workbench } from "../workbench";
import type { ChartFacts, Edit } from "../net/messages";
import { surfacePoint } from "../tools/pick";
import { h, replace } from "./dom";
import { numberField } from "./number_field";
import { chartName } from "./words";

/** What can be done with the chart that is chosen. */
export function chartPanel(app: Workbench): HTMLElement {
  const host = h("div", { className: "chart-panel" });
  app.store.watch(["state", "chart"], () => {
    const id = app.store.get("chart");
    const chart = app.store.get("state")?.facts?.charts.find((c) => c.id === id);
    if (!chart) return replace(host, h("p", { className: "empty" }, "Click a chart on the surface or in the list."));
    replace(host, ...controls(app, chart));
  });
  return host;
}

function controls(app: Workbench, chart: ChartFacts): HTMLElement[] {
  const send = (make: (at: object) => Edit): void => {
    const point = app.stage.surface.insideOf(chart.id);
    if (!point) return void app.toasts.show("This chart is too small", "It has no vertex inside that an edit could name.", "bad");
    void app.edit(make(surfacePoint(app, point)));
  };
  const number = (label: string, id: string, value: number, free: boolean, min: number, step: number, make: (value: number, at: object) => Edit): HTMLElement => {
    const set = (to: number): void => send((at) => make(to, at));
    const { element: box } = numberField({ id, label, min, max: 100000, step, value }, set, (sentence) => app.toasts.show("That did not work", sentence, "bad"));
    const slider = h("input", { type: "range", min: String(min), max: String(Math.max(4 * value, 4 * min, 16)), step: String(step), value: String(value), "aria-label": `${label}, coarse` });
    slider.oninput = () => (box.value = slider.value);
    slider.onchange = () => set(slider.valueAsNumber);
    const release = h("button", { className: "small ghost", disabled: free, title: "Let the program choose", onclick: () => send((at) => make(0, at)) }, "free");
    return h("label", { className: "field" }, h("span", { className: "label" }, label), box, slider, release);
  };
  const tube = chart.kind === "annulus";
  const title = h("p", {}, h("strong", {}, chartName(chart)), `: ${chart.columns} × ${chart.rows} quads${chart.locked ? ", locked" : ""}`);
  const actions = h(
    "div", { className: "chart-actions" },
    h("button", { className: "small", id: "open-texture", title: "Shows the chart's texture beside the model, to edit it (G)", onclick: () => app.tools.choose("texture") }, "Open texture"),
    h("button", { className: "small", id: "lock", onclick: () => send((at) => ({ edit: "lock_chart", at, locked: !chart.locked })) }, chart.locked ? "Unlock" : "Lock"),
    tube && h("button", { className: "small", id: "subdivide-here", onclick: () => send((at) => ({ edit: "subdivide_chart", at })) }, "Add contour"),
    tube && h("button", { className: "small", onclick: () => send((at) => ({ edit: "collapse_chart", at })) }, "Collapse"),
    !tube && h("button", { className: "small", onclick: () => send((at) => ({ edit: "pin_corners", at })) }, "Make regular"),
  );
  if (!tube) return [title, actions];
  const grading = h("input", { type: "range", min: "-2", max: "2", step: "0.1", value: String(Math.log2(chart.grading)), id: "grading" });
  grading.onchange = () => send((at) => ({ edit: "set_grading", at, ratio: 2 ** grading.valueAsNumber }));
  const turn = (by: number): HTMLElement =>
    h("button", { className: "small", title: "Turns the quads around the tube by one column", onclick: () => send((at) => ({ edit: "set_shift", at, shift: chart.shift + by })) }, by < 0 ? "◂" : "▸");
  return [
    title,
    number("Around", "columns", chart.columns, chart.set_columns === 0, 4, 2, (columns, at) => ({ edit: "set_columns", at, columns })),
    number("Around, top", "columns-high", chart.columns_high, chart.columns_high === chart.columns, 4, 2, (columns, at) => ({ edit: "set_columns", at, columns, side: "high" })),
    number("Along", "rows", chart.rows, chart.set_rows === 0, 2, 1, (rows, at) => ({ edit: "set_rows", at, rows })),
    h("label", { className: "field" }, h("span", { className: "label" }, "Denser at"), h("span", {}, "top"), grading, h("span", {}, "bottom")),
    h("div", { className: "field" }, h("span", { className: "label" }, "Twist"), turn(-1), h("output", { className: "twist" }, String(chart.shift)), turn(1)),
    actions,
  ];
}
