// SPDX-License-Identifier: GPL-3.0-or-later
export type ThemeName = "dark" | "light";

export function startTheme(changed: (theme: ThemeName) => void): () => void {
  const apply = (theme: ThemeName): void => {
    document.documentElement.dataset.theme = theme;
    localStorage.setItem("theme", theme);
    changed(theme);
  };
  const kept = localStorage.getItem("theme");
  const preferred = matchMedia("(prefers-color-scheme: light)").matches ? "light" : "dark";
  let theme: ThemeName = kept === "light" || kept === "dark" ? kept : preferred;
  apply(theme);
  return () => apply((theme = theme === "dark" ? "light" : "dark"));
}
