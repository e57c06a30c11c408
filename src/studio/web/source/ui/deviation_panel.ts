// SPDX-License-Identifier: GPL-3.0-or-later
import * as THREE from "three";
import type { Workbench } from "../workbench";
import { RequestError } from "../net/connection";
import { floats, type Frame } from "../net/frame";
import type { Deviation, State, Vector } from "../net/messages";
import { css, deviationColour } from "../scene/colours";
import { PlaceMark } from "../scene/place_mark";
import { h, icon, replace } from "./dom";
import { icons } from "./icons";

/** Above so many triangles it is measured only when it is looked at. */
const askedAbove = 60000;

/** The ends of the scale that can be chosen, as parts of the diagonal; 0 is the greatest distance. */
const scales = [0, 0.0003, 0.001, 0.003, 0.01, 0.03];

/** How far the quads are from the surface: a legend, the worst places, sharp edges and corners that are lost; a click flies there. */
export class DeviationPanel {
  readonly element = h("div", { className: "deviation" });
  private readonly mark: PlaceMark;
  private measured: Deviation | null = null;
  /** The design that was measured, and that was asked about. */
  private of = "";
  private asked = "";
  private scale = 0;

  constructor(private readonly app: Workbench, private readonly changed: (measured: Deviation | null) => void) {
    this.mark = new PlaceMark(app.viewport);
    app.store.watch(["state", "layers"], () => this.follow());
  }

  /** The frame that the program sent. */
  take(frame: Frame): void {
    this.measured = frame.data as unknown as Deviation;
    this.of = this.asked;
    this.app.stage.setDeviation(floats(frame, "surface"), floats(frame, "quads"), floats(frame, "lost_edges"));
    this.paint();
    this.changed(this.measured);
    this.draw();
  }

  private follow(): void {
    const state = this.app.store.get("state"), design = this.design(state);
    if (this.of !== "" && this.of !== design) this.drop();
    this.draw();
    const isLooked = this.app.store.get("layers").has("deviation");
    if (design !== "" && this.asked !== design && (isLooked || state!.file!.triangles <= askedAbove)) void this.ask(design);
  }

  /** Names the quads that are shown once they are relaxed; empty before that. */
  private design(state: State | null): string {
    if (!state?.file || !state.statistics || !state.finished) return "";
    return `${state.file.digest} ${state.file.component} ${JSON.stringify(state.history?.slice(0, state.applied).map((step) => step.edit))}`;
  }

  private drop(): void {
    this.of = "";
    this.measured = null;
    this.mark.show(null);
    this.app.stage.setDeviation(new Float32Array(), new Float32Array(), new Float32Array());
    this.changed(null);
  }

  private async ask(design: string): Promise<void> {
    this.asked = design;
    try {
      await this.app.connection.request("deviation");
    } catch (error) {
      this.asked = "";
      // Something else came first: measured again when that is done.
      if (error instanceof RequestError && error.failure.cancelled) setTimeout(() => this.follow(), 600);
    }
  }

  private get top(): number {
    const { measured } = this;
    if (!measured) return 1;
    return this.scale > 0 ? this.scale * measured.diagonal : Math.max(measured.of_surface, measured.of_quads, 1e-6 * measured.diagonal);
  }

  private paint(): void {
    this.app.stage.scaleDeviation(this.top);
    this.app.viewport.invalidate();
  }

  private draw(): void {
    const { measured } = this;
    if (!measured) {
      const state = this.app.store.get("state"), has = Boolean(state?.statistics);
      const ask = has && state!.finished && this.asked === "" && h("button", { className: "wide", id: "measure-deviation", onclick: () => this.app.setView("deviation") }, "Measure");
      return replace(this.element, ask, !ask && h("p", { className: "empty" }, has ? "Measuring …" : "There are no quads yet."));
    }
    const { of_surface, of_quads, diagonal } = measured;
    replace(
      this.element, this.legend(measured),
      h("p", { className: "note" }, "The surface is up to ", h("strong", {}, length(of_surface, diagonal)), " from the quads, and these up to ", h("strong", {}, length(of_quads, diagonal)), " from it."),
      this.features(measured),
      h("div", { className: "place-list" },
        ...measured.lost_corners.map((at, i) => this.row(at, `Corner ${i + 1} without a vertex`, "", 0.12)),
        ...measured.worst.map(({ place, distance, of }) => this.row(place, of === "surface" ? "Surface without quads" : "Quads off the surface", length(distance, diagonal), 0.25)),
      ),
    );
  }

  private legend({ diagonal }: Deviation): HTMLElement {
    const { top } = this, stops = Array.from({ length: 9 }, (_, i) => css(deviationColour(i / 8)));
    const choose = h("select", { id: "deviation-scale", "aria-label": "End of the scale" }, ...scales.map((part, i) => h("option", { value: String(i), selected: part === this.scale }, part === 0 ? "Greatest" : `${100 * part} %`)));
    choose.onchange = () => {
      this.scale = scales[Number(choose.value)]!;
      this.paint();
      this.draw();
    };
    const bar = h("div", { className: "ramp", role: "img", "aria-label": `Colours from 0 to ${length(top, diagonal)}` });
    bar.style.background = `linear-gradient(to right, ${stops.join(", ")})`;
    const tick = (part: number): HTMLElement => h("span", {}, part === 0 ? "0" : `${(part * top).toPrecision(2)}`, h("em", {}, part === 0 ? "" : percent(part * top, diagonal)));
    return h("div", { className: "legend" }, bar, h("div", { className: "ticks" }, tick(0), tick(0.5), tick(1)), h("label", { className: "field" }, h("span", {}, "Scale to"), choose));
  }

  private features(measured: Deviation): HTMLElement | null {
    const { corners, lost_corners, sharp_length, lost_sharp_length } = measured;
    if (corners === 0 && sharp_length === 0) return null;
    const kept = sharp_length > 0 ? `${Math.round(100 * (1 - lost_sharp_length / sharp_length))} %` : "";
    return h(
      "dl", { className: "coverage" },
      ...(corners > 0 ? [h("dt", {}, "Corners kept"), h("dd", { className: lost_corners.length ? "warn" : "", "data-corners": `${corners - lost_corners.length}/${corners}` }, `${corners - lost_corners.length} of ${corners}`)] : []),
      ...(kept ? [h("dt", {}, "Sharp edges followed"), h("dd", { className: lost_sharp_length > 0.02 * sharp_length ? "warn" : "", "data-sharp": kept }, kept)] : []),
    );
  }

  private row(at: Vector, text: string, value: string, distance: number): HTMLElement {
    const place = new THREE.Vector3(...at), show = (): void => this.mark.show(place), hide = (): void => this.mark.show(null);
    return h(
      "button", { className: "ghost finding", "data-place": at.join(" "), title: "Fly there", onclick: () => (show(), this.app.flyTo(place, distance * this.measured!.diagonal)), onpointerenter: show, onpointerleave: hide, onfocus: show, onblur: hide },
      icon(icons.eye), h("span", { className: "name" }, text), h("span", { className: "time" }, value),
    );
  }
}

function percent(distance: number, diagonal: number): string {
  return `${((100 * distance) / diagonal).toPrecision(2)} %`;
}

/** In units of the file and as a part of its diagonal. */
export function length(distance: number, diagonal: number): string {
  return `${distance.toPrecision(3)} (${percent(distance, diagonal)})`;
}
