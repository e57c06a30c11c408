// SPDX-License-Identifier: GPL-3.0-or-later
// Keys and what they do; the same list makes them work and explains them.
import { h } from "./dom";

export interface Shortcut {
  keys: string; // "Ctrl+Z", "p", "?"
  about: string;
  group: string;
  run: () => void;
}

function matches(event: KeyboardEvent, keys: string): boolean {
  const parts = keys.split("+");
  const key = parts[parts.length - 1]!;
  const control = parts.includes("Ctrl"), shift = parts.includes("Shift");
  if (control !== (event.ctrlKey || event.metaKey) || event.altKey) return false;
  if (key.length > 1 || /[a-z0-9]/i.test(key)) {
    if (shift !== event.shiftKey) return false;
  }
  return event.key.toLowerCase() === key.toLowerCase();
}

export function listenToKeys(shortcuts: Shortcut[]): void {
  window.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement;
    if (target.matches("input:not([type=range]), textarea, select") || document.querySelector("dialog[open]")) return;
    const shortcut = shortcuts.find((s) => matches(event, s.keys));
    if (!shortcut) return;
    event.preventDefault();
    shortcut.run();
  });
}

/** The map of all keys. */
export function keyboardHelp(shortcuts: Shortcut[]): () => void {
  const groups = [...new Set(shortcuts.map((s) => s.group))];
  const mouse: [string, string][] = [
    ["drag", "turn"], ["right drag, or Shift + drag", "move"], ["wheel, or pinch", "zoom to the pointer"], ["double click", "turn around that point"],
  ];
  const dialog = h(
    "dialog", { className: "dialog keys" },
    h("header", {}, h("h2", {}, "Keys and mouse"), h("button", { className: "ghost", onclick: () => dialog.close() }, "Close")),
    h(
      "div", { className: "key-columns" },
      h("section", {}, h("h3", {}, "Mouse"), ...mouse.map(([what, does]) => h("div", {}, h("kbd", {}, what), h("span", {}, does)))),
      ...groups.map((group) =>
        h("section", {}, h("h3", {}, group), ...shortcuts.filter((s) => s.group === group).map((s) => h("div", {}, h("kbd", {}, s.keys.length === 1 ? s.keys.toUpperCase() : s.keys), h("span", {}, s.about)))),
      ),
    ),
  );
  document.body.append(dialog);
  return () => (dialog.open ? dialog.close() : dialog.showModal());
}
