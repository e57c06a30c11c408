// SPDX-License-Identifier: GPL-3.0-or-later
import type { Store } from "../store";
import { h, icon, replace } from "./dom";
import { icons } from "./icons";
import { sessionCards } from "./sessions";

/** What stands in the middle while nothing is open. */
export function welcome(store: Store, open: () => void, restore: (digest?: string) => void): HTMLElement {
  const host = h("div", { className: "welcome" });
  store.watch(["state", "busy"], () => {
    const state = store.get("state");
    host.hidden = !state || Boolean(state.file) || Boolean(store.get("busy"));
    const unreadable = state?.unreadable_sessions ?? [], sessions = (state?.sessions ?? []).filter((s) => s.edits > 0).slice(0, 8);
    const cards = sessions.length > 0 && sessionCards(sessions, restore);
    if (cards) cards.querySelector("button")!.id = "restore";
    replace(
      host,
      h("h1", {}, "From a surface to quads"),
      h("p", {}, "Open a triangle mesh, accept the suggested design or make your own, and export a mesh of quads only."),
      h("button", { className: "primary large", onclick: open }, icon(icons.open), "Open a mesh"),
      cards && h("h2", {}, "Go on with"),
      cards,
      unreadable.length > 0 && h("p", { className: "note" }, `Sessions that this program cannot read, kept as they are: ${unreadable.join(", ")}`),
      h("p", { className: "note" }, "or drop a mesh here"),
    );
  });
  return host;
}
