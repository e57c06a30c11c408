// SPDX-License-Identifier: GPL-3.0-or-later
import type { Store, TabId } from "../store";
import { h } from "./dom";

export interface Tab {
  id: TabId;
  name: string;
  content: HTMLElement[];
  /** How many things in it wait to be seen, and what they are. */
  badge?: () => { number: number; about: string };
}

/** Panels of which one is seen; arrows go from one tab to the next. */
export function tabs(store: Store, all: readonly Tab[]): HTMLElement[] {
  const buttons = all.map(({ id, name }) => {
    const badge = h("span", { className: "badge", hidden: true });
    return h("button", { className: "tab", role: "tab", id: `tab-${id}`, "data-tab": id, "aria-controls": `panel-${id}`, onclick: () => store.set("tab", id) }, name, badge);
  });
  const panels = all.map(({ id, content }) => h("div", { className: "tab-panel", role: "tabpanel", id: `panel-${id}`, "aria-labelledby": `tab-${id}` }, ...content));
  store.watch(["tab"], () =>
    all.forEach(({ id }, i) => {
      const on = id === store.get("tab");
      buttons[i]!.setAttribute("aria-selected", String(on));
      buttons[i]!.tabIndex = on ? 0 : -1;
      panels[i]!.hidden = !on;
    }),
  );
  store.watch(["state", "deviation", "hints"], () =>
    all.forEach(({ badge }, i) => {
      const sign = buttons[i]!.querySelector<HTMLElement>(".badge")!, { number, about } = badge?.() ?? { number: 0, about: "" };
      sign.hidden = number === 0;
      sign.textContent = number > 99 ? "99+" : String(number);
      sign.title = about;
    }),
  );
  const list = h("div", { className: "tabs", role: "tablist", "aria-label": "Panels" }, ...buttons);
  list.onkeydown = (event) => {
    const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? all.length - 1 : 0, at = all.findIndex(({ id }) => id === store.get("tab"));
    if (by === 0) return;
    const next = (at + by) % all.length;
    event.preventDefault();
    event.stopPropagation();
    store.set("tab", all[next]!.id);
    buttons[next]!.focus();
  };
  return [list, ...panels];
}
