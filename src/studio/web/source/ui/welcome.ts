// SPDX-License-Identifier: GPL-3.0-or-later
import type { Store } from "../store";
import { h, icon, replace } from "./dom";
import { icons } from "./icons";

/** What stands in the middle while nothing is open. */
export function welcome(store: Store, open: () => void, restore: () => void): HTMLElement {
  const host = h("div", { className: "welcome" });
  store.watch(["state", "busy"], () => {
    const state = store.get("state");
    host.hidden = !state || Boolean(state.file) || Boolean(store.get("busy"));
    const last = state?.last_session;
    replace(
      host,
      h("h1", {}, "From a surface to quads"),
      h("p", {}, "Open a triangle mesh, accept the suggested design or make your own, and export a mesh of quads only."),
      h("button", { className: "primary large", onclick: open }, icon(icons.open), "Open a mesh"),
      last && h("button", { className: "large", id: "restore", onclick: restore }, icon(icons.undo), `Go on with ${last.name} (${last.edits} ${last.edits === 1 ? "edit" : "edits"})`),
      h("p", { className: "note" }, "or drop a file here"),
    );
  });
  return host;
}
