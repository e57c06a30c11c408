// SPDX-License-Identifier: GPL-3.0-or-later
import type { Vector } from "../net/messages";
import type { Store } from "../store";
import { h, replace } from "./dom";

/** What is remarkable about the file; a click flies there, and the place is marked (or, with null, not any more). */
export function defectsPanel(store: Store, fly: (where: Vector, distance: number) => void, mark: (where: Vector | null) => void): HTMLElement {
  const list = h("div", { className: "finding-list" });
  store.watch(["state"], () => {
    const file = store.get("state")?.file;
    const defects = file?.defects ?? [];
    replace(
      list,
      ...(file?.mends ?? []).map((text) => h("p", { className: "note" }, `Mended: ${text}`)),
      ...(file?.refused ?? []).map((text) => h("p", { className: "note warn" }, `Left out: ${text}`)),
      ...defects.map((d) => h("button", { className: "ghost finding", title: "Fly there", onclick: () => fly(d.where, 0.4 * file!.diagonal), onpointerenter: () => mark(d.where), onpointerleave: () => mark(null), onfocus: () => mark(d.where), onblur: () => mark(null) }, d.text)),
      file && defects.length === 0 && h("p", { className: "empty" }, "The file is a clean surface."),
    );
  });
  return list;
}
