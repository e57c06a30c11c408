// SPDX-License-Identifier: GPL-3.0-or-later
// One word for one thing: what the engine says, in the words of the page's lists and buttons.
import type { ChartFacts } from "../net/messages";

const words: readonly [RegExp, string][] = [
  [/\bneither an annulus nor a disc with one extremum\b.*/, "neither a tube nor a cap with one extremum"],
  [/\bannuli\b/g, "tubes"],
  [/\ban annulus\b/g, "a tube"],
  [/\bannulus\b/g, "tube"],
  [/\bdiscs\b/g, "caps"],
  [/\bdisc\b/g, "cap"],
  [/\breset it first\b/g, "press “Regular” first"],
];

/** A sentence of the engine as the page says it. */
export function plain(sentence: string): string {
  return words.reduce((text, [from, to]) => text.replace(from, to), sentence);
}

/** A chart as lists name it. */
export function chartName(chart: Pick<ChartFacts, "id" | "kind">): string {
  return `${chart.kind === "disc" ? "Cap" : "Tube"} ${chart.id}`;
}

/** Of an element that the engine names by a number, " (Cap 5)"; nothing where the number means nothing to a reader. */
export function elementName(element: string, index: number, charts: readonly ChartFacts[]): string {
  const chart = element === "chart" ? charts.find((c) => c.id === index) : undefined;
  return chart ? ` (${chartName(chart)})` : "";
}
