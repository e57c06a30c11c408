// SPDX-License-Identifier: GPL-3.0-or-later
// A report that stands alone: reads facts and layers out of the file that it is in, and shows them.
import * as THREE from "three";
import { decodeFrame } from "../net/frame";
import { switched, layerList, views, type LayerId } from "../scene/layers";
import { Stage } from "../scene/stage";
import { Viewport } from "../scene/viewport";
import { Store } from "../store";
import css from "../style.css?inline";
import { h, icon, save } from "../ui/dom";
import { icons } from "../ui/icons";
import { keyboardHelp, listenToKeys, type Shortcut } from "../ui/keyboard";
import { layersPanel } from "../ui/layers_panel";
import { qualityPanel, type Bin } from "../ui/quality_panel";
import { statusBar } from "../ui/status_bar";
import { startTheme } from "../ui/theme";
import { showView, viewsBar } from "../ui/views_bar";
import { stateOf, type Facts } from "./facts";
import { certificatePanel, designPanel, editsPanel, stagesPanel, statisticsPanel, valencesPanel } from "./panels";
import reportCss from "./report.css?inline";

const onSurface: LayerId[] = ["surface", "field", "isolines", "charts", "textures", "wireframe"];
/** What must be in the file for a layer to be shown, where that has another name. */
const needs: Partial<Record<LayerId, string>> = { isolines: "field", valences: "quads", quality: "quads", wireframe: "quads", xray: "quads" };

class Report {
  readonly store = new Store();
  readonly viewport: Viewport;
  readonly stages: Stage[] = [];
  private readonly layers = new Set<string>();

  constructor(root: HTMLElement, private readonly facts: Facts) {
    const canvasHost = h("div", { className: "canvas" });
    this.store.set("connected", true);
    const { toggle: toggleTheme } = startTheme(() => this.show());
    this.viewport = new Viewport(canvasHost);
    this.readLayers();
    this.store.set("state", stateOf(facts));
    const shortcuts = this.shortcuts();
    const help = keyboardHelp(shortcuts);
    listenToKeys([...shortcuts, { keys: "?", about: "this list", group: "Report", run: help }]);
    this.makeShell(root, canvasHost, toggleTheme, help);
    this.store.watch(["layers"], () => this.show());
    this.viewport.setUp(new THREE.Vector3(...facts.axis).normalize());
    this.fit(false);
    showView(this.store, "quads");
    canvasHost.addEventListener("dblclick", (event) => this.focus(event));
  }

  private readLayers(): void {
    for (const element of document.querySelectorAll<HTMLScriptElement>("script[data-layer]")) {
      const part = Number(element.dataset.part);
      while (this.stages.length <= part) this.stages.push(new Stage(this.viewport));
      this.layers.add(element.dataset.layer!);
    }
    // In the order in which layers refer to each other.
    for (const layer of ["surface", "cuts", "field", "charts", "contours", "critical", "reeb", "textures", "quads"])
      for (const element of document.querySelectorAll<HTMLScriptElement>(`script[data-layer="${layer}"]`)) {
        const text = atob(element.textContent!);
        const bytes = Uint8Array.from(text, (c) => c.charCodeAt(0));
        this.stages[Number(element.dataset.part)]!.take(decodeFrame(bytes.buffer));
        element.remove();
      }
  }

  private get hasSurface(): boolean {
    return this.layers.has("surface");
  }
  private has(layer: LayerId): boolean {
    return this.layers.has(needs[layer] ?? layer) && (this.hasSurface || !onSurface.includes(layer));
  }

  private show(): void {
    for (const stage of this.stages) stage.show(this.store.get("layers"));
  }

  private fit(smooth: boolean): void {
    const all = new Float32Array(this.stages.reduce((sum, s) => sum + s.quads.positions.length, 0));
    let at = 0;
    for (const { quads } of this.stages) {
      all.set(quads.positions, at);
      at += quads.positions.length;
    }
    this.viewport.fit(all, smooth);
  }

  private focus(event: MouseEvent): void {
    const ray = this.viewport.ray(event);
    const hits = this.stages.flatMap((stage) => stage.surface.pick(ray) ?? []);
    hits.sort((a, b) => a.point.distanceTo(ray.ray.origin) - b.point.distanceTo(ray.ray.origin));
    if (hits[0]) this.viewport.focus(hits[0].point);
  }

  private lightQuads(bin: Bin): void {
    for (const { quads } of this.stages) quads.light(bin && ((q) => q >= bin.low - 1e-6 && (q < bin.high || bin.high >= 1)));
    if (bin) showView(this.store, "quality");
    this.viewport.invalidate();
  }

  private shortcuts(): Shortcut[] {
    const layers = layerList
      .filter((layer) => this.has(layer.id))
      .map((layer) => ({ keys: layer.key, about: layer.name.toLowerCase(), group: "Layers", run: () => this.store.set("layers", switched(this.store.get("layers"), layer.id)) }));
    return [{ keys: "h", about: "see everything", group: "Camera", run: () => this.fit(true) }, ...layers];
  }

  private makeShell(root: HTMLElement, canvasHost: HTMLElement, toggleTheme: () => void, help: () => void): void {
    const { facts, store } = this;
    const button = (paths: string, title: string, onclick: () => void): HTMLElement => h("button", { className: "ghost icon-button", title, "aria-label": title, onclick }, icon(paths));
    const panel = (title: string, content: HTMLElement | null, open = false): HTMLElement | null => content && h("details", { open, className: "panel" }, h("summary", {}, title), content);
    const certificate = panel("Certificate", certificatePanel(facts), true)!;
    const name = facts.input.file.replace(/^.*\//, "");
    const top = h(
      "header", { className: "top" }, h("span", { className: "brand" }, name, h("em", {}, ` by reebquad ${facts.version}`)), h("span", { className: "spring" }),
      viewsBar(store, (view) => views[view].layers.every((layer) => layer !== "deviation" && (this.hasSurface || !onSurface.includes(layer)))), h("span", { className: "spring" }),
      button(icons.fit, "See everything (H)", () => this.fit(true)),
      button(icons.camera, "Save a picture", () => void this.viewport.screenshot().then((picture) => save(picture, `${name}.png`))),
      button(icons.theme, "Dark or light", toggleTheme), button(icons.help, "Keys and mouse (?)", help),
    );
    const side = h("aside", { className: "side" });
    const panels = [
      panel("Layers", layersPanel(store, (id) => this.has(id)), true), panel("Quality", qualityPanel(store, (bin) => this.lightQuads(bin)), true), certificate,
      panel("Statistics", statisticsPanel(facts), true), panel("Valences", valencesPanel(facts)), panel("Design", designPanel(facts)),
      panel("Stages", stagesPanel(facts)), panel("Edits", editsPanel(facts)),
    ];
    for (const each of panels) if (each) side.append(each);
    if (!this.hasSurface) side.append(h("p", { className: "note" }, "The surface is not in this report: it would take more than 8 MB."));
    const showCertificate = (): void => {
      certificate.setAttribute("open", "");
      certificate.scrollIntoView({ behavior: "smooth" });
    };
    root.append(top, h("div", { className: "body report-body" }, h("main", { className: "middle" }, canvasHost), side), statusBar(store, showCertificate));
  }
}

declare global {
  interface Window {
    /** For tests: what the report shows. */
    report?: Report;
  }
}

document.head.append(h("style", {}, css + reportCss));
window.report = new Report(document.getElementById("app")!, JSON.parse(document.getElementById("facts")!.textContent!) as Facts);
