// SPDX-License-Identifier: GPL-3.0-or-later
import type { Store } from "../store";
import { h } from "./dom";

/** The bar that shows what the program is doing, once that has taken a moment, and stops it. */
export function progressBar(store: Store, cancel: () => void): HTMLElement {
  const text = h("span", {}), fill = h("div", { className: "fill" });
  const box = h(
    "div", { className: "progress", hidden: true, role: "progressbar" },
    h("div", { className: "progress-text" }, text, h("button", { className: "small", onclick: cancel }, "Cancel")),
    h("div", { className: "track" }, fill),
  );
  let timer = 0;
  store.watch(["busy"], () => {
    const busy = store.get("busy");
    if (!busy) {
      clearTimeout(timer);
      timer = 0;
      box.hidden = true;
      return;
    }
    text.textContent = busy.stage;
    fill.style.width = `${100 * busy.fraction}%`;
    box.setAttribute("aria-valuenow", String(Math.round(100 * busy.fraction)));
    if (!timer) timer = window.setTimeout(() => (box.hidden = false), 250);
  });
  return box;
}
