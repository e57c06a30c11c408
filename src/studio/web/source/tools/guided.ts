// SPDX-License-Identifier: GPL-3.0-or-later
// Tools that are a sequence of clicks: each has a table of what to click, and makes an edit of it.
import * as THREE from "three";
import type { Workbench } from "../workbench";
import type { Edit } from "../net/messages";
import { markers } from "../scene/lines";
import { markerMaterial, Shape } from "../scene/materials";
import { isFree } from "../scene/stage";
import { h } from "../ui/dom";
import { icons } from "../ui/icons";
import { Preview } from "./preview";
import { missed, pick, surfacePoint, type Picked, type Target } from "./pick";
import type { Tool } from "./tool";

interface Step {
  target: Target;
  hint: string;
}

/** A way to use the tool, chosen in its box. */
interface Variant {
  name: string;
  about: string;
  steps: Step[];
  make: (at: object[]) => Edit;
}

interface Guide {
  id: string;
  name: string;
  key: string;
  icon: string;
  variants: Variant[];
}

const here: Step = { target: "surface", hint: "Click where the new contour is to run." };

export const guides: Guide[] = [
  {
    id: "subdivide", name: "Add contour", key: "s", icon: icons.subdivide,
    variants: [{ name: "Add contour", about: "Draws a level line of the chart as a new contour: its quads will follow it.", steps: [here], make: ([at]) => ({ edit: "subdivide_chart", at }) }],
  },
  {
    id: "contour", name: "Contours", key: "c", icon: icons.remove,
    variants: [
      { name: "Remove", about: "Removes a contour without saddles; its two charts become one.", steps: [{ target: "free", hint: "Click the contour to remove: one with a light middle." }], make: ([at]) => ({ edit: "remove_contour", at }) },
      { name: "Straighten", about: "Pulls a contour as short as its charts allow.", steps: [{ target: "contour", hint: "Click the contour to straighten." }], make: ([at]) => ({ edit: "straighten_contour", at }) },
      { name: "Snap", about: "Pulls a contour onto sharp edges near it.", steps: [{ target: "contour", hint: "Click the contour to pull onto sharp edges." }], make: ([at]) => ({ edit: "snap_contour", at }) },
    ],
  },
  {
    id: "align", name: "Align", key: "a", icon: icons.align,
    variants: [
      {
        name: "Two saddles", about: "Puts two saddles that a thin chart separates on one contour.",
        steps: [{ target: "saddle", hint: "Click the first saddle." }, { target: "saddle", hint: "Click the saddle on the other side of the chart." }],
        make: ([first, second]) => ({ edit: "align_saddles", first, second }),
      },
      { name: "Collapse chart", about: "Removes a thin chart; the saddles on its two sides come to lie on one contour.", steps: [{ target: "surface", hint: "Click the thin chart." }], make: ([at]) => ({ edit: "collapse_chart", at }) },
    ],
  },
  {
    id: "saddle", name: "Split saddle", key: "d", icon: icons.saddle,
    variants: [
      { name: "Halves", about: "One vertex of valence 8 becomes two of valence 6.", steps: [{ target: "saddle", hint: "Click the saddle to split into two." }], make: ([at]) => ({ edit: "split_saddle", at, kind: "half" }) },
      {
        name: "Halves, placed", about: "You say where the two vertices of valence 6 come to lie.",
        steps: [
          { target: "saddle", hint: "Click the saddle." }, { target: "surface", hint: "Click where the first half is to be, on one side where a limb begins." },
          { target: "surface", hint: "Click where the second half is to be, on the other limb." },
        ],
        make: ([at, ...points]) => ({ edit: "split_saddle", at, kind: "half", points }),
      },
      { name: "Quarters", about: "One vertex of valence 8 becomes four of valence 5.", steps: [{ target: "saddle", hint: "Click the saddle to split into four." }], make: ([at]) => ({ edit: "split_saddle", at, kind: "quarter" }) },
      { name: "Make regular", about: "Gives the cap between half-saddles its corners there: they become regular vertices.", steps: [{ target: "surface", hint: "Click the cap between the half-saddles." }], make: ([at]) => ({ edit: "pin_corners", at }) },
    ],
  },
  {
    id: "pole", name: "Split pole", key: "q", icon: icons.pole,
    variants: [
      { name: "Quarters", about: "Four vertices of valence 3 around the tip: a square cap.", steps: [{ target: "extremum", hint: "Click the extremum at the tip." }], make: ([at]) => ({ edit: "split_pole", at, kind: "quarter" }) },
      { name: "Halves", about: "Two vertices of valence 2: the rows close like a seam.", steps: [{ target: "extremum", hint: "Click the extremum at the tip." }], make: ([at]) => ({ edit: "split_pole", at, kind: "half" }) },
      {
        name: "Halves, placed", about: "You say where the seam ends.",
        steps: [{ target: "extremum", hint: "Click the extremum." }, { target: "surface", hint: "Click one end of the seam." }, { target: "surface", hint: "Click the other end." }],
        make: ([at, ...ends]) => ({ edit: "split_pole", at, kind: "half", ends }),
      },
      { name: "Whole", about: "One vertex where triangles meet: not all quads.", steps: [{ target: "extremum", hint: "Click the extremum." }], make: ([at]) => ({ edit: "split_pole", at, kind: "whole" }) },
      {
        name: "Turn corners", about: "Moves a corner of the cap along its contour; the other three follow.",
        steps: [{ target: "surface", hint: "Click near the corner." }, { target: "surface", hint: "Click where it is to go." }], make: ([at, to]) => ({ edit: "move_corner", at, to }),
      },
    ],
  },
];

