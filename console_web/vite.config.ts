import { defineConfig } from "vite";

// Relative asset paths: the server may mount the console anywhere on its origin.
export default defineConfig({
  base: "./",
  oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
  build: { target: "es2022", outDir: "dist", emptyOutDir: true, assetsInlineLimit: 0, sourcemap: false },
  server: {
    proxy: {
      "/api": { target: "http://127.0.0.1:8080", ws: true },
      "/scene": { target: "http://127.0.0.1:8080", ws: true },
    },
  },
});
