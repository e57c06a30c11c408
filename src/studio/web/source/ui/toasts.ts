// SPDX-License-Identifier: GPL-3.0-or-later
// Short messages: what happened, where, and what to do about it.
import { h, icon } from "./dom";
import { icons } from "./icons";

export type Mood = "good" | "plain" | "bad";

export class Toasts {
  private readonly host = h("div", { className: "toasts", role: "status", "aria-live": "polite" });

  constructor(parent: HTMLElement) {
    parent.append(this.host);
  }

  show(title: string, text = "", mood: Mood = "plain", action?: { name: string; run: () => void }): void {
    const close = h("button", { className: "ghost small", title: "Dismiss", "aria-label": "Dismiss" }, icon(icons.close));
    const toast = h(
      "div", { className: `toast ${mood}` },
      h("div", { className: "toast-text" }, h("strong", {}, title), text && h("p", {}, text)),
      action && h("button", { className: "small", onclick: () => (action.run(), toast.remove()) }, action.name),
      close,
    );
    close.onclick = () => toast.remove();
    this.host.append(toast);
    while (this.host.children.length > 4) this.host.firstElementChild?.remove();
    setTimeout(() => toast.remove(), mood === "bad" ? 14000 : 5000);
  }

  /** Takes away what was told to have failed: something has worked since. */
  forgive(): void {
    for (const toast of this.host.querySelectorAll(".toast.bad")) toast.remove();
  }
}
