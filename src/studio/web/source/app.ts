// SPDX-License-Identifier: GPL-3.0-or-later
// The page: puts the parts together and carries what one says to the others.
import * as THREE from "three";
import { Connection, RequestError } from "./net/connection";
import type { Edit, FileFacts, State, Vector } from "./net/messages";
import { layerList, switched, type ViewId } from "./scene/layers";
import { Flash } from "./scene/flash";
import { PlaceMark } from "./scene/place_mark";
import { Stage } from "./scene/stage";
import { Viewport } from "./scene/viewport";
import { Store } from "./store";
import type { Workbench } from "./workbench";
import { DragContourTool } from "./tools/drag_contour";
import { DragEdits } from "./tools/drag_edits";
import { ExtremumTool } from "./tools/extremum";
import { GuidedTool, guides } from "./tools/guided";
import { PlaneTool } from "./tools/plane";
import { SelectTool } from "./tools/select";
import { TextureTool } from "./tools/texture";
import type { Tool } from "./tools/tool";
import { ToolBox } from "./tools/tool_box";
import { ChartView } from "./local/chart_view";
import { chartPanel } from "./ui/chart_panel";
import { designPanel } from "./ui/design_panel";
import { defectsPanel } from "./ui/defects_panel";
import { displayMenu } from "./ui/display_menu";
import { h, icon, save } from "./ui/dom";
import { DeviationPanel } from "./ui/deviation_panel";
import { HintsPanel } from "./ui/hints_panel";
import { historyPanel } from "./ui/history_panel";
import { icons } from "./ui/icons";
import { keyboardHelp, listenToKeys, type Shortcut } from "./ui/keyboard";
import { layersPanel } from "./ui/layers_panel";
import { openDialog } from "./ui/open_dialog";
import { lostBanner } from "./ui/lost_banner";
import { Preferences } from "./ui/preferences";
import { askName, question } from "./ui/question";
import { partsPanel } from "./ui/parts_panel";
import { progressBar } from "./ui/progress";
import { qualityPanel } from "./ui/quality_panel";
import { splitBar } from "./ui/split";
import { statusBar } from "./ui/status_bar";
import { Thumbnails } from "./ui/thumbnails";
import { elementName, plain } from "./ui/words";
import { startTheme } from "./ui/theme";
import { Toasts } from "./ui/toasts";
import { stepsBar, steps, viewOf } from "./ui/steps_bar";
import { tabs } from "./ui/tabs";
import { Remedy } from "./ui/remedy";
import { showView } from "./ui/views_bar";
import { welcome } from "./ui/welcome";

/** What to do when an edit fails so; what fails otherwise is about a file. */
const advice: Record<string, string> = {
  "the edit is refused": "Nothing was changed: try another place.",
  "the request cannot be met": "Nothing was changed.",
  "no integer sampling exists": "Nothing was changed: free a count, or ask for more quads.",
};

const largestUpload = 2 ** 30;

/** Commands after which an earlier failure is of no interest. */
const changes = new Set(["edit", "undo", "redo", "go_to", "open_file", "open_recipe", "component"]);

/** The elements that parts of the page fill. */
interface Hosts {
  canvasHost: HTMLElement;
  middle: HTMLElement;
  hintLine: HTMLElement;
  toolHost: HTMLElement;
}

export class App implements Workbench {
  readonly store = new Store();
  readonly toasts: Toasts;
  readonly connection: Connection;
  readonly preferences: Preferences;
  readonly viewport: Viewport;
  readonly stage: Stage;
  readonly tools: ToolBox;
  readonly chartView: ChartView;
  private readonly drags: DragEdits;
  private findingMark: PlaceMark | null = null;
  private toastMark: PlaceMark | null = null;
  readonly flash: Flash;
  private readonly remedy: Remedy;
  private readonly thumbnails: Thumbnails;
  private readonly deviation: DeviationPanel;
  private readonly hintsHost = h("div", {});
  private readonly deviationHost = h("div", {});
  /** The file and the part of it that is shown. */
  private shown = "";
  private hadQuads = false;

