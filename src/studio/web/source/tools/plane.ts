// SPDX-License-Identifier: GPL-3.0-or-later
import * as THREE from "three";
import { TransformControls } from "three/addons/controls/TransformControls.js";
import type { Workbench } from "../workbench";
import { RequestError } from "../net/connection";
import type { Edit } from "../net/messages";
import { Lines, markers, polylinePairs } from "../scene/lines";
import { markerMaterial, Shape } from "../scene/materials";
import type { Contour, CriticalPoint } from "../scene/stage";
import { h } from "../ui/dom";
import { icons } from "../ui/icons";
import type { KeyNotes } from "../ui/keyboard";
import { filePoint, pick, surfacePoint } from "./pick";
import type { Tool } from "./tool";

const previewDelay = 120; // milliseconds without a move before the program is asked
const grip = 16; // pixels around the saddle's sign that take it

/** What is moved: a contour, or a saddle with all its contours. */
interface Held {
  contours: Contour[];
  /** The point that names it. */
  at: THREE.Vector3;
  /** Of a saddle: whether the plane touches the surface, or is tilted by the user. */
  saddle: CriticalPoint | null;
  touches: boolean;
}

/** Moves a contour, or a saddle with all its contours, onto a plane that the user turns and shifts. */
export class PlaneTool implements Tool {
  readonly id = "plane";
  readonly name = "Move contour";
  readonly key = "p";
  readonly icon = icons.plane;
  readonly keys: KeyNotes = [["Enter", "apply"], ["R", "turn the plane"], ["T", "shift the plane"], ["L", "contour or whole saddle"], ["N", "touch the surface"]];
  private readonly plane: THREE.Mesh;
  private readonly curve = new Lines(3.5, 0x43c59e, { hidden: true });
  private readonly gizmo: TransformControls;
  private readonly marks = new THREE.Group();
  private readonly markMaterial = markerMaterial();
  private wholeSaddle = false;
  private held: Held | null = null;
  private anchors: THREE.Vector3[] = [];
  private refusal = "";
  private timer = 0;
  private question = 0;
  /** Whether the program has said what it would make of the plane as it is. */
  isAnswered = false;

  constructor(private readonly app: Workbench) {
    this.plane = new THREE.Mesh(
      new THREE.PlaneGeometry(1, 1),
      new THREE.MeshBasicMaterial({ color: 0x5fa8ff, transparent: true, opacity: 0.16, side: THREE.DoubleSide, depthWrite: false }),
    );
    this.plane.renderOrder = 4;
    this.curve.object.renderOrder = 8;
    this.markMaterial.depthTest = false;
    this.markMaterial.uniforms.size!.value = 18;
    this.markMaterial.uniforms.ratio!.value = Math.min(devicePixelRatio, 2);
    const { viewport } = app;
    this.gizmo = new TransformControls(viewport.camera, viewport.canvas);
    this.gizmo.setSpace("local");
    this.gizmo.setSize(0.85);
    this.gizmo.addEventListener("dragging-changed", (event) => (viewport.controls.enabled = !event.value));
    this.gizmo.addEventListener("change", () => viewport.invalidate());
    this.gizmo.addEventListener("objectChange", () => this.tilted());
    viewport.scene.add(this.plane, this.curve.object, this.gizmo.getHelper(), this.marks);
    this.plane.visible = false;
  }

  hint(): string {
    if (this.refusal) return `This place is refused: ${this.refusal}`;
    if (this.wholeSaddle)
      return this.held
        ? "Drag the diamond over the surface. The rings tilt the plane, N lets it touch the surface again, Enter applies."
        : "Click a saddle, or a contour that runs through one.";
    return this.held
      ? "Drag a ring to turn the plane (R), or its arrow to shift it (T); Enter applies. Click the contour twice to move only the part between."
      : "Click the contour to move.";
  }

  begin(): void {
    if (!this.app.store.get("layers").has("contours")) this.app.showLayersOf("atlas");
    this.showBox();
  }