export class GuidedTool implements Tool {
  readonly id: string;
  readonly name: string;
  readonly key: string;
  readonly icon: string;
  private variant: Variant;
  private picked: Picked[] = [];
  private notice = "";
  private readonly preview: Preview;
  private readonly marks = new THREE.Group();
  private readonly material = markerMaterial();

  constructor(private readonly app: Workbench, private readonly guide: Guide) {
    this.id = guide.id;
    this.name = guide.name;
    this.key = guide.key;
    this.icon = guide.icon;
    this.variant = guide.variants[0]!;
    this.material.depthTest = false;
    this.material.uniforms.ratio!.value = Math.min(devicePixelRatio, 2);
    this.preview = new Preview(app, () => app.tools.tellHint(this.preview.refusal !== ""));
    app.viewport.scene.add(this.marks);
  }

  hint(): string {
    const step = this.variant.steps[this.picked.length];
    const number = this.variant.steps.length > 1 ? `${this.picked.length + 1} of ${this.variant.steps.length}: ` : "";
    if (this.preview.refusal) return `Refused here: ${this.preview.refusal}`;
    return this.notice || (step ? number + step.hint : "");
  }

  begin(): void {
    this.restart();
    if (!this.app.store.get("layers").has("surface")) this.app.showLayersOf("atlas");
    this.showBox();
  }

  end(): void {
    this.restart();
    this.app.tools.setBox(null);
    this.app.stage.setHovered(-1);
  }

  hover(event: PointerEvent): void {
    const step = this.variant.steps[this.picked.length];
    if (step?.target === "surface") this.app.stage.setHovered(pick(this.app, event, "surface")?.chart ?? -1);
    if (step?.target === "contour") this.app.stage.chooseAt(event);
    if (step?.target === "free") this.app.stage.chooseAt(event, isFree);
    const found = step && this.picked.length + 1 === this.variant.steps.length ? pick(this.app, event, step.target) : null;
    this.preview.show(found && this.editOf([...this.picked, found]));
  }

  leave(): void {
    this.preview.show(null);
    this.app.stage.setHovered(-1);
  }

  click(event: PointerEvent): void {
    const step = this.variant.steps[this.picked.length]!;
    const found = pick(this.app, event, step.target);
    this.notice = found ? "" : missed[step.target];
    if (found) this.picked.push(found);
    if (this.picked.length === this.variant.steps.length) this.finish();
    this.drawMarks();
    this.app.tools.tellHint();
  }

  key_(event: KeyboardEvent): boolean {
    if (event.key !== "Backspace" || this.picked.length === 0) return false;
    this.picked.pop();
    this.drawMarks();
    this.app.tools.tellHint();
    return true;
  }

  refresh(): void {
    this.restart();
  }

  private finish(): void {
    const edit = this.editOf(this.picked);
    this.picked = [];
    this.preview.show(null);
    void this.app.edit(edit);
  }

  private editOf(picked: readonly Picked[]): Edit {
    return this.variant.make(picked.map((p) => surfacePoint(this.app, p.point)));
  }

  private restart(): void {
    this.picked = [];
    this.notice = "";
    this.preview.show(null);
    this.drawMarks();
    this.app.stage.choose([]);
  }

  private showBox(): void {
    const { variants } = this.guide;
    this.app.tools.setBox(
      h(
        "div", { className: "tool-box" }, h("strong", {}, this.guide.name),
        variants.length > 1 &&
          h(
            "div", { className: "row", role: "radiogroup" },
            ...variants.map((v) =>
              h("button", { className: `small ${v === this.variant ? "on" : ""}`, role: "radio", "aria-checked": String(v === this.variant), "data-variant": v.name, onclick: () => this.use(v) }, v.name),
            ),
          ),
        h("p", { className: "note" }, this.variant.about),
      ),
    );
  }

  private use(variant: Variant): void {
    this.variant = variant;
    this.restart();
    this.showBox();
    this.app.tools.tellHint();
  }

  private drawMarks(): void {
    for (const child of [...this.marks.children]) this.marks.remove(child);
    if (this.picked.length) {
      const points = new Float32Array(this.picked.flatMap((p) => p.point.toArray()));
      const marks = markers(this.material, points, this.picked.map(() => [1, 0.62, 0.15]), this.picked.map(() => Shape.disc), this.picked.map(() => 1));
      marks.renderOrder = 9;
      this.marks.add(marks);
    }
    this.app.viewport.invalidate();
  }
}
