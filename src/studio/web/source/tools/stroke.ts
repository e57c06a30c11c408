// SPDX-License-Identifier: GPL-3.0-or-later
import * as THREE from "three";
import type { Workbench } from "../workbench";
import type { GuideFacts, Vector } from "../net/messages";
import { Lines } from "../scene/lines";
import { h, icon } from "../ui/dom";
import { icons } from "../ui/icons";
import { filePoint, pick } from "./pick";
import type { Tool } from "./tool";

const colour = 0xb45fd0;
const leastStep = 4; // pixels between two points of a stroke
const closes = 14; // pixels from its beginning within which a stroke is closed
const smoothings = 3;

const ways = [["nearer", "Nearest"], ["level", "Rows"], ["flow", "Columns"]] as const;

/** Draws guides: strokes on the surface that quads follow. */
export class StrokeTool implements Tool {
  readonly id = "guide";
  readonly name = "Guides";
  readonly key = "u";
  readonly icon = icons.guide;
  private readonly stroke = new Lines(4, colour, { hidden: true });
  private readonly others = new Lines(3, colour);
  private points: THREE.Vector3[] = [];
  private places: { x: number; y: number }[] = [];
  private strength = 1;
  private way: (typeof ways)[number][0] = "nearer";
  private readonly hidden = new Set<number>();

  constructor(private readonly app: Workbench) {
    this.stroke.object.renderOrder = this.others.object.renderOrder = 8;
    app.viewport.scene.add(this.stroke.object, this.others.object);
  }

  hint(): string {
    return "Draw a stroke on the surface: quads come onto it. Where it ends near its beginning, it is closed.";
  }
  begin(): void {
    this.showBox();
  }
  end(): void {
    this.abandon();
    this.app.tools.setBox(null);
  }
  refresh(): void {
    this.showGuides();
    if (this.app.store.get("tool") === this.id) this.showBox();
  }

  press(event: PointerEvent): boolean {
    this.abandon();
    return this.add(event);
  }
  drag(event: PointerEvent): void {
    this.add(event);
    this.show(this.stroke, [this.points]);
  }
  release(event: PointerEvent): void {
    this.add(event);
    const first = this.places[0], last = this.places.at(-1);
    const closed = this.points.length > 8 && Math.hypot(last!.x - first!.x, last!.y - first!.y) < closes;
    const points = this.smooth(closed).map((p) => filePoint(this.app, p));
    this.abandon();
    if (points.length > 1) void this.app.edit({ edit: "add_guide", points, closed, strength: this.strength, way: this.way });
  }
  abandon(): void {
    this.points = [];
    this.places = [];
    this.show(this.stroke, []);
  }

  /** Takes the place under the pointer into the stroke, if it is one and far enough from the last. */
  private add(event: PointerEvent): boolean {
    const last = this.places.at(-1);
    if (last && Math.hypot(event.clientX - last.x, event.clientY - last.y) < leastStep) return false;
    const hit = pick(this.app, event, "surface");
    if (!hit) return false;
    this.points.push(hit.point);
    this.places.push({ x: event.clientX, y: event.clientY });
    return true;
  }

  /** A hand trembles: each point goes towards the middle of its neighbours; the ends of an open stroke stay. */
  private smooth(closed: boolean): THREE.Vector3[] {
    let points = this.points;
    const n = points.length;
    for (let i = 0; i < smoothings; ++i)
      points = points.map((p, k) => {
        if (!closed && (k === 0 || k === n - 1)) return p;
        const middle = points[(k + n - 1) % n]!.clone().add(points[(k + 1) % n]!).multiplyScalar(0.5);
        return p.clone().lerp(middle, 0.5);
      });
    return points;
  }

  private get guides(): GuideFacts[] {
    return this.app.store.get("state")?.facts?.guides ?? [];
  }

  private showGuides(): void {
    const shown = this.guides.filter((_, i) => !this.hidden.has(i));
    this.show(this.others, shown.map(({ points, closed }) => [...points, ...(closed ? points.slice(0, 1) : [])].map((p) => new THREE.Vector3(...p))));
  }

  private show(lines: Lines, polylines: THREE.Vector3[][]): void {
    const pairs = polylines.flatMap((points) => points.slice(1).flatMap((p, i) => [...points[i]!.toArray(), ...p.toArray()]));
    lines.set(new Float32Array(pairs));
    lines.show(true);
    this.app.viewport.invalidate();
  }

  private showBox(): void {
    const percent = h("output", {}, `${Math.round(100 * this.strength)} %`);
    const strength = h("input", { type: "range", min: "5", max: "100", step: "5", value: String(100 * this.strength), id: "guide-strength", "aria-label": "Strength" });
    strength.oninput = () => {
      this.strength = strength.valueAsNumber / 100;
      percent.textContent = `${strength.value} %`;
    };
    const choice = (way: (typeof ways)[number][0], name: string): HTMLElement =>
      h("button", { className: `small ${this.way === way ? "on" : ""}`, role: "radio", "aria-checked": String(this.way === way), "data-way": way, onclick: () => ((this.way = way), this.showBox()) }, name);
    this.app.tools.setBox(
      h(
        "div", { className: "tool-box" }, h("strong", {}, "Guides"),
        h("label", { className: "row" }, "Strength", strength, percent),
        h("div", { className: "row", role: "radiogroup", "aria-label": "What follows the stroke" }, ...ways.map(([way, name]) => choice(way, name))),
        ...this.guides.map((guide, i) => this.row(guide, i)),
        h("p", { className: "note" }, "At full strength vertices of quads lie on the stroke once the quads are relaxed; a closed one becomes a contour where it can."),
      ),
    );
  }

  /** A guide in the list: whether it is seen, its strength, and its end. */
  private row(guide: GuideFacts, i: number): HTMLElement {
    const at = { point: this.inFile(guide.points[guide.points.length >> 1]!) };
    const seen = h("input", { type: "checkbox", checked: !this.hidden.has(i), "aria-label": `Show guide ${i + 1}` });
    seen.onchange = () => {
      if (seen.checked) this.hidden.delete(i);
      else this.hidden.add(i);
      this.showGuides();
    };
    const strength = h("input", { type: "range", min: "5", max: "100", step: "5", value: String(100 * guide.strength), "aria-label": `Strength of guide ${i + 1}` });
    strength.onchange = () => void this.app.edit({ edit: "move_guide", at, strength: strength.valueAsNumber / 100 });
    return h(
      "div", { className: "row", "data-guide": String(i) }, seen, `${i + 1}${guide.contour ? ", contour" : guide.closed ? ", closed" : ""}`, strength,
      h("button", { className: "small", "aria-label": `Delete guide ${i + 1}`, title: "Delete", onclick: () => void this.app.edit({ edit: "remove_guide", at }) }, icon(icons.remove)),
    );
  }

  private inFile(p: Vector): Vector {
    return filePoint(this.app, new THREE.Vector3(...p));
  }
}
