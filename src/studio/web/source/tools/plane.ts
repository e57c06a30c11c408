// SPDX-License-Identifier: GPL-3.0-or-later
import * as THREE from "three";
import { TransformControls } from "three/addons/controls/TransformControls.js";
import type { App } from "../app";
import type { Edit } from "../net/messages";
import { Lines, markers } from "../scene/lines";
import { markerMaterial, Shape } from "../scene/materials";
import type { Contour } from "../scene/stage";
import { h } from "../ui/dom";
import { icons } from "../ui/icons";
import { filePoint, pick, surfacePoint } from "./pick";
import type { Tool } from "./tool";

const previewDelay = 120; // milliseconds without a move before the program is asked

/** Moves a contour onto a plane that the user turns and shifts. */
export class PlaneTool implements Tool {
  readonly id = "plane";
  readonly name = "Move contour";
  readonly key = "p";
  readonly icon = icons.plane;
  private readonly plane: THREE.Mesh;
  private readonly curve = new Lines(3.5, 0x43c59e, { hidden: true });
  private readonly gizmo: TransformControls;
  private readonly anchorMarks = new THREE.Group();
  private readonly anchorMaterial = markerMaterial();
  private contour: Contour | null = null;
  private at = new THREE.Vector3();
  private anchors: THREE.Vector3[] = [];
  private refusal = "";
  private timer = 0;
  private question = 0;

  constructor(private readonly app: App) {
    this.plane = new THREE.Mesh(
      new THREE.PlaneGeometry(1, 1),
      new THREE.MeshBasicMaterial({ color: 0x5fa8ff, transparent: true, opacity: 0.16, side: THREE.DoubleSide, depthWrite: false }),
    );
    this.plane.renderOrder = 4;
    this.curve.object.renderOrder = 8;
    this.anchorMaterial.depthTest = false;
    this.anchorMaterial.uniforms.ratio!.value = Math.min(devicePixelRatio, 2);
    const { viewport } = app;
    this.gizmo = new TransformControls(viewport.camera, viewport.canvas);
    this.gizmo.setSpace("local");
    this.gizmo.setSize(0.85);
    this.gizmo.addEventListener("dragging-changed", (event) => (viewport.controls.enabled = !event.value));
    this.gizmo.addEventListener("change", () => viewport.invalidate());
    this.gizmo.addEventListener("objectChange", () => this.changed());
    viewport.scene.add(this.plane, this.curve.object, this.gizmo.getHelper(), this.anchorMarks);
    this.plane.visible = false;
  }

  hint(): string {
    if (!this.contour) return "Click the contour to move.";
    if (this.refusal) return `This place is refused: ${this.refusal}`;
    return "Drag the arrows or rings. R turns, T shifts, Enter applies. Click the contour twice to move only the part between.";
  }

  begin(): void {
    if (!this.app.store.get("layers").has("contours")) this.app.setView("atlas");
    this.showBox();
  }

  end(): void {
    this.drop();
    this.app.tools.setBox(null);
  }

  refresh(): void {
    this.drop();
  }

  /** A drag on the gizmo is the gizmo's. */
  press(): boolean {
    return this.gizmo.axis !== null;
  }

  hover(event: PointerEvent): void {
    if (!this.contour) this.app.stage.choose(this.app.stage.contourAt(event));
  }

  click(event: PointerEvent): void {
    const contour = this.app.stage.contourAt(event);
    const at = pick(this.app, event, "contour");
    if (!contour || !at) return this.contour ? undefined : this.app.tools.tellHint();
    if (this.contour && contour.edge === this.contour.edge) return this.addAnchor(at.point);
    this.take(contour, at.point);
  }

  key_(event: KeyboardEvent): boolean {
    if (!this.contour) return false;
    if (event.key === "Enter") this.apply();
    else if (event.key === "r") this.gizmo.setMode("rotate");
    else if (event.key === "t") this.gizmo.setMode("translate");
    else if (event.key === "Escape") this.drop();
    else return false;
    return true;
  }

  /** Turns the plane around its first axis, as the red ring does. */
  turn(angle: number): void {
    this.plane.rotateX(angle);
    this.changed();
  }

