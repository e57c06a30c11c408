// SPDX-License-Identifier: GPL-3.0-or-later
// The meshes that were worked on, as cards: a picture, the name, how many edits, and when.
import type { SavedSession } from "../net/messages";
import { h, icon } from "./dom";
import { icons } from "./icons";

/** A card for each session; `current` is the digest of the mesh that is open. */
export function sessionCards(
  sessions: readonly SavedSession[], restore: (digest: string) => void, forget?: (session: SavedSession) => void, current = "",
): HTMLElement {
  return h(
    "div", { className: "cards", role: "list" },
    ...sessions.map((session) => {
      const edits = `${session.edits} ${session.edits === 1 ? "edit" : "edits"}`;
      const open = session.digest === current;
      return h(
        "div", { className: "card-host", role: "listitem" },
        h(
          "button", { className: `card ${open ? "chosen" : ""}`, "data-session": session.digest, title: open ? "This one is open" : `Go on with ${session.name}`, disabled: open, onclick: () => restore(session.digest) },
          session.picture ? h("img", { src: session.picture, alt: "", className: "thumbnail" }) : h("span", { className: "thumbnail none" }, icon(icons.texture)),
          h("span", { className: "name" }, session.name), h("span", { className: "time" }, open ? `${edits} · open` : `${edits} · ${when(session.saved)}`),
        ),
        forget && !open && h("button", { className: "ghost small forget", title: `Forget the work on ${session.name}`, "aria-label": `Forget the work on ${session.name}`, onclick: () => forget(session) }, icon(icons.close)),
      );
    }),
  );
}

/** A time as people say it; seconds since 1970. */
export function when(seconds: number, now = Date.now() / 1000): string {
  const past = Math.max(now - seconds, 0), date = new Date(1000 * seconds);
  if (past < 60) return "just now";
  if (past < 3600) return `${Math.floor(past / 60)} min ago`;
  const clock = date.toLocaleTimeString("en-GB", { hour: "2-digit", minute: "2-digit" });
  if (date.toDateString() === new Date(1000 * now).toDateString()) return `today ${clock}`;
  return date.toLocaleDateString("en-GB", { day: "numeric", month: "short", ...(past > 3e7 ? { year: "numeric" } : {}) });
}
