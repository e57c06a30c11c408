// SPDX-License-Identifier: GPL-3.0-or-later
import { h } from "./dom";
import type { Preferences } from "./preferences";

const least = 0.2, most = 0.75, stride = 0.04;
/** Narrower than this the view of a chart lies below the model. */
const stackedBelow = 560;

/** The bar between the model and the view of a chart, which it stands before in `host`: dragged by the pointer, or moved by arrows. */
export function splitBar(host: HTMLElement, preferences: Preferences): HTMLElement {
  const bar = h("div", { className: "split", role: "separator", tabIndex: 0, hidden: true, "aria-label": "How much room the chart has", title: "Drag, or arrows: more room for the model or for the chart" });
  const isStacked = (): boolean => host.classList.contains("stacked");
  const set = (part: number): void => preferences.set("split", Math.min(Math.max(part, least), most));
  preferences.watch(() => {
    const part = preferences.get("split");
    host.style.setProperty("--split", String(part));
    bar.setAttribute("aria-valuenow", String(Math.round(100 * part)));
  });
  new ResizeObserver(() => {
    host.classList.toggle("stacked", host.clientWidth < stackedBelow);
    bar.setAttribute("aria-orientation", isStacked() ? "horizontal" : "vertical");
  }).observe(host);
  bar.onpointerdown = (event) => {
    bar.setPointerCapture(event.pointerId);
    event.preventDefault();
  };
  bar.onpointermove = (event) => {
    if (!bar.hasPointerCapture(event.pointerId)) return;
    const box = host.getBoundingClientRect();
    set(isStacked() ? (box.bottom - event.clientY) / box.height : (box.right - event.clientX) / box.width);
  };
  bar.onkeydown = (event) => {
    const more = isStacked() ? "ArrowUp" : "ArrowLeft", less = isStacked() ? "ArrowDown" : "ArrowRight";
    if (event.key !== more && event.key !== less) return;
    event.preventDefault();
    event.stopPropagation();
    set(preferences.get("split") + (event.key === more ? stride : -stride));
  };
  return bar;
}
