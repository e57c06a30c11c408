// SPDX-License-Identifier: GPL-3.0-or-later
// A number that is typed: Enter sends it, also the same once more; leaving the field or Escape brings back what was there, so that undoing
// what was typed never changes a design.
import { h } from "./dom";

export interface NumberField {
  element: HTMLInputElement;
  /** The number as it is; what is being typed stays. */
  show(value: number): void;
}

/** `refuse` is told, with a sentence, what is no number between the limits. */
export function numberField(
  options: { id: string; label: string; min: number; max: number; step: number; value: number }, send: (value: number) => void, refuse: (sentence: string) => void,
): NumberField {
  const { min, max, step, label } = options;
  let value = options.value;
  const element = h("input", { type: "number", id: options.id, min: String(min), max: String(max), step: String(step), value: String(value), "aria-label": label });
  element.onkeydown = (event) => {
    if (event.key === "Escape") element.value = String(value);
    if (event.key !== "Enter") return;
    event.preventDefault();
    const typed = element.valueAsNumber, fits = Number.isFinite(typed) && typed >= min && typed <= max;
    element.setAttribute("aria-invalid", String(!fits));
    if (!fits) return refuse(`${label} lies between ${min} and ${max.toLocaleString("en").replace(/,/g, "\u202f")}.`);
    value = typed;
    send(typed);
  };
  element.onblur = () => {
    element.value = String(value);
    element.removeAttribute("aria-invalid");
  };
  return {
    element,
    show: (now) => {
      const isTyping = document.activeElement === element && element.valueAsNumber !== value;
      value = now;
      if (!isTyping) element.value = String(now);
    },
  };
}
