// SPDX-License-Identifier: GPL-3.0-or-later
// The rail of tools, the hint line, and who gets the pointer.
import type * as THREE from "three";
import { PlaceMark } from "../scene/place_mark";
import type { Workbench } from "../workbench";
import { h, icon } from "../ui/dom";
import type { KeyNotes, Shortcut } from "../ui/keyboard";
import { stepOf } from "../ui/steps_bar";
import type { Tool, Tools } from "./tool";

const clickTolerance = 4; // pixels that a click may move

export class ToolBox implements Tools {
  private readonly tools: Tool[] = [];
  private active: Tool | null = null;
  private pressed: { x: number; y: number; claimed: boolean; abandoned?: boolean } | null = null;
  private readonly refusedMark: PlaceMark;
  /** Where the pointer is on the surface while it drags. */
  private pointed: THREE.Vector3 | null = null;

  /** `hintLine` says what to do now; `boxHost` has the active tool's controls. */
  constructor(private readonly app: Workbench, private readonly hintLine: HTMLElement, private readonly boxHost: HTMLElement) {
    this.refusedMark = new PlaceMark(app.viewport, [0.9, 0.22, 0.2]);
    const canvas = app.viewport.canvas;
    // Before the camera's own listeners, so that a tool can claim the drag.
    canvas.addEventListener("pointerdown", (e) => this.down(e), true);
    window.addEventListener("pointermove", (e) => this.move(e));
    canvas.addEventListener("pointerleave", () => !this.pressed && this.active?.leave?.());
    window.addEventListener("pointerup", (e) => this.up(e));
    window.addEventListener("keydown", (e) => {
      if ((e.target as HTMLElement).matches("input, select, textarea")) return;
      if (e.key === "Escape" && this.pressed?.claimed) {
        e.stopImmediatePropagation();
        return this.abandon();
      }
      if (!this.active?.key_?.(e) && !this.clickByKey(e)) return;
      e.preventDefault();
      e.stopImmediatePropagation();
    }, true);
    // By keys the view is moved under its middle, which is marked then: what is there is as what a pointer is on.
    app.viewport.controls.addEventListener("change", () => this.isByKeys && this.active?.hover?.(this.atMiddle("pointermove")));
    app.store.watch(["step"], () => this.tellHint());
    app.store.watch(["state"], () => {
      for (const tool of this.tools) this.buttonOf(tool.id)!.disabled = !this.isPossible(tool.id);
      if (this.active && !this.isPossible(this.active.id)) this.choose("select");
      this.active?.refresh?.();
      this.tellHint();
    });
  }

  get current(): Tool | null {
    return this.active;
  }

  add(tool: Tool): void {
    this.tools.push(tool);
    const button = h(
      "button", { className: "tool", title: `${tool.name} (${tool.key.toUpperCase()})`, "aria-label": tool.name, "data-tool": tool.id, disabled: !this.isPossible(tool.id), onclick: () => this.choose(tool.id) },
      icon(tool.icon), h("span", {}, tool.name),
    );
    document.getElementById("rail")?.append(button);
  }

  /** Begins another group of tools in the rail. */
  divide(name: string): void {
    document.getElementById("rail")?.append(h("h3", {}, name));
  }

  choose(id: string): void {
    if (!this.isPossible(id)) return;
    this.active?.end?.();
    this.active = this.tools.find((t) => t.id === id) ?? null;
    this.app.store.set("step", stepOf(id) ?? this.app.store.get("step"));
    this.active?.begin?.();
    this.app.store.set("tool", id);
    for (const b of document.querySelectorAll<HTMLElement>(".tool")) b.classList.toggle("on", b.dataset.tool === id);
    this.tellHint();
  }

  /** Most tools change a design, so that there must be one; but extrema are what a design begins with. */
  private isPossible(id: string): boolean {
    return id === "select" || (id === "extremum" && Boolean(this.app.store.get("state")?.file)) || Boolean(this.app.store.get("state")?.facts?.charts.length);
  }

  private buttonOf(id: string): HTMLButtonElement | null {
    return document.querySelector(`[data-tool="${id}"]`);
  }

  /** Takes back a drag; without one, stops the tool. */
  escape(): void {
    if (this.pressed?.claimed) return this.abandon();
    this.choose("select");
    this.app.store.set("chart", -1);
  }

  shortcuts(): Shortcut[] {
    return this.tools.map((tool) => ({ keys: tool.key, about: tool.name.toLowerCase(), group: "Tools", run: () => this.choose(tool.id) }));
  }

  /** The keys of single tools. */
  keyNotes(): Record<string, KeyNotes> {
    return Object.fromEntries(this.tools.flatMap(({ name, keys }) => (keys ? [[name, keys]] : [])));
  }

  /** The tool's own controls, at the top of the panels. */
  setBox(box: HTMLElement | null): void {
    this.boxHost.replaceChildren(...(box ? [box] : []));
  }

  tellHint(bad = false): void {
    if (!bad) this.app.viewport.canvas.classList.remove("refused");
    this.hintLine.classList.toggle("bad", bad);
    const hint = this.app.store.get("state")?.file ? (this.active?.hint() ?? "") : "";
    this.hintLine.textContent = hint;
  }

  tellRefusal(reason: string | null): void {
    this.app.viewport.canvas.classList.toggle("refused", reason !== null);
    this.refusedMark.show(reason === null ? null : this.pointed);
    if (reason === null) return this.tellHint();
    this.tellHint(true);
    this.hintLine.textContent = `This place is refused: ${reason}. Let go here, or press Escape, and all is as before.`;
  }

  private get isByKeys(): boolean {
    return this.app.viewport.canvas.matches(":focus-visible");
  }

  private atMiddle(kind: string): PointerEvent {
    const { left, top, width, height } = this.app.viewport.canvas.getBoundingClientRect();
    return new PointerEvent(kind, { clientX: left + width / 2, clientY: top + height / 2 });
  }

  /** Space in the view is a click in its middle. */
  private clickByKey(event: KeyboardEvent): boolean {
    if (event.key !== " " || event.target !== this.app.viewport.canvas || !this.active) return false;
    const at = this.atMiddle("pointerup");
    if (this.active.press?.(at)) this.active.release?.(at);
    else this.active.click?.(at);
    return true;
  }

  private abandon(): void {
    this.pressed = { ...this.pressed!, claimed: false, abandoned: true };
    this.app.cancelDrag();
    this.active?.abandon?.();
    this.tellHint();
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0) return;
    const claimed = !event.shiftKey && !event.ctrlKey && (this.active?.press?.(event) ?? false);
    this.pressed = { x: event.clientX, y: event.clientY, claimed };
    this.app.viewport.controls.enabled = !claimed;
  }

  private move(event: PointerEvent): void {
    if (this.pressed?.claimed) {
      this.pointed = this.app.stage.surface.pick(this.app.viewport.ray(event))?.point ?? null;
      this.active?.drag?.(event);
    }
    else if (!this.pressed && event.target === this.app.viewport.canvas) this.active?.hover?.(event);
  }

  private up(event: PointerEvent): void {
    const pressed = this.pressed;
    this.pressed = null;
    this.app.viewport.controls.enabled = true;
    if (!pressed || pressed.abandoned || event.button !== 0) return;
    if (pressed.claimed) this.active?.release?.(event);
    else if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) < clickTolerance) this.active?.click?.(event);
  }
}
