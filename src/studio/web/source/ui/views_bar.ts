// SPDX-License-Identifier: GPL-3.0-or-later
import { views, type LayerId, type ViewId } from "../scene/layers";
import type { Store } from "../store";
import { h } from "./dom";

export function showView(store: Store, view: ViewId): void {
  store.set("layers", new Set<LayerId>(views[view].layers));
}

/** A button for each view; the one whose layers are shown is on. */
export function viewsBar(store: Store, isPossible: (view: ViewId) => boolean): HTMLElement {
  const buttons = (Object.keys(views) as ViewId[]).map((id) =>
    h("button", { className: "view", title: views[id].about, "data-view": id, onclick: () => showView(store, id) }, views[id].name),
  );
  store.watch(["layers", "state"], () => {
    const layers = store.get("layers");
    for (const button of buttons) {
      const id = button.dataset.view as ViewId, view = views[id];
      button.classList.toggle("on", view.layers.length === layers.size && view.layers.every((l) => layers.has(l)));
      button.disabled = !isPossible(id);
    }
  });
  return h("nav", { className: "views", "aria-label": "Views" }, ...buttons);
}
