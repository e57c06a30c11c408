// SPDX-License-Identifier: GPL-3.0-or-later
// The layers that can be shown, their keys, and the views that turn on a sensible choice of them.

export type LayerId =
  | "surface" | "field" | "isolines" | "charts" | "contours" | "critical" | "reeb" | "textures" | "quads" | "valences" | "quality" | "wireframe" | "deviation" | "xray";

export interface LayerInfo {
  id: LayerId;
  name: string;
  key: string;
  about: string;
}

export const layerList: readonly LayerInfo[] = [
  { id: "surface", name: "Surface", key: "1", about: "The mesh that came in" },
  { id: "field", name: "Field", key: "2", about: "The function whose level lines guide the quads: blue is low, red is high" },
  { id: "isolines", name: "Isolines", key: "3", about: "Level lines of the field: quads will run along and across them" },
  { id: "charts", name: "Charts", key: "4", about: "The pieces between the contours; each is filled with a grid of quads" },
  { id: "contours", name: "Contours", key: "5", about: "The curves along which the surface is cut into charts; those with a light middle run through no saddle" },
  { id: "critical", name: "Critical points", key: "6", about: "Minima, saddles and maxima of the field" },
  { id: "reeb", name: "Reeb graph", key: "7", about: "One line for each chart, joined where the charts meet" },
  { id: "textures", name: "Textures", key: "t", about: "The grids that fill the charts, before the quads are relaxed" },
  { id: "quads", name: "Quads", key: "8", about: "The quad mesh" },
  { id: "valences", name: "Extraordinary vertices", key: "9", about: "Where not four edges meet; the sign has as many corners as edges" },
  { id: "quality", name: "Quality", key: "0", about: "Blue quads are rectangles, orange ones are skewed, brown ones folded" },
  { id: "deviation", name: "Deviation", key: "b", about: "How far surface and quads are from each other; dark orange lines are sharp edges that no quads follow" },
  { id: "wireframe", name: "Edges of quads", key: "f", about: "The quads' edges, on the surface" },
  { id: "xray", name: "X-ray", key: "x", about: "See through the surface" },
];

export type ViewId = "surface" | "field" | "atlas" | "quads" | "quality" | "deviation";

export const views: Record<ViewId, { name: string; about: string; layers: LayerId[] }> = {
  surface: { name: "Surface", about: "The mesh that came in", layers: ["surface"] },
  field: { name: "Field", about: "The field with its critical points", layers: ["surface", "field", "isolines", "critical", "contours"] },
  atlas: { name: "Atlas", about: "Charts, contours and Reeb graph", layers: ["surface", "charts", "contours", "critical"] },
  quads: { name: "Quads", about: "The quad mesh", layers: ["quads", "valences"] },
  quality: { name: "Quality", about: "How good the quads are", layers: ["quads", "quality"] },
  deviation: { name: "Deviation", about: "How far the quads are from the surface", layers: ["surface", "deviation", "wireframe"] },
};

/** Layers that colour the same thing: turning one on turns the others off. */
const rivals: LayerId[][] = [
  ["field", "charts", "deviation"],
  ["quality", "deviation"],
  ["surface", "quads"],
];

/** The layers after one was switched, with its rivals off. */
export function switched(shown: ReadonlySet<LayerId>, layer: LayerId): Set<LayerId> {
  const next = new Set(shown);
  if (next.delete(layer)) return next;
  next.add(layer);
  // The edges stay where the surface takes the place of the quads, which have them anyway.
  if (layer === "surface" && next.has("quads")) next.add("wireframe");
  if (layer === "quads" || layer === "quality") next.delete("wireframe");
  for (const group of rivals) if (group.includes(layer)) for (const other of group) if (other !== layer) next.delete(other);
  if (layer === "field" || layer === "charts" || layer === "isolines" || layer === "textures" || layer === "wireframe") return next.add("surface") && without(next, "quads");
  if (layer === "deviation" && !next.has("quads")) next.add("surface");
  if (layer === "quality") return next.add("quads") && without(next, "surface");
  return next;
}

function without(set: Set<LayerId>, layer: LayerId): Set<LayerId> {
  set.delete(layer);
  return set;
}
