// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of data. Values are sRGB from 0 to 1: the page does no colour management.

export type Rgb = readonly [number, number, number];

function hex(code: string): Rgb {
  const value = parseInt(code.slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

/** Soft colours for charts; neighbours in the list are far apart in hue. */
export const chartPalette = [
  "#7fb8d8", "#e8b27c", "#9ccb8f", "#d691a9", "#b5a2dc", "#e3d37a", "#79c8bd", "#e2978a", "#a9b8c6", "#c7b08d",
  "#8ea5e0", "#c5d685",
].map(hex);

export function chartColour(chart: number): Rgb {
  return chart < 0 ? [0.6, 0.6, 0.6] : chartPalette[chart % chartPalette.length]!;
}

// Told apart without red and green: orange is bad, blue is good, and the lightness alone orders what is off.
const qualityStops = ["#6e2503", "#cf5206", "#f59a48", "#fbdcb4", "#b4d0ea", "#4f8fcc"].map(hex);
const deviationStops = ["#e9e7e0", "#f7cf7a", "#ee9440", "#bd4a2a", "#5b1a3e"].map(hex);
const fieldStops = ["#2f63b5", "#7fb2dd", "#efe6d2", "#ee9a6b", "#b8322f"].map(hex);

function along(stops: readonly Rgb[], t: number): Rgb {
  const place = Math.min(Math.max(t, 0), 1) * (stops.length - 1);
  const i = Math.min(Math.floor(place), stops.length - 2);
  const a = stops[i]!, b = stops[i + 1]!, f = place - i;
  return [a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])];
}

/** The colour of a scaled Jacobian from -1 to 1: the interesting half of the range takes most of the colours. */
export function qualityColour(scaledJacobian: number): Rgb {
  return scaledJacobian <= 0 ? qualityStops[0]! : along(qualityStops.slice(1), scaledJacobian ** 1.5);
}
/** From no distance to the end of the scale. */
export function deviationColour(part: number): Rgb {
  return along(deviationStops, part);
}
export function fieldColour(value: number): Rgb {
  return along(fieldStops, value);
}
export function css(colour: Rgb): string {
  return `rgb(${colour.map((c) => Math.round(255 * c)).join(" ")})`;
}

/** Valences: warm below 4, cool above it, stronger the further away. */
export function valenceColour(valence: number, onBoundary: boolean): Rgb {
  const difference = valence - (onBoundary ? 3 : 4);
  if (difference < 0) return difference === -1 ? hex("#ffb02e") : hex("#ff6a2e");
  return [hex("#4aa8ff"), hex("#3d7bff"), hex("#6a4dff"), hex("#b13dff")][Math.min(difference - 1, 3)]!;
}

export const criticalColours: readonly Rgb[] = [
  hex("#3f8cff"), hex("#ffd34d"), hex("#ff5147"), hex("#ff9d3d"), hex("#c98cff"),
]; // minimum, saddle, maximum, half-saddle, quarter-saddle