  end(): void {
    this.drop();
    this.app.tools.setBox(null);
  }

  refresh(): void {
    this.drop();
  }

  /** A drag on the gizmo is the gizmo's; one of the saddle's sign moves the saddle. */
  press(event: PointerEvent): boolean {
    this.giveSign(event);
    return this.gizmo.axis !== null || !this.gizmo.enabled;
  }

  drag(event: PointerEvent): void {
    if (this.gizmo.enabled) return;
    const hit = pick(this.app, event, "surface"), to = hit && this.app.stage.surface.vertexNear(hit.point);
    if (!to) return;
    this.plane.position.copy(to.point);
    if (this.held?.touches) this.face(to.normal);
    this.changed();
  }

  hover(event: PointerEvent): void {
    const { stage } = this.app;
    if (this.held) return this.giveSign(event);
    if (!this.wholeSaddle) return stage.chooseAt(event);
    const saddle = this.saddleAt(event);
    stage.choose(saddle ? stage.contoursAt(saddle) : []);
  }

  click(event: PointerEvent): void {
    if (this.wholeSaddle) {
      const saddle = this.saddleAt(event);
      return saddle ? this.takeSaddle(saddle) : undefined;
    }
    const contour = this.app.stage.contourAt(event);
    const at = pick(this.app, event, "contour");
    if (!contour || !at) return this.held ? undefined : this.app.tools.tellHint();
    if (contour.edge === this.held?.contours[0]?.edge) return this.addAnchor(at.point);
    this.takeContour(contour, at.point);
  }

  key_(event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    if (event.key === "l") this.choose(!this.wholeSaddle);
    else if (!this.held) return false;
    else if (event.key === "Enter") this.apply();
    else if (event.key === "r") this.setMode("rotate");
    else if (event.key === "t" && !this.wholeSaddle) this.setMode("translate");
    else if (event.key === "n" && this.wholeSaddle) this.touch();
    else if (event.key === "Escape") this.drop();
    else return false;
    return true;
  }

  /** Turns the plane around its first axis, as the red ring does. */
  turn(angle: number): void {
    this.plane.rotateX(angle);
    this.tilted();
  }

  /** Shifts the plane along its normal, as the blue arrow does. */
  shift(distance: number): void {
    this.plane.translateZ(distance);
    this.tilted();
  }

  /** Whether a loop is moved or a whole saddle; what is held becomes the other. */
  private choose(wholeSaddle: boolean): void {
    if (this.wholeSaddle === wholeSaddle) return;
    const { held } = this, [contour] = held?.contours ?? [];
    this.wholeSaddle = wholeSaddle;
    this.drop();
    if (!held || !contour) return;
    const saddle = this.app.stage.saddleOf(contour, held.at);
    if (!wholeSaddle) this.takeContour(contour, contour.points[contour.points.length >> 1]!);
    else if (saddle) this.takeSaddle(saddle);
  }

  private saddleAt(event: PointerEvent): CriticalPoint | null {
    const { stage } = this.app, sign = stage.criticalAt(event);
    if (sign?.kind === 1) return sign;
    const contour = stage.contourAt(event), at = pick(this.app, event, "contour");
    return contour && at && stage.saddleOf(contour, at.point);
  }

  /** Over the saddle's sign the pointer is not the rings', which may run through it. */
  private giveSign(event: PointerEvent): void {
    const { x, y } = this.app.viewport.project(this.plane.position);
    const isOnSign = Boolean(this.held?.saddle) && Math.hypot(x - event.clientX, y - event.clientY) < grip;
    this.gizmo.enabled = !isOnSign;
    if (isOnSign) this.gizmo.axis = null;
  }

  /** The plane through the middle of the contour that fits it best. */
  private takeContour(contour: Contour, at: THREE.Vector3): void {
    const middle = new THREE.Vector3(), normal = new THREE.Vector3();
    for (const p of contour.points) middle.addScaledVector(p, 1 / contour.points.length);
    contour.points.forEach((p, i) => {
      const q = contour.points[(i + 1) % contour.points.length]!;
      normal.add(p.clone().sub(middle).cross(q.clone().sub(middle)));
    });
    this.take({ contours: [contour], at, saddle: null, touches: false }, middle, normal.normalize());
    this.changed(false);
  }

