// SPDX-License-Identifier: GPL-3.0-or-later
import type { Store } from "../store";
import { h, replace } from "./dom";

/** The edits so far; a click goes back or forward to one. */
export function historyPanel(store: Store, goTo: (step: number) => void): HTMLElement {
  const list = h("ol", { className: "history" });
  store.watch(["state"], () => {
    const state = store.get("state");
    const applied = state?.applied ?? 0;
    const entry = (step: number, text: string, milliseconds?: number): HTMLElement =>
      h(
        "li", { className: step === applied ? "now" : step > applied ? "undone" : "" },
        h(
          "button", { className: "ghost", onclick: () => goTo(step), "data-step": String(step), title: "Go to this step" },
          h("span", { className: "name" }, text),
          milliseconds !== undefined && milliseconds > 0 && h("span", { className: "time" }, time(milliseconds)),
        ),
      );
    if (!state?.file) return replace(list, h("li", { className: "empty" }, "Open a mesh to begin."));
    replace(list, entry(0, `Opened ${state.file.name}`), ...(state.history ?? []).map((s, i) => entry(i + 1, s.text, s.milliseconds)));
    const now = list.querySelector<HTMLElement>(".now");
    if (now) list.scrollTop = now.offsetTop - list.offsetTop - list.clientHeight / 2;
  });
  return list;
}

export function time(milliseconds: number): string {
  return milliseconds >= 1000 ? `${(milliseconds / 1000).toFixed(1)} s` : `${Math.round(milliseconds)} ms`;
}
