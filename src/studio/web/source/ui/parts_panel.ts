// SPDX-License-Identifier: GPL-3.0-or-later
import type { PartFacts } from "../net/messages";
import type { Store } from "../store";
import { h, readable, replace } from "./dom";

/** The connected parts of the file, where it has several; a click works on one. */
export function partsPanel(store: Store, choose: (component: number) => void): HTMLElement {
  const list = h("div", { className: "part-list" });
  const panel = h("details", { open: true, className: "panel", hidden: true }, h("summary", {}, "Parts"), list);
  store.watch(["state"], () => {
    const file = store.get("state")?.file, parts = file?.components ?? [];
    panel.hidden = parts.length < 2;
    replace(
      list,
      ...parts.map((part, i) =>
        h(
          "button",
          { className: `ghost part ${file?.component === i + 1 ? "chosen" : ""}`, "data-part": String(i + 1), "aria-pressed": String(file?.component === i + 1), title: about(part), onclick: () => choose(i + 1) },
          h("span", { className: "name" }, `Part ${i + 1}`, h("em", {}, ` ${topology(part)}`)),
          h("span", { className: "time" }, part.quads > 0 ? `${readable(part.quads)} quads` : `${readable(part.triangles)} triangles`),
        ),
      ),
    );
  });
  return panel;
}

function topology(part: PartFacts): string {
  const words = [
    part.genus > 0 && `${part.genus} ${part.genus === 1 ? "handle" : "handles"}`,
    part.boundary_loops > 0 && `${part.boundary_loops} ${part.boundary_loops === 1 ? "hole" : "holes"}`,
  ].filter(Boolean);
  return words.join(", ");
}

function about(part: PartFacts): string {
  return `${readable(part.triangles)} triangles, genus ${part.genus}, ${part.boundary_loops} boundary loops, ${part.edits} edits`;
}