  constructor(root: HTMLElement) {
    this.connection = new Connection({
      state: (state) => this.takeState(state),
      frame: (frame) => (frame.layer === "chart" ? this.chartView.take(frame) : frame.layer === "deviation" ? this.deviation.take(frame) : this.stage.take(frame)),
      layerGone: (layer) => this.stage.remove(layer),
      progress: (stage, fraction) => this.store.set("busy", stage ? { stage, fraction } : null),
      trouble: (message) => this.toasts.show("That did not work", message, "bad"),
      connected: (yes) => this.store.set("connected", yes),
      preferences: (kept) => this.preferences.take(kept),
    });
    this.preferences = new Preferences(this.connection);
    this.drags = new DragEdits(this.connection, (error, edit) => this.tell(error, edit), (reason) => this.tools.tellRefusal(reason && plain(reason)));
    const canvasHost = h("div", { className: "canvas" });
    const openMesh = openDialog({
      connection: this.connection, store: this.store, take: (file) => void this.take([file]), openMesh: (name) => void this.openFile(name),
      openRecipe: (name) => void this.openRecipe(name, () => this.ask("open_recipe", { name })), restore: (digest) => void this.ask("restore", { digest }),
    });
    this.toasts = new Toasts();
    const middle = h("main", { className: "middle" }), hintLine = h("div", { className: "hint-line", role: "status" }), toolHost = h("div", { className: "tool-host" });
    const help = this.makeShell(root, { canvasHost, middle, hintLine, toolHost }, openMesh);
    this.viewport = new Viewport(canvasHost);
    this.stage = new Stage(this.viewport);
    this.flash = new Flash(this.stage);
    this.remedy = new Remedy(this);
    this.thumbnails = new Thumbnails(this.connection, () => this.viewport.thumbnail());
    this.findingMark = new PlaceMark(this.viewport);
    this.toastMark = new PlaceMark(this.viewport);
    this.tools = new ToolBox(this, hintLine, toolHost);
    const split = splitBar(middle, this.preferences);
    this.chartView = new ChartView(this, split);
    middle.append(split, this.chartView.panel);
    this.addTools();
    this.deviation = new DeviationPanel(this, (measured) => this.store.set("deviation", measured));
    this.deviationHost.append(this.deviation.element);
    this.hintsHost.append(new HintsPanel(this).element);
    this.tools.choose("select");
    this.wire(canvasHost, openMesh, help);
    this.connection.open();
  }

  /** The rail's groups follow the steps. */
  private addTools(): void {
    const guided = (id: string): Tool => new GuidedTool(this, guides.find((guide) => guide.id === id)!);
    this.tools.add(new SelectTool(this));
    this.tools.divide("Limbs");
    this.tools.add(new ExtremumTool(this));
    this.tools.divide("Contours");
    for (const tool of [guided("subdivide"), new DragContourTool(this), new PlaneTool(this), guided("contour")]) this.tools.add(tool);
    this.tools.divide("Vertices");
    for (const tool of [guided("saddle"), guided("pole"), guided("align"), new TextureTool(this)]) this.tools.add(tool);
  }

  /** Sends a request and tells the user if it fails; null then. */
  async ask(command: string, members: Record<string, unknown> = {}): Promise<unknown> {
    try {
      const result = await this.connection.request(command, members);
      if (changes.has(command)) this.toasts.forgive();
      return result;
    } catch (error) {
      this.tell(error, command === "edit" ? (members.edit as Edit) : undefined);
      return null;
    }
  }

  edit(edit: Edit, live = false): Promise<unknown> {
    return this.ask("edit", { edit, live });
  }

  /** An edit that follows the pointer; the last one of a drag is not `live`. */
  dragEdit(edit: Edit, live: boolean): void {
    this.drags.send(edit, live);
  }

  /** The pointer was let go where nothing is: what was dragged stays where it was last. */
  endDrag(): void {
    this.drags.end();
  }

  cancelDrag(): void {
    this.drags.cancel();
  }

  /** Looks at a place of the surface from outside. */
  flyTo(place: THREE.Vector3, distance?: number): void {
    this.viewport.focus(place, distance, this.stage.surface.normalAt(place));
  }

  /** A failure; of an edit also what stands in its way, and what works instead. */
  tell(error: unknown, edit?: Edit): void {
    if (error instanceof RequestError && error.failure.cancelled) return void this.toasts.show("Stopped", "Everything is as it was before.");
    const message = error instanceof Error ? error.message : String(error);
    if (!(error instanceof RequestError)) return void this.toasts.show("That did not work", capital(message), "bad");
    const { element, index, code } = error.failure, place = code in advice ? this.placeOf(element, index) : null;
    const where = elementName(element, index, this.store.get("state")?.facts?.charts ?? []);
    const show = place && { name: "Show", run: () => (this.flyTo(place), this.toastMark?.show(place)) };
    const toast = this.toasts.show("That did not work", [capital(plain(message)) + where, advice[code] ?? ""].join(". "), "bad", show ?? undefined, () => this.toastMark?.show(null));
    if (code in advice) this.flash.show(element, index);
    if (edit && code in advice) void this.remedy.offer(edit, toast);
  }

