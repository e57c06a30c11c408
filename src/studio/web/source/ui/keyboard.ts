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
  const parts = keys === "+" ? [keys] : keys.split("+");
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

/** As it stands on the keys. */
function printed(keys: string): string {
  return keys === "-" ? "−" : keys.replace(/(^|\+)[a-z]$/, (key) => key.toUpperCase());
}

/** Keys or gestures and what they do. */
export type KeyNotes = [string, string][];

const gestures: Record<string, KeyNotes> = {
  Mouse: [["drag", "turn"], ["right drag, Shift + drag", "move"], ["wheel", "zoom to the pointer"], ["double click", "turn around that point"]],
  Touchpad: [["pinch, two fingers", "zoom to the pointer"], ["two fingers sideways", "move"], ["Shift + two fingers", "move"]],
  "In the view": [["arrows", "move"], ["Shift + arrows", "turn"], ["Space", "click in the middle"]],
};

/** The map of all keys; `notes` are those that are not for every moment. */
export function keyboardHelp(shortcuts: Shortcut[], notes: Record<string, KeyNotes> = {}): () => void {
  const groups = [...new Set(shortcuts.map((s) => s.group))];
  const section = (title: string, rows: KeyNotes): HTMLElement => h("section", {}, h("h3", {}, title), ...rows.map(([keys, does]) => h("div", {}, h("kbd", {}, keys), h("span", {}, does))));
  const dialog = h(
    "dialog", { className: "dialog keys" },
    h("header", {}, h("h2", {}, "Keys and mouse"), h("button", { className: "ghost", onclick: () => dialog.close() }, "Close")),
    h(
      "div", { className: "key-columns" },
      ...Object.entries(gestures).map(([title, rows]) => section(title, rows)),
      ...groups.map((group) => section(group, shortcuts.filter((s) => s.group === group).map((s) => [printed(s.keys), s.about]))),
      ...Object.entries(notes).map(([title, rows]) => section(title, rows)),
    ),
  );
  document.body.append(dialog);
  return () => (dialog.open ? dialog.close() : dialog.showModal());
}
