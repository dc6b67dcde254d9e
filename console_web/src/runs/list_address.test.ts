import { expect, test } from "vitest";
import { USUAL } from "./columns";
import { asked, tell } from "./list_address";

test("what is as usual is not said, and an address without a word changes nothing", () => {
  expect(tell({ words: " ", outcome: "", columns: USUAL })).toEqual({});
  expect(asked({})).toBeUndefined();
  expect(asked({ t: "3" })).toBeUndefined();
});

test("what is said comes back", () => {
  const shown = { words: "sea trial", outcome: "docked", columns: ["duration", "seed"] } as const;
  expect(asked(tell(shown))).toEqual(shown);
  expect(asked({ find: "a" })).toEqual({ words: "a", outcome: "", columns: USUAL });
});

test("what an address can't mean is left out", () => {
  expect(asked({ outcome: "constructor", columns: "seed,__proto__,x" })).toEqual({
    words: "",
    outcome: "",
    columns: ["seed"],
  });
});
