// SPDX-License-Identifier: GPL-3.0-or-later
import type { Connection } from "../net/connection";
import type { SavedSession } from "../net/messages";
import type { Store } from "../store";
import { h, readable, replace } from "./dom";
import { question } from "./question";
import { sessionCards } from "./sessions";

interface Listed {
  name: string;
  bytes: number;
}

interface Listing {
  folder: string;
  files: Listed[];
  recipes: Listed[];
  sessions: SavedSession[];
}

/** What the dialog can do. */
export interface Opening {
  connection: Connection;
  store: Store;
  /** A mesh or a recipe from anywhere. */
  take(file: File): void;
  openMesh(name: string): void;
  openRecipe(name: string): void;
  restore(digest: string): void;
}

/** The dialog that opens meshes, earlier work and recipes: from the folder of the program, or from anywhere by upload. */
export function openDialog(opening: Opening): () => void {
  const { connection, store } = opening;
  const input = h("input", { type: "file", accept: ".obj,.off,.ply,.stl,.json", hidden: true, id: "file-input", "aria-label": "A mesh or a recipe" });
  const found = h("div", { className: "file-list" });
  const filter = h("input", { type: "search", placeholder: "Filter", "aria-label": "Filter the files" });
  const dialog = h(
    "dialog", { className: "dialog open-dialog", "aria-label": "Open" },
    h("header", {}, h("h2", {}, "Open"), h("button", { className: "ghost", onclick: () => dialog.close() }, "Close")),
    h("p", { className: "note" }, "A mesh as OBJ, OFF, PLY or STL, at most 1 GiB, or a recipe. Nothing leaves this machine, and the work on the mesh that is open is kept."),
    h("div", { className: "row" }, h("button", { className: "primary", onclick: () => input.click() }, "Choose a file …"), filter),
    found,
  );
  document.body.append(dialog, input);
  input.onchange = () => {
    const file = input.files?.[0];
    input.value = "";
    if (!file) return;
    dialog.close();
    opening.take(file);
  };
  let listing: Listing = { folder: "", files: [], recipes: [], sessions: [] };
  const look = async (): Promise<void> => {
    listing = (await connection.request("list_files")) as Listing;
    draw();
  };
  const forget = async (session: SavedSession): Promise<void> => {
    const lost = `${session.edits} ${session.edits === 1 ? "edit" : "edits"} and the mesh, if it was not in this folder, cannot be brought back.`;
    if (session.edits > 0 && (await question(`Forget the work on ${session.name}?`, lost, [{ id: "forget", name: "Forget it" }])) === null) return;
    await connection.request("forget", { digest: session.digest });
    await look();
  };
  const rows = (files: readonly Listed[], open: (name: string) => void, kind: string, disabled = false): HTMLElement[] =>
    files.slice(0, 200).map((f) =>
      h(
        "button", { className: "ghost file", "data-file": f.name, "data-kind": kind, disabled, title: disabled ? "Open the mesh of the recipe first" : "", onclick: () => (dialog.close(), open(f.name)) },
        h("span", { className: "name" }, f.name), h("span", { className: "time" }, size(f.bytes)),
      ),
    );
  const draw = (): void => {
    const word = filter.value.toLowerCase(), fits = ({ name }: { name: string }): boolean => name.toLowerCase().includes(word);
    const open = store.get("state")?.file;
    const meshes = listing.files.filter(fits), recipes = listing.recipes.filter(fits), sessions = listing.sessions.filter((s) => fits(s) && (s.edits > 0 || s.digest === open?.digest)).slice(0, 12);
    replace(
      found,
      sessions.length > 0 && h("h3", {}, "Go on with"),
      sessions.length > 0 && sessionCards(sessions, (digest) => (dialog.close(), opening.restore(digest)), (session) => void forget(session), open?.digest),
      h("h3", {}, `Meshes in the folder ${listing.folder}`), ...rows(meshes, opening.openMesh, "mesh"),
      meshes.length === 0 && h("p", { className: "empty" }, "No meshes here."),
      recipes.length > 0 && h("h3", {}, open ? `Recipes, for ${open.name}` : "Recipes"), ...rows(recipes, opening.openRecipe, "recipe", !open),
    );
  };
  filter.oninput = draw;
  return () => {
    filter.value = "";
    void look();
    if (!dialog.open) dialog.showModal();
  };
}

function size(bytes: number): string {
  return bytes > 1e6 ? `${(bytes / 1e6).toFixed(1)} MB` : `${readable(Math.ceil(bytes / 1e3))} kB`;
}
