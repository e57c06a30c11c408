// SPDX-License-Identifier: GPL-3.0-or-later
// The viewer of HTML reports: one script with everything in it, its style too.
import { defineConfig } from "vite";

export default defineConfig({
  publicDir: false,
  define: { "process.env.NODE_ENV": '"production"' },
  build: {
    target: "es2022",
    emptyOutDir: false,
    lib: { entry: "source/report/main.ts", formats: ["iife"], name: "report", fileName: () => "report.js" },
    chunkSizeWarningLimit: 2000,
  },
});