  /** Where an element of the surface or of the design is. */
  private placeOf(element: string, index: number): THREE.Vector3 | null {
    const { surface, contours } = this.stage;
    const vertex = element === "vertex" ? index : element === "face" ? surface.triangles[3 * index] : -1;
    if (vertex !== undefined && vertex >= 0 && 3 * vertex < surface.positions.length) return surface.vertex(vertex);
    const line = element === "contour" ? contours.find((c) => c.edge === index)?.points : undefined;
    return line?.[line.length >> 1] ?? null;
  }

  /** Whether it was opened. */
  async upload(file: File): Promise<boolean> {
    if (file.size > largestUpload) {
      const text = `${file.name} has ${(file.size / 2 ** 30).toFixed(1)} GiB; at most 1 GiB can be sent. Put it into the folder of the program and open it from there: that takes up to 4 GiB.`;
      this.toasts.show("The file is too large", text, "bad");
      return false;
    }
    try {
      this.store.set("busy", { stage: `sending ${file.name}`, fraction: 0 });
      await this.connection.upload(file);
      return true;
    } catch (error) {
      this.store.set("busy", null);
      this.tell(error);
      return false;
    }
  }

  /** Files that were chosen or dropped: a mesh, a recipe, or both, which belong together then. */
  async take(files: readonly File[]): Promise<void> {
    const recipe = files.find(isRecipe), mesh = files.find((file) => !isRecipe(file));
    if (mesh && !(await this.upload(mesh))) return;
    if (recipe) await this.openRecipe(recipe.name, () => this.upload(recipe));
  }

  /** Follows a recipe on the mesh that is open; asks where edits would be lost. */
  private async openRecipe(name: string, follow: () => Promise<unknown>): Promise<void> {
    const state = this.store.get("state"), edits = state?.history?.length ?? 0;
    if (!state?.file) return void this.toasts.show("Open the mesh first", `${name} is a recipe: it says what to do with a mesh.`, "bad");
    if (edits > 0) {
      const text = `The steps of ${name} take the place of your ${edits} ${edits === 1 ? "edit" : "edits"} of ${state.file.name}.`;
      const answer = await question("Follow the recipe?", text, [{ id: "save", name: "Save mine first", primary: true }, { id: "follow", name: "Follow it" }]);
      if (answer === null || (answer === "save" && !(await this.saveAs()))) return;
    }
    await follow();
  }

  /** Saves the recipe under a name, in the program's folder or among the downloads; whether that was done. */
  private async saveAs(): Promise<boolean> {
    const text = "The recipe is the list of your edits; with the mesh it gives the same quads again, here and by “reebquad replay”.";
    const asked = await askName("Save the recipe as", text, `${this.baseName}.recipe.json`, [{ id: "folder", name: "Save in the folder", primary: true }, { id: "download", name: "Download" }]);
    if (!asked) return false;
    const name = /\.json$/.test(asked.name) ? asked.name : `${asked.name}.recipe.json`;
    if (asked.choice === "download") return this.download("recipe", name);
    return this.saveInFolder(name, false);
  }

  private async saveInFolder(name: string, replace: boolean): Promise<boolean> {
    try {
      await this.connection.request("save_recipe", { name, replace });
      this.toasts.show(`${name} is saved`, "It is in the folder of the program.", "good");
      return true;
    } catch (error) {
      const exists = error instanceof RequestError && /there is such a file already/.test(error.message);
      if (!exists) return this.tell(error), false;
      const answer = await question("Replace the file?", `${name} is there already.`, [{ id: "replace", name: "Replace it" }]);
      return answer !== null && this.saveInFolder(name, true);
    }
  }

  openFile(name: string): Promise<unknown> {
    return this.ask("open_file", { name });
  }

  async download(what: string, name: string): Promise<boolean> {
    try {
      save(await this.connection.download(what), name);
      this.toasts.show(`${name} is in your downloads`, what === "recipe" ? "" : this.missingParts(), "good");
      return true;
    } catch (error) {
      this.tell(error);
      return false;
    }
  }

