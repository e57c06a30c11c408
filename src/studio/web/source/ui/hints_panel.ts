// SPDX-License-Identifier: GPL-3.0-or-later
import * as THREE from "three";
import type { Workbench } from "../workbench";
import { RequestError } from "../net/connection";
import type { Hint, State } from "../net/messages";
import { PlaceMark } from "../scene/place_mark";
import { Preview } from "../tools/preview";
import { h, icon, replace } from "./dom";
import { icons } from "./icons";

/** Above so many triangles hints are looked for only when the user asks: it may take many seconds. */
const askedAbove = 60000;

/** Edits that are worth while, with the reason: the pointer on one shows where it is and what it would make, a click applies it. */
export class HintsPanel {
  readonly element = h("div", { className: "hint-list" });
  private readonly mark: PlaceMark;
  private readonly preview: Preview;
  private hints: Hint[] | null = null;
  private asked = -1;
  private busy = false;

  constructor(private readonly app: Workbench) {
    this.mark = new PlaceMark(app.viewport);
    this.preview = new Preview(app, () => {});
    app.store.watch(["state"], () => this.follow());
    app.store.watch(["deviation"], () => this.draw());
  }

  // Hints are of one state of the design; relaxing and certifying do not change it.
  private follow(): void {
    const state = this.app.store.get("state");
    const isNew = !state?.statistics || this.asked !== this.design(state);
    if (isNew) {
      this.hints = null;
      this.asked = -1;
      this.show(null);
    }
    this.draw();
    if (isNew && !this.busy && state?.statistics && state.finished && state.file!.triangles <= askedAbove) void this.ask(state);
  }

  /** A number that is another one after each edit. */
  private design(state: State): number {
    return (state.history ?? []).slice(0, state.applied).reduce((sum, step) => (sum * 31 + JSON.stringify(step.edit).length) % 1e9, state.applied ?? 0);
  }

  private async ask(state: State): Promise<void> {
    this.asked = this.design(state);
    this.busy = true;
    this.draw();
    try {
      this.hints = (await this.app.connection.request("hints")) as Hint[];
    } catch (error) {
      // Something else came first: looked for again when that is done.
      this.asked = -1;
      if (error instanceof RequestError && error.failure.cancelled) setTimeout(() => this.follow(), 600);
    }
    this.busy = false;
    this.draw();
  }

  private draw(): void {
    const state = this.app.store.get("state");
    this.app.store.set("hints", this.hints?.length ?? 0);
    const rows: (HTMLElement | null)[] = [];
    const folded = state?.statistics?.inverted_quads ?? 0;
    if (folded > 0)
      rows.push(h("button", { className: "ghost hint", title: "Show them", onclick: () => this.app.lightQuads((q) => q <= 0) }, h("span", {}, `${folded} ${folded === 1 ? "quad is" : "quads are"} folded. More quads, or another contour there, may help.`)));
    for (const hint of this.hints ?? []) rows.push(this.row(hint));
    if (state?.statistics && this.hints === null)
      rows.push(this.busy ? h("p", { className: "empty" }, "Looking …") : h("button", { className: "wide", id: "find-hints", onclick: () => void this.ask(state) }, "Look for hints"));
    const nothing = state?.statistics ? this.verdict() : "Hints appear with the first design.";
    replace(this.element, ...rows, rows.length === 0 && h("p", { className: "empty" }, nothing));
  }

  /** Marks the place of a hint, and shows the contours that its edit would make. */
  private show(hint: Hint | null): void {
    this.mark.show(hint && this.placeOf(hint));
    this.preview.show(hint?.edit ?? null);
  }

  private row(hint: Hint): HTMLElement {
    const place = this.placeOf(hint), show = (): void => this.show(hint), hide = (): void => this.show(null);
    const apply = h(
      "button", { className: "ghost hint", "data-hint": hint.kind, title: "Apply it", onclick: () => void this.app.edit(hint.edit), onpointerenter: show, onpointerleave: hide, onfocus: show, onblur: hide },
      h("span", {}, hint.reason), h("em", {}, hint.text),
    );
    const fly = h("button", { className: "ghost small", title: "Fly there", "aria-label": "Fly there", onclick: () => (this.mark.show(place), this.app.flyTo(place)) }, icon(icons.eye));
    return h("div", { className: "hint-row" }, apply, fly);
  }

  /** What there is to say without hints: that all is well only where the shape is kept, too. */
  private verdict(): string {
    const deviation = this.app.store.get("deviation");
    const lost = deviation && (deviation.lost_corners.length > 0 || deviation.lost_sharp_length > 0.02 * deviation.sharp_length);
    return lost ? "No hint, but sharp edges or corners are lost: the panel Deviation shows where. Snap contours there, or ask for more quads." : "Nothing to improve that we know of.";
  }

  private placeOf(hint: Hint): THREE.Vector3 {
    const [x, y, z] = this.app.store.get("state")?.file?.origin ?? [0, 0, 0];
    return new THREE.Vector3(...hint.place).sub(new THREE.Vector3(x, y, z));
  }
}
