// SPDX-License-Identifier: GPL-3.0-or-later
import type { Shading } from "../scene/normals";
import type { Direction } from "../scene/viewport";
import { h, icon } from "./dom";
import { icons } from "./icons";
import type { Preferences } from "./preferences";

/** What the menu does with the camera. */
export interface CameraActions {
  look(from: Direction): void;
  everything(): void;
  selection(): void;
}

const shadings: [Shading, string, string][] = [
  ["smooth", "Smooth", "As if there were no edges"], ["crease", "Creases", "Smooth, but for edges of more than 40 degrees"], ["flat", "Flat", "Each face for itself"],
];

/** The button of the menu, which is open until something else is clicked, or Escape. */
export function displayMenu(preferences: Preferences, camera: CameraActions): HTMLElement[] {
  const radios = shadings.map(([id, name, about]) => h("button", { className: "small", role: "radio", title: about, "data-shading": id, onclick: () => preferences.set("shading", id) }, name));
  const parallel = h("button", { className: "small", role: "switch", id: "orthographic", title: "Parallel lines stay parallel (O)", onclick: () => preferences.set("orthographic", !preferences.get("orthographic")) }, "Orthographic");
  const action = (name: string, id: string, title: string, run: () => void): HTMLElement => h("button", { className: "small", id, title, onclick: run }, name);
  const menu = h(
    "div", { className: "menu", popover: "auto", role: "group", "aria-label": "Display" },
    h("h3", {}, "Shading"), h("div", { className: "row", role: "radiogroup", "aria-label": "Shading" }, ...radios),
    h("h3", {}, "Look from"),
    h("div", { className: "row" }, action("Front", "look-front", "Look from the front", () => camera.look("front")), action("Side", "look-side", "Look from the side", () => camera.look("side")), action("Top", "look-top", "Look from above", () => camera.look("top")), parallel),
    h("h3", {}, "Frame"),
    h("div", { className: "row" }, action("Everything", "frame-all", "See everything (H)", () => camera.everything()), action("Chosen chart", "frame-chart", "See the chosen chart (.)", () => camera.selection())),
  );
  preferences.watch(() => {
    for (const radio of radios) {
      const on = radio.dataset.shading === preferences.get("shading");
      radio.classList.toggle("on", on);
      radio.setAttribute("aria-checked", String(on));
    }
    parallel.classList.toggle("on", preferences.get("orthographic"));
    parallel.setAttribute("aria-checked", String(preferences.get("orthographic")));
  });
  const button = h("button", { className: "ghost icon-button", id: "display", title: "Display: shading and camera", "aria-label": "Display: shading and camera", popoverTargetElement: menu }, icon(icons.eye));
  return [button, menu];
}