  /** Lets only the quads shine whose quality passes; null: all. */
  lightQuads(lit: ((quality: number) => boolean) | null): void {
    this.stage.quads.light(lit);
    if (lit) this.setView("quality");
    this.viewport.invalidate();
  }

  setView(view: ViewId): void {
    this.store.set("step", view);
    this.showLayersOf(view);
  }

  showLayersOf(view: ViewId): void {
    showView(this.store, viewOf(view, this.store.get("state")));
  }

  /** With its view and its panels; a tool of another step is put away. */
  private goToStep(step: ViewId): void {
    if (!steps[step].tools.includes(this.store.get("tool"))) this.tools.choose("select");
    this.store.set("tab", step === "deviation" ? "check" : this.store.get("tab") === "check" ? "design" : this.store.get("tab"));
    this.setView(step);
  }

  /** What the tab Check has to tell. */
  private toCheck(): { number: number; about: string } {
    const file = this.store.get("state")?.file, lost = this.store.get("deviation")?.lost_corners.length ?? 0, hints = this.store.get("hints");
    const findings = (file?.defects.length ?? 0) + (file?.refused.length ?? 0);
    const parts = [[findings, "findings in the file"], [lost, "lost corners"], [hints, "hints"]] as const;
    return { number: findings + lost + hints, about: parts.filter(([n]) => n > 0).map(([n, what]) => `${n} ${what}`).join(", ") };
  }

