// SPDX-License-Identifier: GPL-3.0-or-later
// Edits the texture of the chart that is open, in the plane or on the surface.
import * as THREE from "three";
import type { Workbench } from "../workbench";
import type { Place, PlaceKind, PlanePoint, Texture } from "../local/texture";
import type { Edit } from "../net/messages";
import { h } from "../ui/dom";
import { icons } from "../ui/icons";
import { surfacePoint } from "./pick";
import type { Tool } from "./tool";

interface Operator {
  id: string;
  name: string;
  about: string;
  /** What is to be clicked, one after the other. */
  targets: PlaceKind[];
  hasFraction?: boolean;
}

const groups: { name: string; operators: Operator[] }[] = [
  {
    name: "Vertices",
    operators: [
      { id: "drag", name: "Drag", about: "Drag a vertex: those within the brush follow, and its neighbours are evened out.", targets: [] },
      { id: "relax", name: "Smooth", about: "Click: the vertices within the brush are evened out.", targets: ["corner"] },
      { id: "anchor", name: "Anchor", about: "Click a vertex: it stays where it is while others move. Click it again to let it go.", targets: ["corner"] },
      { id: "snap", name: "Snap", about: "Click a vertex: it goes to the nearest sharp edge.", targets: ["corner"] },
    ],
  },
  {
    name: "Strips",
    operators: [
      { id: "insert_polychord", name: "Insert", about: "Click an edge: the strip of quads across it is split along.", targets: ["edge"], hasFraction: true },
      { id: "delete_polychord", name: "Delete strip", about: "Click an edge: the strip of quads across it is taken out.", targets: ["edge"], hasFraction: true },
    ],
  },
  {
    name: "Quads",
    operators: [
      { id: "inset_quads", name: "Inset", about: "Click a quad: it becomes the face of a cube, with four quads around it.", targets: ["quad"], hasFraction: true },
      { id: "open_quad", name: "Open", about: "Click two edges that meet: a quad opens along them.", targets: ["edge", "edge"], hasFraction: true },
      { id: "close_quad", name: "Close", about: "Click the corner of a quad: it closes along its diagonal.", targets: ["corner"], hasFraction: true },
      { id: "delete_quads", name: "Hole", about: "Click a quad: it becomes a hole.", targets: ["quad"] },
      { id: "restore_quads", name: "Fill", about: "Click a hole: the quad is there again.", targets: ["quad"] },
    ],
  },
  {
    name: "Edges",
    operators: [
      { id: "rotate_edge", name: "Turn left", about: "Click an edge: it turns to the next corners of its two quads.", targets: ["edge"] },
      { id: "rotate_edge_back", name: "Turn right", about: "Click an edge: it turns to the corners before.", targets: ["edge"] },
      { id: "rotate_vertex", name: "Turn vertex", about: "Click a vertex: its edges go to the opposite corners of its quads.", targets: ["corner"] },
      { id: "insert_doublet", name: "Add doublet", about: "Click the corner of a quad: a vertex with two edges is added in it.", targets: ["corner"] },
      { id: "remove_doublet", name: "Remove doublet", about: "Click a vertex with two edges: it vanishes.", targets: ["corner"] },
    ],
  },
];

export class TextureTool implements Tool {
  readonly id = "texture";
  readonly name = "Texture";
  readonly key = "g";
  readonly icon = icons.texture;
  private operator = groups[0]!.operators[0]!;
  private picked: Place[] = [];
  private hovered: Place | null = null;
  private anchors: THREE.Vector3[] = [];
  private chart = -1;
  private brush = 1.5;
  private steps = 4;
  private fraction = 0.5;
  /** While a vertex is dragged: the texture as it was, and the name of the vertex. */
  private grabbed: { texture: Texture; name: THREE.Vector3 } | null = null;
  private moved = false;

  constructor(private readonly app: Workbench) {}

  hint(): string {
    if (!this.texture) return "Click a chart to open its texture.";
    const { targets } = this.operator;
    return (targets.length > 1 ? `${this.picked.length + 1} of ${targets.length}: ` : "") + this.operator.about;
  }

  begin(): void {
    if (!this.app.store.get("layers").has("surface")) this.app.showLayersOf("atlas");
    this.app.chartView.listener = {
      hover: (at) => this.hoverAt((kind) => (at ? (this.texture?.placeAt(kind, at) ?? null) : null)),
      press: (at) => this.grab(this.texture?.placeAt("corner", at) ?? null),
      drag: (at) => this.dragTo(this.inSpace(at), true),
      release: (at) => this.releaseAt(at),
    };
    this.showBox();
  }

