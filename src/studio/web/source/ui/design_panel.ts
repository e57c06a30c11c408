// SPDX-License-Identifier: GPL-3.0-or-later
import type { Edit } from "../net/messages";
import type { Store } from "../store";
import { h, readable, replace } from "./dom";
import { numberField } from "./number_field";
import { question } from "./question";
import { chartName } from "./words";

const axes: [string, [number, number, number]][] = [["X", [1, 0, 0]], ["Y", [0, 1, 0]], ["Z", [0, 0, 1]]];
const fewest = 50, most = 1000000;

/** Edits that a suggestion does not throw away anything of. */
const givenAnyway = new Set(["suggest", "set_target"]);

/** The suggestion, the number of quads and the charts. */
export function designPanel(store: Store, edit: (edit: Edit) => void, refuse: (sentence: string) => void): HTMLElement {
  const panel = h("div", { className: "design" }, limbs(store, edit), count(store, edit, refuse), h("section", {}, h("h3", {}, "Charts"), charts(store)));
  // Without a mesh neither pointer nor keys reach it, and readers pass it over.
  store.watch(["state"], () => {
    panel.inert = !store.get("state")?.file;
    panel.ariaDisabled = String(panel.inert);
    panel.classList.toggle("idle", panel.inert);
  });
  return panel;
}

function limbs(store: Store, edit: (edit: Edit) => void): HTMLElement {
  const persistence = h("input", { type: "range", min: "0.01", max: "0.3", step: "0.01", value: "0.08", id: "persistence" });
  const shown = h("output", {}, "8 %");
  persistence.oninput = () => (shown.textContent = `${Math.round(100 * persistence.valueAsNumber)} %`);
  const axis = h("select", { id: "axis" }, ...axes.map(([name], i) => h("option", { value: String(i), selected: i === 1 }, `${name} is up`)));
  axis.onchange = () => store.set("up", axes[Number(axis.value)]![1]);
  const suggest = async (): Promise<void> => {
    const state = store.get("state"), own = (state?.history ?? []).slice(0, state?.applied).filter((step) => !givenAnyway.has(step.edit.edit)).length;
    const text = `A suggestion makes all contours anew: ${own} ${own === 1 ? "step" : "steps"} of yours would be gone from the design. Undo brings them back.`;
    if (own > 0 && (await question("Suggest another design?", text, [{ id: "suggest", name: "Suggest", primary: true }])) === null) return;
    edit({ edit: "suggest", persistence: persistence.valueAsNumber, axis: axes[Number(axis.value)]![1] });
  };
  return h(
    "section", {}, h("h3", {}, "Where limbs end"),
    h("label", { className: "field" }, h("span", {}, "Up"), axis),
    h("label", { className: "field" }, h("span", {}, "Ignore limbs below"), persistence, shown),
    h("button", { className: "primary wide", id: "suggest", onclick: () => void suggest() }, "Suggest a design"),
    h("p", { className: "note" }, "Finds the ends of the limbs, cuts the surface between them and fills it with quads. Or put them there by hand with the tool “Extrema”."),
  );
}

function count(store: Store, edit: (edit: Edit) => void, refuse: (sentence: string) => void): HTMLElement {
  const slider = h("input", { type: "range", min: "2", max: "5", step: "0.02", value: "3.477", "aria-label": "Number of quads, coarse" });
  const setTarget = (quads: number): void => {
    slider.value = String(Math.log10(quads));
    edit({ edit: "set_target", quads });
  };
  const number = numberField({ id: "quads", label: "The number of quads", min: fewest, max: most, step: 50, value: 3000 }, setTarget, refuse);
  const fromSlider = (): number => 10 * Math.round(10 ** slider.valueAsNumber / 10);
  slider.oninput = () => (number.element.value = String(fromSlider()));
  slider.onchange = () => {
    number.show(fromSlider());
    setTarget(fromSlider());
  };
  const note = h("p", { className: "note", id: "quads-now" });
  store.watch(["state"], () => {
    const state = store.get("state"), target = state?.facts?.target_quads, quads = state?.statistics?.quads;
    note.textContent = quads ? `There are ${readable(quads)}. Enter asks for the number, also once more.` : "Enter asks for the number.";
    if (!target) return;
    number.show(target);
    if (document.activeElement !== slider) slider.value = String(Math.log10(target));
  });
  return h("section", {}, h("h3", {}, "How many quads"), h("div", { className: "field" }, number.element, slider), note);
}

function charts(store: Store): HTMLElement {
  const list = h("div", { className: "chart-list" });
  store.watch(["state", "chart"], () => {
    const all = store.get("state")?.facts?.charts ?? [];
    replace(
      list,
      ...all.map((chart) =>
        h(
          "button",
          { className: `ghost chart ${store.get("chart") === chart.id ? "chosen" : ""}`, "data-chart": String(chart.id), "aria-pressed": String(store.get("chart") === chart.id), onclick: () => store.set("chart", store.get("chart") === chart.id ? -1 : chart.id) },
          h("span", { className: "name" }, chartName(chart)),
          h("span", { className: "time" }, `${readable(chart.columns)} × ${readable(chart.rows)}`),
        ),
      ),
      all.length === 0 && h("p", { className: "empty" }, "Charts appear with the first design."),
    );
  });
  return list;
}