  private get baseName(): string {
    return (this.store.get("state")?.file?.name ?? "mesh").replace(/^.*\//, "").replace(/\.[^.]*$/, "");
  }

  /** Says which parts of the file have no quads. */
  private missingParts(): string {
    const parts = this.store.get("state")?.file?.components ?? [];
    const without = parts.flatMap((part, i) => (part.quads > 0 ? [] : [i + 1]));
    if (without.length === 0) return "";
    return `Without ${without.length > 1 ? "parts" : "part"} ${without.join(", ")}: no quads there yet.`;
  }

  private takeState(state: State): void {
    this.tellWhatIsKept(this.store.get("state"), state);
    this.store.set("state", state);
    this.thumbnails.follow(state);
    const name = state.file?.name ?? "";
    const hasQuads = Boolean(state.statistics);
    const shown = state.file ? `${state.file.component} ${name}` : "";
    if (name && shown !== this.shown) {
      this.tools.escape();
      setTimeout(() => this.stage.surface.prepare(), 500);
      this.viewport.fit(this.stage.surface.positions, this.shown.endsWith(` ${name}`));
      if (!this.shown.endsWith(` ${name}`)) this.tellOfFile(state.file!);
    }
    if (hasQuads && !this.hadQuads) this.setView("quads");
    if (!hasQuads && (this.hadQuads || shown !== this.shown)) this.setView("surface");
    this.shown = shown;
    this.hadQuads = hasQuads;
    if (state.last?.warning) this.toasts.show("Not saved", state.last.warning, "bad");
  }

  /** Another mesh took the place of one with edits. */
  private tellWhatIsKept(before: State | null, now: State): void {
    const edits = before?.history?.length ?? 0;
    if (!before?.file || !now.file || before.file.digest === now.file.digest || edits === 0) return;
    this.toasts.show(`Your work on ${before.file.name} is kept`, `${edits} ${edits === 1 ? "edit" : "edits"}. “Open” brings it back.`);
  }

  private tellOfFile(file: FileFacts): void {
    if (file.mends.length) this.toasts.show("The mesh was mended", file.mends.join(" "));
    const { length } = file.components;
    if (length > 1) this.toasts.show(`The mesh has ${length} parts`, `Part ${file.component}, the largest, is shown. The list “Parts” has the others.`);
  }

  private wire(canvasHost: HTMLElement, openMesh: () => void, help: HTMLButtonElement): void {
    this.store.watch(["up"], () => this.viewport.setUp(new THREE.Vector3(...this.store.get("up"))));
    this.store.watch(["layers"], () => this.stage.show(this.store.get("layers")));
    this.store.watch(["chart"], () => this.stage.setSelected(this.store.get("chart")));
    this.preferences.watch(() => this.follow());
    const shortcuts = this.shortcuts(openMesh);
    const showKeys = keyboardHelp(shortcuts, this.tools.keyNotes());
    help.onclick = showKeys;
    listenToKeys([...shortcuts, { keys: "?", about: "this list", group: "Studio", run: showKeys }]);
    canvasHost.addEventListener("dblclick", (event) => {
      const hit = this.stage.surface.pick(this.viewport.ray(event));
      if (hit) this.viewport.focus(hit.point);
    });
    const drops = (over: boolean): void => void document.body.classList.toggle("dropping", over);
    document.addEventListener("dragover", (event) => (event.preventDefault(), drops(true)));
    document.addEventListener("dragleave", (event) => event.relatedTarget === null && drops(false));
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      drops(false);
      void this.take([...(event.dataTransfer?.files ?? [])]);
    });
  }

  private shortcuts(openMesh: () => void): Shortcut[] {
    const studio: Shortcut[] = [
      { keys: "Ctrl+o", about: "open a mesh or a recipe", group: "Studio", run: openMesh },
      { keys: "Ctrl+s", about: "save the recipe as", group: "Studio", run: () => void this.saveAs() },
      { keys: "Ctrl+z", about: "undo", group: "Studio", run: () => void this.ask("undo") },
      { keys: "Ctrl+Shift+z", about: "redo", group: "Studio", run: () => void this.ask("redo") },
      { keys: "Ctrl+y", about: "redo", group: "Studio", run: () => void this.ask("redo") },
      { keys: "Ctrl+e", about: "export the quads", group: "Studio", run: () => void this.download("obj", `${this.baseName}_quads.obj`) },
      { keys: "h", about: "see everything", group: "Camera", run: () => this.viewport.fit(this.stage.surface.positions, true) },
      { keys: ".", about: "see the chosen chart", group: "Camera", run: () => this.frameChart() },
      { keys: "o", about: "orthographic or not", group: "Camera", run: () => this.preferences.set("orthographic", !this.preferences.get("orthographic")) },
      { keys: "+", about: "nearer", group: "Camera", run: () => this.viewport.zoom(1.2) },
      { keys: "-", about: "further away", group: "Camera", run: () => this.viewport.zoom(1 / 1.2) },
      { keys: "Escape", about: "stop the tool", group: "Tools", run: () => this.tools.escape() },
    ];
    const layers = layerList.map((layer) => ({
      keys: layer.key, about: layer.name.toLowerCase(), group: "Layers", run: () => this.store.set("layers", switched(this.store.get("layers"), layer.id)),
    }));
    return [...studio, ...this.tools.shortcuts(), ...layers];
  }

  private makeShell(root: HTMLElement, { canvasHost, middle, hintLine, toolHost }: Hosts, openMesh: () => void): HTMLButtonElement {
    const help = button(icons.help, "Keys and mouse (?)");
    const toggleTheme = (): void => this.preferences.set("theme", document.documentElement.dataset.theme === "dark" ? "light" : "dark");
    const display = displayMenu(this.preferences, {
      look: (from) => this.viewport.look(from), everything: () => this.viewport.fit(this.stage.surface.positions, true), selection: () => this.frameChart(),
    });
    const format = h("select", { title: "Format of the quads", "aria-label": "Format of the quads", id: "format" }, ...["obj", "off", "ply", "vtk", "glb", "stl"].map((f) => h("option", { value: f }, f.toUpperCase())));
    const undo = button(icons.undo, "Undo (Ctrl+Z)", () => void this.ask("undo"), "undo");
    const redo = button(icons.redo, "Redo (Ctrl+Shift+Z)", () => void this.ask("redo"), "redo");
    const exportQuads = h("button", { id: "export", title: "Export the quads (Ctrl+E)", onclick: () => void this.download(format.value, `${this.baseName}_quads.${format.value}`) }, icon(icons.export), "Export");
    const saveRecipe = h("button", { id: "recipe", title: "Save the edits as a recipe that reebquad replay repeats", onclick: () => void this.download("recipe", `${this.baseName}.recipe.json`) }, icon(icons.save), "Recipe");
    const saveAs = h("button", { id: "save-as", title: "Save the recipe as … (Ctrl+S)", "aria-label": "Save the recipe as", onclick: () => void this.saveAs() }, "as …");
    const report = h("button", { id: "report", title: "An interactive report with all numbers, as one HTML file", onclick: () => void this.download("html", `${this.baseName}_report.html`) }, icon(icons.report), "Report");
    this.store.watch(["state"], () => {
      const state = this.store.get("state");
      undo.disabled = !state?.applied;
      redo.disabled = (state?.applied ?? 0) >= (state?.history?.length ?? 0);
      exportQuads.disabled = format.disabled = report.disabled = !state?.file?.components.some((part) => part.quads > 0);
      saveRecipe.disabled = saveAs.disabled = !state?.file;
    });
    const top = h(
      "header", { className: "top" },
      h("img", { src: "/icon.svg", alt: "", className: "logo" }), h("span", { className: "brand" }, "reebquad ", h("em", {}, "studio")),
      h("button", { id: "open", title: "Open a mesh, earlier work or a recipe (Ctrl+O)", onclick: openMesh }, icon(icons.open), "Open"),
      undo, redo, h("span", { className: "spring" }), stepsBar(this.store, (step) => this.goToStep(step)), h("span", { className: "spring" }),
      h("span", { className: "joined" }, saveRecipe, saveAs), report, h("span", { className: "joined" }, exportQuads, format),
      ...display, button(icons.camera, "Save a picture", () => void this.screenshot(), "screenshot"), button(icons.theme, "Dark or light", toggleTheme, "theme"), help,
    );
    const panel = (title: string, content: HTMLElement, open = true): HTMLElement => h("details", { open, className: "panel" }, h("summary", {}, title), content);
    const flyTo = (where: Vector, radius: number): void => this.flyTo(new THREE.Vector3(...where), radius);
    const side = h(
      "aside", { className: "side", "aria-label": "Panels" }, toolHost,
      ...tabs(this.store, [
        {
          id: "design", name: "Design",
          content: [
            partsPanel(this.store, (component) => void this.ask("component", { component })),
            panel("Design", designPanel(this.store, (edit) => void this.edit(edit), (sentence) => this.toasts.show("That did not work", sentence, "bad"))),
            panel("Chart", chartPanel(this)),
          ],
        },
        { id: "layers", name: "Layers", content: [panel("Layers", layersPanel(this.store))] },
        {
          id: "check", name: "Check", badge: () => this.toCheck(),
          content: [
            panel("Findings", defectsPanel(this.store, flyTo, (where) => this.findingMark?.show(where && new THREE.Vector3(...where)))),
            panel("Hints", this.hintsHost),
            panel("Quality", qualityPanel(this.store, (bin) => this.lightQuads(bin && ((q) => q >= bin.low - 1e-6 && (q < bin.high || bin.high >= 1))))),
            panel("Deviation", this.deviationHost),
          ],
        },
        { id: "history", name: "History", content: [panel("History", historyPanel(this.store, (step) => void this.ask("go_to", { step })))] },
      ]),
    );
    // Nothing lies over the model for longer than a message.
    const scene = h("div", { className: "scene" }, canvasHost, progressBar(this.store, () => void this.ask("cancel")), lostBanner(this.store), this.toasts.element, welcome(this.store, openMesh, (digest) => void this.ask("restore", digest ? { digest } : {})));
    middle.append(h("div", { className: "model" }, hintLine, scene));
    root.append(top, h("div", { className: "body" }, h("nav", { className: "rail", id: "rail", "aria-label": "Tools" }), middle, side), statusBar(this.store, () => void this.ask("certify")));
    return help;
  }

  private readonly theme = startTheme(() => this.stage?.show(this.store.get("layers")));

  /** Sees all of the chosen chart, or everything where none is. */
  frameChart(): void {
    const chart = this.store.get("chart"), points = chart < 0 ? this.stage.surface.positions : this.stage.surface.pointsOf(chart);
    if (points.length > 0) this.viewport.frameOf(points);
  }

  private follow(): void {
    const theme = this.preferences.get("theme");
    if (theme) this.theme.set(theme);
    this.stage.setShading(this.preferences.get("shading"));
    this.viewport.setOrthographic(this.preferences.get("orthographic"));
  }

  private async screenshot(): Promise<void> {
    save(await this.viewport.screenshot(), `${this.baseName}.png`);
  }
}

function button(paths: string, title: string, onclick?: () => void, id?: string): HTMLButtonElement {
  return h("button", { className: "ghost icon-button", title, "aria-label": title, onclick: onclick ?? null, id: id ?? "" }, icon(paths));
}

function isRecipe(file: File): boolean {
  return /\.json$/i.test(file.name);
}

function capital(text: string): string {
  if (/^\S+\.\w+/.test(text)) return text; // a file's name
  return text.charAt(0).toUpperCase() + text.slice(1);
}
