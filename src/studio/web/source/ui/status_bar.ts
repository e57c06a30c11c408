// SPDX-License-Identifier: GPL-3.0-or-later
import type { Deviation, State } from "../net/messages";
import type { Store } from "../store";
import { h, readable, replace } from "./dom";
import { time } from "./history_panel";

/** More than this part of the diagonal is worth a warning. */
const farPart = 0.01;

/** The line below: what is open, how many quads, whether they are certified, and the index budget. */
export function statusBar(store: Store, certify: () => void): HTMLElement {
  const bar = h("footer", { className: "status" });
  store.watch(["state", "connected", "deviation"], () => {
    const state = store.get("state");
    replace(
      bar,
      !store.get("connected") && h("span", { className: "offline" }, "Not connected: trying again …"),
      state?.file &&
        h("span", { title: "Triangles of the surface, and its handles" }, `${state.file.name} · ${readable(state.file.triangles)} triangles · genus ${state.file.genus}`),
      state?.statistics && h("span", { className: "counts", "data-quads": String(state.statistics.quads) }, `${readable(state.statistics.quads)} quads · ${readable(state.statistics.vertices)} vertices`),
      state?.statistics && (state.certificate ? light(state, certify) : h("span", { className: "checking" }, h("span", { className: "light grey" }), "checking")),
      kept(store.get("deviation")),
      state?.facts?.fans && h("span", { className: "fans", title: state.facts.fans }, "with fans of triangles"),
      state?.budget && budget(state),
      h("span", { className: "spring" }),
      state?.last && h("span", { className: state.last.ok ? "last" : "last bad", title: state.last.text }, lastText(state)),
    );
  });
  return bar;
}

/** A mesh may be valid and yet not what the surface was: the greatest distance, and what is lost. */
function kept(deviation: Deviation | null): HTMLElement | null {
  if (!deviation) return null;
  const { diagonal, of_surface, of_quads, lost_corners, sharp_length, lost_sharp_length } = deviation, part = Math.max(of_surface, of_quads) / diagonal;
  const lost = [
    lost_corners.length > 0 && `${lost_corners.length} ${lost_corners.length === 1 ? "corner" : "corners"} lost`,
    lost_sharp_length > 0.02 * sharp_length && `${Math.round((100 * lost_sharp_length) / sharp_length)} % of sharp edges cut through`,
  ].filter(Boolean);
  const far = part > farPart;
  return h(
    "span", { className: `kept ${far || lost.length ? "warn" : ""}`, title: "The greatest distance that was measured between surface and quads, by the diagonal; the panel Deviation shows where" },
    `off by ${(100 * part).toPrecision(2)} %`, ...lost.map((text) => `, ${text as string}`),
  );
}

function lastText(state: State): string {
  const last = state.last!;
  return last.milliseconds === undefined ? last.text : `${last.text} · ${time(last.milliseconds)}`;
}

function light(state: State, certify: () => void): HTMLElement {
  const certificate = state.certificate!;
  const failed = certificate.checks.filter((c) => c.status === "failed");
  const waiting = certificate.checks.filter((c) => c.status === "not_checked");
  const soft = certificate.passed && (failed.length > 0 || certificate.warnings.length > 0);
  const colour = !certificate.passed ? "red" : soft ? "amber" : "green";
  const text = !certificate.passed ? "not valid" : soft ? "valid, with remarks" : certificate.strictly_valid ? "certified" : "valid";
  const lines = [...failed.map((c) => `✗ ${c.name}: ${c.message}`), ...waiting.map((c) => `· ${c.name}: not checked yet`)];
  if (certificate.shape) lines.push(`kept: ${certificate.shape.summary}`, ...certificate.warnings.map((w) => `! ${w.text}`));
  return h(
    "button",
    { className: "ghost certificate", "data-light": colour, title: [`Click for all checks, also the slow ones.`, ...lines].join("\n"), onclick: certify },
    h("span", { className: `light ${colour}` }), text,
  );
}

/** Sums 4 - valence (3 - valence on the boundary): the surface prescribes it, whatever the quads are. */
function budget(state: State): HTMLElement {
  const { needed, interior, boundary } = state.budget!;
  const parts: string[] = [];
  let sum = 0;
  const count = (valences: Record<string, number>, regular: number, where: string): void => {
    for (const [valence, number] of Object.entries(valences)) {
      if (Number(valence) === regular) continue;
      sum += (regular - Number(valence)) * number;
      parts.push(`${number} × valence ${valence}${where}`);
    }
  };
  count(interior, 4, "");
  count(boundary, 3, " on the boundary");
  const explanation =
    `On this surface 4 − valence, summed over all vertices (3 − valence on the boundary), is always 4χ = ${needed}. ` +
    "Poles (valence 3) add 1, saddles (valence 8) take away 4: the design can only choose where they are and how they balance. ";
  return h(
    "span", { className: "budget", title: explanation + (parts.length ? `\nNow: ${parts.join(", ")}.` : "") },
    "index ", ...(parts.length || needed === 0 ? [h("strong", {}, signed(sum)), ` of ${signed(needed)}`] : ["needed ", h("strong", {}, signed(needed))]), parts.length > 0 && h("em", {}, ` (${parts.slice(0, 4).join(", ")}${parts.length > 4 ? " …" : ""})`),
  );
}

function signed(value: number): string {
  return value < 0 ? `−${-value}` : String(value);
}
