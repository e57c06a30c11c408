// SPDX-License-Identifier: GPL-3.0-or-later
// The rail of tools, the hint line, and who gets the pointer.
import type { Workbench } from "../workbench";
import { h, icon } from "../ui/dom";
import type { KeyNotes, Shortcut } from "../ui/keyboard";
import type { Tool, Tools } from "./tool";

const clickTolerance = 4; // pixels that a click may move

export class ToolBox implements Tools {
  private readonly tools: Tool[] = [];
  private active: Tool | null = null;
  private readonly hintLine = h("div", { className: "hint-line", role: "status" });
  private readonly boxHost = h("div", {});
  private pressed: { x: number; y: number; claimed: boolean } | null = null;

  constructor(private readonly app: Workbench, overlay: HTMLElement) {
    overlay.append(this.hintLine, this.boxHost);
    const canvas = app.viewport.canvas;
    // Before the camera's own listeners, so that a tool can claim the drag.
    canvas.addEventListener("pointerdown", (e) => this.down(e), true);
    window.addEventListener("pointermove", (e) => this.move(e));
    window.addEventListener("pointerup", (e) => this.up(e));
    window.addEventListener("keydown", (e) => {
      if ((e.target as HTMLElement).matches("input, select, textarea")) return;
      if (this.active?.key_?.(e)) {
        e.preventDefault();
        e.stopImmediatePropagation();
      }
    }, true);
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

  choose(id: string): void {
    if (!this.isPossible(id)) return;
    this.active?.end?.();
    this.active = this.tools.find((t) => t.id === id) ?? null;
    this.active?.begin?.();
    this.app.store.set("tool", id);
    for (const b of document.querySelectorAll<HTMLElement>(".tool")) b.classList.toggle("on", b.dataset.tool === id);
    this.tellHint();
  }

  /** All tools but one change a design, so that there must be one. */
  private isPossible(id: string): boolean {
    return id === "select" || Boolean(this.app.store.get("state")?.facts?.charts.length);
  }

  private buttonOf(id: string): HTMLButtonElement | null {
    return document.querySelector(`[data-tool="${id}"]`);
  }

  escape(): void {
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

  /** The tool's own controls, in the corner of the view. */
  setBox(box: HTMLElement | null): void {
    this.boxHost.replaceChildren(...(box ? [box] : []));
  }

  tellHint(bad = false): void {
    this.hintLine.classList.toggle("bad", bad);
    const hint = this.app.store.get("state")?.file ? (this.active?.hint() ?? "") : "";
    this.hintLine.textContent = hint;
    this.hintLine.hidden = hint === "";
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0) return;
    const claimed = !event.shiftKey && !event.ctrlKey && (this.active?.press?.(event) ?? false);
    this.pressed = { x: event.clientX, y: event.clientY, claimed };
    this.app.viewport.controls.enabled = !claimed;
  }

  private move(event: PointerEvent): void {
    if (this.pressed?.claimed) this.active?.drag?.(event);
    else if (!this.pressed && event.target === this.app.viewport.canvas) this.active?.hover?.(event);
  }

  private up(event: PointerEvent): void {
    const pressed = this.pressed;
    this.pressed = null;
    this.app.viewport.controls.enabled = true;
    if (!pressed || event.button !== 0) return;
    if (pressed.claimed) this.active?.release?.(event);
    else if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) < clickTolerance) this.active?.click?.(event);
  }
}