  end(): void {
    this.app.chartView.listener = null;
    this.forget();
    this.anchors = [];
    this.app.chartView.light({ places: [], vertices: [], anchors: [] });
    this.app.stage.setHovered(-1);
    this.app.tools.setBox(null);
  }

  refresh(): void {
    const chart = this.app.store.get("chart");
    if (chart !== this.chart) this.anchors = [];
    this.chart = chart;
    if (!this.grabbed) this.forget();
    this.app.stage.setHovered(-1);
  }

  hover(event: PointerEvent): void {
    const hit = this.app.stage.surface.pick(this.app.viewport.ray(event)), t = this.texture;
    const isHere = hit && t && hit.chart === t.id;
    this.app.stage.setHovered(hit && !isHere ? hit.chart : -1);
    this.hoverAt((kind) => (isHere ? t.placeNear(kind, hit.point) : null));
  }

  press(event: PointerEvent): boolean {
    const hit = this.app.stage.surface.pick(this.app.viewport.ray(event)), t = this.texture;
    if (this.operator.id !== "drag" || !hit || !t || hit.chart !== t.id) return false;
    const place = t.placeNear("corner", hit.point), at = this.app.viewport.project(t.inSpace(t.vertexOf(place)));
    if (Math.hypot(at.x - event.clientX, at.y - event.clientY) > 16) return false; // the camera's
    this.grab(place);
    return true;
  }

  drag(event: PointerEvent): void {
    this.dragTo(this.app.stage.surface.pick(this.app.viewport.ray(event))?.point ?? null, true);
  }

  release(event: PointerEvent): void {
    this.drop(this.app.stage.surface.pick(this.app.viewport.ray(event))?.point ?? null);
  }

  click(event: PointerEvent): void {
    const hit = this.app.stage.surface.pick(this.app.viewport.ray(event)), t = this.texture;
    if (!hit) return;
    if (!t || hit.chart !== t.id) this.app.store.set("chart", hit.chart);
    else this.take((kind) => t.placeNear(kind, hit.point));
    this.refresh();
    this.app.tools.tellHint();
  }

  abandon(): void {
    this.grabbed = null;
    this.forget();
  }

  private get texture(): Texture | null {
    return this.app.chartView.texture;
  }
  private get edge(): number {
    return this.app.store.get("state")?.facts?.edge_length ?? 0;
  }
  private get target(): PlaceKind {
    return this.operator.targets[this.picked.length] ?? "corner";
  }

  private inSpace(at: PlanePoint): THREE.Vector3 | null {
    return (this.grabbed?.texture ?? this.texture)?.toSpace(at) ?? null;
  }

  private hoverAt(find: (kind: PlaceKind) => Place | null): void {
    this.hovered = find(this.target);
    this.light();
  }

  private light(): void {
    const t = this.texture;
    const brushed = this.operator.id === "drag" || this.operator.id === "relax";
    const middle = t && this.hovered && t.inSpace(t.vertexOf(this.hovered));
    this.app.chartView.light({
      places: [...this.picked, ...(this.hovered ? [this.hovered] : [])],
      vertices: t && middle && brushed ? t.verticesWithin(middle, this.brush * this.edge) : [], anchors: this.anchors,
    });
  }

  private releaseAt(at: PlanePoint): void {
    if (this.operator.id === "drag") return this.drop(this.inSpace(at));
    const t = this.texture;
    if (t) this.take((kind) => t.placeAt(kind, at));
  }

  private grab(place: Place | null): void {
    const t = this.texture;
    if (this.operator.id !== "drag" || !place || !t) return;
    this.grabbed = { texture: t, name: t.name(place) };
    this.moved = false;
    this.hovered = place;
  }

  private dragTo(to: THREE.Vector3 | null, live: boolean): void {
    if (!this.grabbed || !to) return;
    this.moved = true;
    this.app.dragEdit(
      {
        edit: "drag_vertices", points: [surfacePoint(this.app, this.grabbed.name)], to: surfacePoint(this.app, to), radius: this.brush * this.edge,
        steps: this.steps, anchors: this.anchorPoints(),
      }, live,
    );
  }

  private drop(to: THREE.Vector3 | null): void {
    if (this.moved) this.dragTo(to ?? this.grabbed?.name ?? null, false);
    this.grabbed = null;
    this.forget();
  }

