// SPDX-License-Identifier: GPL-3.0-or-later
import { css, qualityColour } from "../scene/colours";
import type { Store } from "../store";
import { h, readable, replace } from "./dom";

export type Bin = { low: number; high: number } | null;

/** The histogram of the quads' quality; a click on a bar lets those quads shine. */
export function qualityPanel(store: Store, choose: (bin: Bin) => void): HTMLElement {
  const host = h("div", { className: "quality" });
  let chosen = -1;
  const draw = (): void => {
    const statistics = store.get("state")?.statistics;
    if (!statistics) return replace(host, h("p", { className: "empty" }, "There are no quads yet."));
    const all = statistics.scaled_jacobian_histogram;
    const first = Math.min(all.findIndex((n) => n > 0), 10); // bars below zero only where there are such quads
    const most = Math.max(...all, 1);
    const width = 2 / all.length;
    const bars = all.slice(first).map((number, i) => {
      const bin = first + i, low = -1 + bin * width, high = low + width;
      const bar = h(
        "button",
        {
          className: `bar ${chosen === bin ? "chosen" : ""}`, disabled: number === 0, "data-bin": String(bin),
          title: `${readable(number)} quads from ${low.toFixed(1)} to ${high.toFixed(1)}`,
          onclick: () => {
            chosen = chosen === bin ? -1 : bin;
            choose(chosen < 0 ? null : { low, high });
            draw();
          },
        },
        h("span", {}),
      );
      const fill = bar.firstElementChild as HTMLElement;
      fill.style.height = `${number ? Math.max(3, 100 * Math.sqrt(number / most)) : 0}%`;
      fill.style.background = css(qualityColour((low + high) / 2));
      return bar;
    });
    const q = statistics.scaled_jacobian;
    replace(
      host,
      h("div", { className: "bars", role: "group", "aria-label": "Quads by quality" }, ...bars),
      h("div", { className: "axis" }, h("span", {}, (-1 + first * width).toFixed(1)), h("span", {}, "scaled Jacobian"), h("span", {}, "1")),
      h(
        "dl", { className: "facts" },
        h("dt", {}, "mean"), h("dd", {}, q.mean.toFixed(3)), h("dt", {}, "worst"), h("dd", {}, q.minimum.toFixed(3)),
        h("dt", {}, "folded"), h("dd", { className: statistics.inverted_quads ? "warn" : "" }, readable(statistics.inverted_quads)),
      ),
      h("p", { className: "note" }, "1 is a rectangle, 0 or less is folded. Click a bar to see its quads."),
    );
  };
  store.watch(["state"], () => {
    if (chosen >= 0) choose(null);
    chosen = -1;
    draw();
  });
  return host;
}
