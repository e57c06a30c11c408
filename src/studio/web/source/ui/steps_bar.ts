// SPDX-License-Identifier: GPL-3.0-or-later
// The way from a mesh to quads in six steps: each has its view, its tools and a sentence that says what to do next.
import type { State } from "../net/messages";
import { views, type ViewId } from "../scene/layers";
import type { Store } from "../store";
import { h } from "./dom";

interface Step {
  name: string;
  about: string;
  /** Its tools, by their ids. */
  tools: string[];
  /** What there is to do in it. */
  todo: string;
}

/** The steps by the view that belongs to them, in their order. */
export const steps: Record<ViewId, Step> = {
  surface: { name: "Mesh", about: "What came in", tools: [], todo: "Drag to turn it. What is odd about it stands in the tab Check. Then go on to 2 Limbs." },
  field: { name: "Limbs", about: "Where limbs end: the field and its extrema", tools: ["extremum"], todo: "Each limb that is to have quads of its own needs an extremum at its end. Then go on to 3 Contours." },
  atlas: { name: "Contours", about: "The curves that quads follow, and the charts between them", tools: ["subdivide", "drag", "plane", "contour"], todo: "Add, move or snap contours where quads are to run along, then go on to 4 Vertices." },
  quads: { name: "Vertices", about: "Where not four edges meet", tools: ["saddle", "pole", "align", "texture"], todo: "Split or align saddles and poles, or open the texture of a chart. Then go on to 5 Quads." },
  quality: { name: "Quads", about: "How many there are, and how good they are", tools: [], todo: "Ask for the number of quads. Where they are orange, another contour helps. Then go on to 6 Check." },
  deviation: { name: "Check", about: "How far the quads are from the surface", tools: [], todo: "See what is far off or lost, and what hints there are; then export the quads." },
};

/** The step that a tool belongs to; `select` belongs to all. */
export function stepOf(tool: string): ViewId | undefined {
  return (Object.keys(steps) as ViewId[]).find((id) => steps[id].tools.includes(tool));
}

/** What to do in a step now, in a sentence. */
export function whatNext(step: ViewId, state: State | null): string {
  if (!state?.file) return "";
  if (state.statistics || step === "surface") return steps[step].todo;
  return "Press “Suggest a design”, or put a minimum and a maximum where limbs end with “Extrema”.";
}

/** Without a design there is the mesh to be seen, whatever the step. */
export function viewOf(step: ViewId, state: State | null): ViewId {
  return state?.statistics ? step : "surface";
}

/** A button for each step; `choose` is called when one is pressed. */
export function stepsBar(store: Store, choose: (step: ViewId) => void): HTMLElement {
  const buttons = (Object.keys(views) as ViewId[]).map((id, i) =>
    h("button", { className: "view", title: `${steps[id].about}. ${steps[id].todo}`, "data-view": id, onclick: () => choose(id) }, h("span", { className: "number" }, String(i + 1)), steps[id].name),
  );
  store.watch(["step", "state"], () => {
    const state = store.get("state");
    for (const button of buttons) {
      const id = button.dataset.view as ViewId, on = Boolean(state?.file) && id === store.get("step");
      button.classList.toggle("on", on);
      button.setAttribute("aria-current", on ? "step" : "false");
      button.disabled = !state?.file || (!state.statistics && id !== "surface" && id !== "field");
    }
  });
  return h("nav", { className: "views", "aria-label": "Steps" }, ...buttons);
}