  private take(find: (kind: PlaceKind) => Place | null): void {
    const place = find(this.target), t = this.texture;
    if (!place || !t || this.operator.targets.length === 0) return;
    if (this.operator.id === "anchor") return this.toggleAnchor(t.inSpace(t.vertexOf(place)));
    this.picked.push(place);
    if (this.picked.length === this.operator.targets.length) {
      void this.app.edit(this.edit(this.picked.map((p) => surfacePoint(this.app, t.name(p)))));
      this.forget();
    }
    this.light();
    this.app.tools.tellHint();
  }

  private edit(points: object[]): Edit {
    const { id } = this.operator;
    if (id === "relax") return { edit: "relax_texture", at: points[0], radius: this.brush * this.edge, steps: Math.max(1, this.steps), anchors: this.anchorPoints() };
    if (id === "snap") return { edit: "snap_vertices", points };
    return { edit: "edit_texture", operator: id, points, ...(this.operator.hasFraction ? { fraction: this.fraction } : {}) };
  }

  private toggleAnchor(point: THREE.Vector3): void {
    const near = 0.05 * this.edge, kept = this.anchors.filter((a) => a.distanceTo(point) > near);
    this.anchors = kept.length < this.anchors.length ? kept : [...kept, point];
    this.light();
  }

  private anchorPoints(): object[] {
    return this.anchors.map((a) => surfacePoint(this.app, a));
  }

  private forget(): void {
    this.picked = [];
    this.hovered = null;
    if (this.texture) this.light();
  }

  private whole(make: (at: object) => Edit): void {
    const t = this.texture;
    if (!t) return void this.app.toasts.show("No chart is open", "Click a chart first.");
    void this.app.edit(make(surfacePoint(this.app, t.name({ kind: "quad", quad: 0, corner: 0 }))));
  }

  private use(operator: Operator): void {
    this.operator = operator;
    this.forget();
    this.showBox();
    this.app.tools.tellHint();
  }

  private showBox(): void {
    const button = (o: Operator): HTMLElement =>
      h("button", { className: `small ${o === this.operator ? "on" : ""}`, title: o.about, role: "radio", "aria-checked": String(o === this.operator), "data-operator": o.id, onclick: () => this.use(o) }, o.name);
    const slider = (name: string, id: string, value: number, [min, max, step]: [number, number, number], set: (value: number) => void): HTMLElement => {
      const shown = h("output", {}, String(value)), input = h("input", { type: "range", id, min: String(min), max: String(max), step: String(step), value: String(value) });
      input.oninput = () => {
        set(input.valueAsNumber);
        shown.textContent = input.value;
      };
      return h("label", { className: "field" }, h("span", { className: "label" }, name), input, shown);
    };
    const immediate = (name: string, id: string, make: (at: object) => Edit): HTMLElement => h("button", { className: "small", "data-operator": id, onclick: () => this.whole(make) }, name);
    const brushed = this.operator.id === "drag" || this.operator.id === "relax";
    this.app.tools.setBox(
      h(
        "div", { className: "tool-box texture-box" }, h("strong", {}, "Texture"),
        ...groups.map((g) => h("div", { className: "row", role: "radiogroup", "aria-label": g.name }, h("span", { className: "note" }, g.name), h("div", { className: "buttons" }, ...g.operators.map(button)))),
        brushed && slider("Brush", "brush", this.brush, [0, 8, 0.5], (value) => (this.brush = value)),
        brushed && slider("Smooth", "relax-steps", this.steps, [0, 20, 1], (value) => (this.steps = value)),
        this.operator.hasFraction && slider("Where", "fraction", this.fraction, [0.1, 0.9, 0.05], (value) => (this.fraction = value)),
        h("p", { className: "note" }, this.operator.about),
        h(
          "div", { className: "row" }, h("span", { className: "note" }, "Chart"), h("div", { className: "buttons" },
          immediate("Refine", "subdivide", (at) => ({ edit: "edit_texture", operator: "subdivide", points: [at] })),
          immediate("Coarsen", "coarsen", (at) => ({ edit: "edit_texture", operator: "coarsen", points: [at] })),
          immediate("Smooth all", "relax_all", (at) => ({ edit: "relax_texture", at, anchors: this.anchorPoints() })),
          immediate("Fit", "fit", (at) => ({ edit: "fit_texture", at })),
          immediate("Regular", "reset", (at) => ({ edit: "reset_texture", at })),
        )),
      ),
    );
  }
}
