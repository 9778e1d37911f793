// monitor/web/vite.config.ts: how the page is bundled: one script, one style sheet, relative paths.
import { defineConfig } from "vite";

export default defineConfig({
  base: "./",
  build: { target: "es2022", assetsInlineLimit: 0, modulePreload: false },
});