  /** The plane through the middle of the contour that fits it best. */
  private take(contour: Contour, at: THREE.Vector3): void {
    this.drop();
    this.contour = contour;
    this.at = at;
    const middle = new THREE.Vector3(), normal = new THREE.Vector3();
    for (const p of contour.points) middle.addScaledVector(p, 1 / contour.points.length);
    let radius = 0;
    contour.points.forEach((p, i) => {
      const q = contour.points[(i + 1) % contour.points.length]!;
      normal.add(p.clone().sub(middle).cross(q.clone().sub(middle)));
      radius = Math.max(radius, p.distanceTo(middle));
    });
    this.plane.position.copy(middle);
    this.plane.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), normal.normalize());
    this.plane.scale.setScalar(2.6 * radius);
    this.plane.visible = true;
    this.gizmo.attach(this.plane);
    this.gizmo.setMode("rotate");
    this.app.stage.choose(contour);
    this.changed(false);
    this.showBox();
  }

  private drop(): void {
    clearTimeout(this.timer);
    this.contour = null;
    this.anchors = [];
    this.refusal = "";
    this.plane.visible = false;
    this.gizmo.detach();
    this.curve.set(new Float32Array());
    this.drawAnchors();
    this.app.stage.choose(null);
    this.showBox();
    this.tell();
  }

  private addAnchor(point: THREE.Vector3): void {
    this.anchors = this.anchors.length >= 2 ? [point] : [...this.anchors, point];
    this.drawAnchors();
    this.changed();
  }

  private get normal(): THREE.Vector3 {
    return new THREE.Vector3(0, 0, 1).applyQuaternion(this.plane.quaternion);
  }

  private get edit(): Edit {
    return {
      edit: "move_contour", at: surfacePoint(this.app, this.at), plane_point: filePoint(this.app, this.plane.position),
      plane_normal: this.normal.toArray(), anchors: this.anchors.length === 2 ? this.anchors.map((p) => surfacePoint(this.app, p)) : [],
    };
  }

  private changed(ask = true): void {
    const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(this.normal, this.plane.position);
    this.curve.set(this.app.stage.surface.intersection(plane));
    this.curve.show(this.contour !== null);
    this.setRefusal("");
    clearTimeout(this.timer);
    if (ask && this.contour) this.timer = window.setTimeout(() => void this.askProgram(), previewDelay);
    this.app.viewport.invalidate();
  }

  private async askProgram(): Promise<void> {
    const question = ++this.question;
    try {
      await this.app.connection.request("preview", { edit: this.edit });
    } catch (error) {
      const cancelled = error instanceof Error && "failure" in error && (error as { failure: { cancelled: boolean } }).failure.cancelled;
      if (question === this.question && !cancelled && this.contour) this.setRefusal(error instanceof Error ? error.message : String(error));
    }
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
    if (!this.contour) return;
    clearTimeout(this.timer);
    const { edit } = this;
    void this.app.edit(edit);
  }

  private drawAnchors(): void {
    for (const child of [...this.anchorMarks.children]) this.anchorMarks.remove(child);
    if (this.anchors.length === 0) return;
    const points = new Float32Array(this.anchors.flatMap((p) => p.toArray()));
    const marks = markers(this.anchorMaterial, points, this.anchors.map(() => [1, 0.62, 0.15]), this.anchors.map(() => Shape.diamond), this.anchors.map(() => 1));
    marks.renderOrder = 9;
    this.anchorMarks.add(marks);
  }

  private showBox(): void {
    const ready = this.contour !== null;
    this.app.tools.setBox(
      h(
        "div", { className: "tool-box" }, h("strong", {}, "Move contour"),
        h("p", { className: "note" }, "The contour goes where the plane meets the surface. A contour with a saddle keeps its saddle."),
        h(
          "div", { className: "row" },
          h("button", { className: "small", disabled: !ready, onclick: () => this.gizmo.setMode("rotate") }, "Turn (R)"),
          h("button", { className: "small", disabled: !ready, onclick: () => this.gizmo.setMode("translate") }, "Shift (T)"),
          h("button", { className: "small primary", id: "apply-plane", disabled: !ready, onclick: () => this.apply() }, "Apply"),
        ),
      ),
    );
  }
}
