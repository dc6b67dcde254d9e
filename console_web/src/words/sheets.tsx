// The pop-over of one word, the glossary and the palette.
import { sheet } from "./asked";
import { Glossary } from "./glossary";
import { Palette } from "./palette";
import "./sheets.css";
import { WordCard } from "./word_card";

export function Sheets() {
  return (
    <>
      <WordCard />
      {sheet.value === "glossary" && <Glossary />}
      {sheet.value === "palette" && <Palette />}
    </>
  );
}
