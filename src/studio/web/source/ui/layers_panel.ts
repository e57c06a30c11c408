// SPDX-License-Identifier: GPL-3.0-or-later
import { layerList, switched, type LayerId } from "../scene/layers";
import type { Store } from "../store";
import { h, replace } from "./dom";

/** The list of layers with their keys. */
export function layersPanel(store: Store, isThere: (id: LayerId) => boolean = () => true): HTMLElement {
  const list = h("div", { className: "layer-list" });
  const available = (id: LayerId): boolean => {
    const state = store.get("state");
    return isThere(id) && Boolean(id === "surface" || id === "xray" ? state?.file : state?.statistics);
  };
  store.watch(["layers", "state"], () => {
    replace(
      list,
      ...layerList.map((layer) => {
        const on = store.get("layers").has(layer.id);
        const button = h(
          "button",
          {
            className: `layer ${on ? "on" : ""}`, title: layer.about, disabled: !available(layer.id), role: "switch", "aria-checked": String(on),
            "data-layer": layer.id, onclick: () => store.set("layers", switched(store.get("layers"), layer.id)),
          },
          h("span", { className: "dot" }), h("span", { className: "name" }, layer.name), h("kbd", {}, layer.key.toUpperCase()),
        );
        return button;
      }),
    );
  });
  return list;
}