  /** The plane that touches the surface at the saddle. */
  private takeSaddle(saddle: CriticalPoint): void {
    const { stage } = this.app, at = saddle.position;
    this.take({ contours: stage.contoursAt(saddle), at, saddle, touches: true }, at, stage.surface.vertexNear(at)!.normal);
    this.changed();
  }

  private take(held: Held, middle: THREE.Vector3, normal: THREE.Vector3): void {
    this.drop();
    this.held = held;
    const radius = Math.max(...held.contours.flatMap(({ points }) => points.map((p) => p.distanceTo(middle))));
    this.plane.position.copy(middle);
    this.face(normal);
    this.plane.scale.setScalar((held.saddle ? 1.4 : 2.6) * radius);
    this.plane.visible = true;
    this.gizmo.attach(this.plane);
    this.setMode("rotate");
    this.app.stage.choose(held.contours);
    this.showBox();
  }

  // A turn around its normal, and a shift in itself, would leave a plane what it is: there is no handle for them.
  private setMode(mode: "rotate" | "translate"): void {
    this.gizmo.setMode(mode);
    this.gizmo.showX = this.gizmo.showY = mode === "rotate";
    this.gizmo.showZ = mode === "translate";
    this.app.viewport.invalidate();
  }

  private drop(): void {
    clearTimeout(this.timer);
    this.held = null;
    this.anchors = [];
    this.refusal = "";
    this.plane.visible = false;
    this.gizmo.detach();
    this.gizmo.enabled = true;
    this.curve.set(new Float32Array());
    this.drawMarks();
    this.app.stage.choose([]);
    this.showBox();
    this.tell();
  }

  private addAnchor(point: THREE.Vector3): void {
    this.anchors = this.anchors.length >= 2 ? [point] : [...this.anchors, point];
    this.changed();
  }

  private get normal(): THREE.Vector3 {
    return new THREE.Vector3(0, 0, 1).applyQuaternion(this.plane.quaternion);
  }

