// SPDX-License-Identifier: GPL-3.0-or-later
import { defineConfig } from "vite";

export default defineConfig({
  build: {
    target: "es2022",
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0, // everything is a file of its own: the policy allows nothing inline
    chunkSizeWarningLimit: 2000,
  },
});
