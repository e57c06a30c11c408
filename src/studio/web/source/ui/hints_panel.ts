// SPDX-License-Identifier: GPL-3.0-or-later
import type { App } from "../app";
import type { State } from "../net/messages";
import { h, replace } from "./dom";

interface Advice {
  text: string;
  name: string;
  run: () => void;
}

/** What could be better, each with a button that shows it or does it. */
export function hintsPanel(app: App): HTMLElement {
  const list = h("div", { className: "hint-list" });
  app.store.watch(["state"], () => {
    const state = app.store.get("state");
    const advice = state?.statistics ? advices(app, state) : [];
    replace(
      list,
      ...advice.slice(0, 8).map((a) => h("div", { className: "hint" }, h("span", {}, a.text), h("button", { className: "small", onclick: a.run }, a.name))),
      advice.length === 0 && h("p", { className: "empty" }, state?.statistics ? "Nothing to improve that we know of." : "Hints appear with the first design."),
    );
  });
  return list;
}

function advices(app: App, state: State): Advice[] {
  const list: Advice[] = [];
  const { charts, edge_length: edge } = state.facts!;
  const choose = (id: number): void => {
    app.setView("atlas");
    app.store.set("chart", id);
    const point = app.stage.surface.insideOf(id);
    if (point) app.viewport.focus(point);
  };
  for (const chart of charts)
    if (chart.kind === "annulus" && chart.height < 0.6 * edge)
      list.push({ text: `Tube ${chart.id} is thinner than a quad: its rows are squeezed. Collapse it, or align the saddles on its two sides.`, name: "Show", run: () => choose(chart.id) });
  const folded = state.statistics!.inverted_quads;
  if (folded > 0)
    list.push({ text: `${folded} ${folded === 1 ? "quad is" : "quads are"} folded. More quads, or another contour there, may help.`, name: "Show", run: () => app.lightQuads((q) => q <= 0) });
  const halves = app.stage.critical.filter((c) => c.kind === 3).length;
  const sixes = state.budget?.interior["6"] ?? 0;
  if (halves > 0 && sixes > 0)
    list.push({ text: "Between half-saddles, a cap whose corners lie on them makes them regular.", name: "Make regular", run: () => app.tools.choose("saddle") });
  const eights = state.budget?.interior["8"] ?? 0;
  if (eights > 0)
    list.push({ text: `${eights} ${eights === 1 ? "vertex has" : "vertices have"} valence 8. Split saddles spread that over more vertices.`, name: "Split", run: () => app.tools.choose("saddle") });
  for (const chart of charts)
    if (chart.kind === "annulus" && chart.rows > 0 && chart.height / chart.rows > 2.2 * edge)
      list.push({ text: `The quads of tube ${chart.id} are long. Give it more rows.`, name: "Show", run: () => choose(chart.id) });
  return list;
}
