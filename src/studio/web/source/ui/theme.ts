// SPDX-License-Identifier: GPL-3.0-or-later
export type ThemeName = "dark" | "light";

export interface Theme {
  toggle(): void;
  set(theme: ThemeName): void;
}

export function startTheme(changed: (theme: ThemeName) => void): Theme {
  const apply = (theme: ThemeName): void => {
    document.documentElement.dataset.theme = theme;
    remember(theme);
    changed(theme);
  };
  const kept = remembered();
  const preferred = matchMedia("(prefers-color-scheme: light)").matches ? "light" : "dark";
  let theme: ThemeName = kept === "light" || kept === "dark" ? kept : preferred;
  apply(theme);
  const set = (next: ThemeName): void => apply((theme = next));
  return { set, toggle: () => set(theme === "dark" ? "light" : "dark") };
}

// A file that is opened from disk may have no storage.
function remember(theme: ThemeName): void {
  try {
    localStorage.setItem("theme", theme);
  } catch {
    return;
  }
}

function remembered(): string | null {
  try {
    return localStorage.getItem("theme");
  } catch {
    return null;
  }
}
