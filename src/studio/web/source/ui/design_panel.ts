// SPDX-License-Identifier: GPL-3.0-or-later
import type { Edit } from "../net/messages";
import type { Store } from "../store";
import { h, readable, replace } from "./dom";

const axes: [string, [number, number, number]][] = [["X", [1, 0, 0]], ["Y", [0, 1, 0]], ["Z", [0, 0, 1]]];

/** The suggestion, the number of quads and the charts. */
export function designPanel(store: Store, edit: (edit: Edit) => void): HTMLElement {
  const persistence = h("input", { type: "range", min: "0.01", max: "0.3", step: "0.01", value: "0.08", id: "persistence" });
  const shown = h("output", {}, "8 %");
  persistence.oninput = () => (shown.textContent = `${Math.round(100 * persistence.valueAsNumber)} %`);
  const axis = h("select", { id: "axis" }, ...axes.map(([name], i) => h("option", { value: String(i), selected: i === 1 }, `${name} is up`)));
  axis.onchange = () => store.set("up", axes[Number(axis.value)]![1]);
  const suggest = (): void =>
    edit({ edit: "suggest", persistence: persistence.valueAsNumber, axis: axes[Number(axis.value)]![1] });

  const number = h("input", { type: "number", min: "50", max: "1000000", step: "50", value: "3000", id: "quads", "aria-label": "Number of quads" });
  const slider = h("input", { type: "range", min: "2", max: "5", step: "0.02", value: "3.477", "aria-label": "Number of quads, coarse" });
  const setTarget = (): void => {
    slider.value = String(Math.log10(number.valueAsNumber));
    edit({ edit: "set_target", quads: number.valueAsNumber });
  };
  number.onchange = setTarget;
  slider.oninput = () => (number.value = String(10 * Math.round(10 ** slider.valueAsNumber / 10)));
  slider.onchange = setTarget;

  const charts = h("div", { className: "chart-list" });
  store.watch(["state", "chart"], () => {
    const all = store.get("state")?.facts?.charts ?? [];
    replace(
      charts,
      ...all.map((chart) =>
        h(
          "button",
          { className: `ghost chart ${store.get("chart") === chart.id ? "chosen" : ""}`, "data-chart": String(chart.id), onclick: () => store.set("chart", store.get("chart") === chart.id ? -1 : chart.id) },
          h("span", { className: "name" }, `${chart.kind === "disc" ? "Cap" : "Tube"} ${chart.id}`),
          h("span", { className: "time" }, `${readable(chart.columns)} × ${readable(chart.rows)}`),
        ),
      ),
      all.length === 0 && h("p", { className: "empty" }, "Charts appear with the first suggestion."),
    );
  });
  const panel = h(
    "div", { className: "design" },
    h("section", {},
      h("h3", {}, "Where limbs end"),
      h("label", { className: "field" }, h("span", {}, "Up"), axis),
      h("label", { className: "field" }, h("span", {}, "Ignore limbs below"), persistence, shown),
      h("button", { className: "primary wide", id: "suggest", onclick: suggest }, "Suggest a design"),
      h("p", { className: "note" }, "Finds the ends of the limbs, cuts the surface between them and fills it with quads."),
    ),
    h("section", {}, h("h3", {}, "How many quads"), h("div", { className: "field" }, number, slider)),
    h("section", {}, h("h3", {}, "Charts"), charts),
  );
  store.watch(["state"], () => {
    const target = store.get("state")?.facts?.target_quads;
    if (!target || document.activeElement === number || document.activeElement === slider) return;
    number.value = String(target);
    slider.value = String(Math.log10(target));
  });
  store.watch(["state"], () => panel.classList.toggle("idle", !store.get("state")?.file));
  return panel;
}
