// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
// Bundles src/ into dist/report.html, one page without its data: npm ci && npm run build
import { build } from "esbuild";
import { mkdir, readFile, writeFile } from "node:fs/promises";

const bundle = async (entry) => {
  const result = await build({ entryPoints: [entry], bundle: true, minify: true, write: false, format: "iife", target: "es2022", legalComments: "inline" });
  return result.outputFiles[0].text.trim();
};
const page = await readFile("src/page.html", "utf8");
const style = await bundle("src/style.css"), program = await bundle("src/main.js");
await mkdir("dist", { recursive: true });
await writeFile("dist/report.html", page.replace("/*style*/", () => style).replace("/*program*/", () => program));