  private face(normal: THREE.Vector3): void {
    this.plane.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), normal);
  }

  private tilted(): void {
    if (this.held) this.held.touches = false;
    this.changed();
  }

  /** Lets the plane touch the surface where the saddle is to be. */
  private touch(): void {
    const to = this.app.stage.surface.vertexNear(this.plane.position);
    if (!this.held || !to) return;
    this.held.touches = true;
    this.face(to.normal);
    this.changed();
  }

  private edit({ at, saddle, touches }: Held): Edit {
    const { app, plane, anchors } = this;
    if (saddle)
      return { edit: "move_saddle", at: surfacePoint(app, at), to: surfacePoint(app, plane.position), plane_normal: touches ? [0, 0, 0] : this.normal.toArray() };
    return {
      edit: "move_contour", at: surfacePoint(app, at), plane_point: filePoint(app, plane.position), plane_normal: this.normal.toArray(),
      anchors: anchors.length === 2 ? anchors.map((p) => surfacePoint(app, p)) : [],
    };
  }

  /** Shows where the plane meets the surface now; the program then says which curves it would take. */
  private changed(ask = true): void {
    const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(this.normal, this.plane.position);
    this.drawMarks();
    // Between anchors the program takes another plane, through both: what it makes is drawn when it has said it.
    this.drawCurve(this.anchors.length === 2 ? new Float32Array() : this.app.stage.surface.intersection(plane));
    this.setRefusal("");
    clearTimeout(this.timer);
    ++this.question;
    this.isAnswered = false;
    if (ask && this.held) this.timer = window.setTimeout(() => void this.askProgram(), previewDelay);
    this.app.viewport.invalidate();
  }

  private async askProgram(): Promise<void> {
    const { question, held } = this;
    const isAsked = (): boolean => question === this.question && held === this.held;
    if (!held) return;
    try {
      const { contours } = (await this.app.connection.request("preview", { edit: this.edit(held) })) as { contours: number[][] };
      if (!isAsked()) return;
      this.show(contours);
    } catch (error) {
      if (!isAsked()) return;
      // Another request took its turn: asked again behind that.
      if (error instanceof RequestError && error.failure.cancelled) return void (this.timer = window.setTimeout(() => void this.askProgram(), previewDelay));
      this.setRefusal(error instanceof Error ? error.message : String(error));
    }
    this.isAnswered = true;
  }

  /** Shows the contours that the program would make, each x, y, z of its points; the saddle goes to where they meet. */
  private show(contours: number[][]): void {
    const begin = [0];
    for (const points of contours) begin.push(begin.at(-1)! + points.length / 3);
    this.drawCurve(polylinePairs(new Float32Array(contours.flat()), new Uint32Array(begin)));
    if (!this.held?.saddle) return;
    const ends = contours.flatMap((points) => [points.slice(0, 3), points.slice(-3)]).map((p) => new THREE.Vector3().fromArray(p));
    const { position } = this.plane;
    position.copy(ends.sort((a, b) => a.distanceToSquared(position) - b.distanceToSquared(position))[0] ?? position);
    this.drawMarks();
  }

  private drawCurve(pairs: Float32Array): void {
    this.curve.set(pairs);
    this.curve.show(this.held !== null);
    this.app.viewport.invalidate();
  }

  private setRefusal(sentence: string): void {
    this.refusal = sentence;
    this.curve.material.color.setHex(sentence ? 0xff5147 : 0x43c59e);
    this.tell();
    this.app.viewport.invalidate();
  }

  private tell(): void {
    this.app.tools.tellHint(this.refusal !== "");
  }

  private apply(): void {
    if (!this.held) return;
    clearTimeout(this.timer);
    void this.app.edit(this.edit(this.held));
  }

  /** The anchors, or the place of the saddle. */
  private drawMarks(): void {
    for (const child of [...this.marks.children]) this.marks.remove(child);
    const places = this.held?.saddle ? [this.plane.position] : this.anchors;
    if (places.length === 0) return;
    const points = new Float32Array(places.flatMap((p) => p.toArray()));
    const marks = markers(this.markMaterial, points, places.map(() => [1, 0.62, 0.15]), places.map(() => Shape.diamond), places.map(() => 1));
    marks.renderOrder = 9;
    this.marks.add(marks);
  }

  private showBox(): void {
    const ready = this.held !== null;
    const choice = (name: string, whole: boolean, id: string): HTMLElement =>
      h("button", { className: `small ${whole === this.wholeSaddle ? "on" : ""}`, role: "radio", "aria-checked": String(whole === this.wholeSaddle), "data-choice": id, onclick: () => this.choose(whole) }, name);
    const button = (name: string, act: () => void): HTMLElement => h("button", { className: "small", disabled: !ready, onclick: act }, name);
    this.app.tools.setBox(
      h(
        "div", { className: "tool-box" }, h("strong", {}, "Move contour"),
        h("div", { className: "row", role: "radiogroup", "aria-label": "What moves" }, choice("Contour", false, "contour"), choice("Whole saddle (L)", true, "saddle")),
        h(
          "p", { className: "note" },
          this.wholeSaddle
            ? "The saddle goes where you drag it, with all its contours: they run where the plane through it meets the surface."
            : "The contour goes where the plane meets the surface. A contour with a saddle keeps its saddle.",
        ),
        h(
          "div", { className: "row" }, button("Turn (R)", () => this.setMode("rotate")),
          this.wholeSaddle ? button("Touch (N)", () => this.touch()) : button("Shift (T)", () => this.setMode("translate")),
          h("button", { className: "small primary", id: "apply-plane", disabled: !ready, onclick: () => this.apply() }, "Apply"),
        ),
      ),
    );
  }
}
