// SPDX-License-Identifier: GPL-3.0-or-later
import type { Store } from "../store";
import { h, icon, replace } from "./dom";
import { icons } from "./icons";

/** What stands in the middle while nothing is open. */
export function welcome(store: Store, open: () => void, restore: (digest?: string) => void): HTMLElement {
  const host = h("div", { className: "welcome" });
  store.watch(["state", "busy"], () => {
    const state = store.get("state");
    host.hidden = !state || Boolean(state.file) || Boolean(store.get("busy"));
    const last = state?.last_session, unreadable = state?.unreadable_sessions ?? [];
    const others = (state?.sessions ?? []).filter((s) => s.edits > 0 && s.name !== last?.name);
    const goOn = (name: string, edits: number) => `Go on with ${name} (${edits} ${edits === 1 ? "edit" : "edits"})`;
    replace(
      host,
      h("h1", {}, "From a surface to quads"),
      h("p", {}, "Open a triangle mesh, accept the suggested design or make your own, and export a mesh of quads only."),
      h("button", { className: "primary large", onclick: open }, icon(icons.open), "Open a mesh"),
      last && h("button", { className: "large", id: "restore", onclick: () => restore() }, icon(icons.undo), goOn(last.name, last.edits)),
      ...others.map((s) => h("button", { className: "session", onclick: () => restore(s.digest) }, goOn(s.name, s.edits))),
      unreadable.length > 0 && h("p", { className: "note" }, `Sessions that this program cannot read, kept as they are: ${unreadable.join(", ")}`),
      h("p", { className: "note" }, "or drop a file here"),
    );
  });
  return host;
}
