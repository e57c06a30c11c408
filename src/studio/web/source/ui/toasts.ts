// SPDX-License-Identifier: GPL-3.0-or-later
// Short messages: what happened, where, and what to do about it.
import { h, icon } from "./dom";
import { icons } from "./icons";

export type Mood = "good" | "plain" | "bad";

export class Toasts {
  readonly element = h("div", { className: "toasts", role: "status", "aria-live": "polite" });

  /** `gone` is called when the message goes away. Returns what is shown, to which more can be added. */
  show(title: string, text = "", mood: Mood = "plain", action?: { name: string; run: () => void }, gone?: () => void): HTMLElement {
    const close = h("button", { className: "ghost small", title: "Dismiss", "aria-label": "Dismiss" }, icon(icons.close));
    const toast = h(
      "div", { className: `toast ${mood}` },
      h("div", { className: "toast-text" }, h("strong", {}, title), text && h("p", {}, text)),
      action && h("button", { className: "small", onclick: action.run }, action.name),
      close,
    );
    const remove = (): void => {
      toast.remove();
      gone?.();
    };
    close.onclick = remove;
    this.element.append(toast);
    while (this.element.children.length > 4) this.element.firstElementChild?.remove();
    // Who points at a message, or has come to it with the keyboard, still reads it.
    const leave = (): void => {
      if (toast.matches(":hover, :focus-within")) setTimeout(leave, 1000);
      else remove();
    };
    setTimeout(leave, mood === "bad" ? 14000 : 5000);
    return toast;
  }

  /** Takes away what was told to have failed: something has worked since. */
  forgive(): void {
    for (const toast of this.element.querySelectorAll(".toast.bad")) toast.remove();
  }
}
