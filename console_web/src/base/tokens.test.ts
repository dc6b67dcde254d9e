// The written scale holds: no style sheet but tokens.css says a size or a colour of its own.
import { describe, expect, it } from "vitest";

const LITERAL = /(?<![\w-])-?\d*\.?\d+(px|rem|pt|cm|mm)\b|#[0-9a-f]{3,8}\b|\b(rgb|hsl|oklch)a?\(/gi;
const sheets = Object.entries(
  import.meta.glob<string>("../**/*.css", { query: "?raw", import: "default", eager: true }),
);
const scripts = Object.entries(
  import.meta.glob<string>(["../**/*.{ts,tsx}", "!../**/*.test.ts"], {
    query: "?raw",
    import: "default",
    eager: true,
  }),
);

/** A sheet without comments and the conditions of its queries, which cannot use tokens. */
function declarations(sheet: string): string {
  return sheet.replace(/\/\*[\s\S]*?\*\//g, "").replace(/@(media|container)[^{]*/g, "");
}

describe("style sheets", () => {
  it.each(sheets.filter(([name]) => !/\/(tokens|modes)\.css$/.test(name)))(
    "%s takes sizes and colours from the tokens",
    (_, sheet) => {
      expect(sheet).not.toBe("");
      expect(declarations(sheet).match(LITERAL) ?? []).toEqual([]);
    },
  );

  it("use no token that nobody declares, nor do canvases", () => {
    const styles = sheets.map(([, sheet]) => declarations(sheet)).join("\n");
    const code = scripts.map(([, script]) => script).join("\n");
    const declared = new Set([...(styles + code).matchAll(/(--[\w-]+)"?:/g)].map((match) => match[1]));
    const inStyles = [...styles.matchAll(/var\((--[\w-]+)/g)];
    const inCode = [...code.matchAll(/(?:colour|font)\("(--[\w-]+)"/g)];
    expect(inCode.length).toBeGreaterThan(5);
    const used = [...inStyles, ...inCode].map((match) => match[1]);
    expect(used.filter((name) => !declared.has(name))).toEqual([]);
  });
});
