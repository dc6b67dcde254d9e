// A YAML file with line numbers and quiet colours for keys and comments.
import "./yaml_text.css";

const LINE = /^(\s*(?:- )?)([A-Za-z_][\w.-]*)(:)(.*)$/;

export function YamlText({ text }: { text: string }) {
  return (
    <pre class="yaml" role="region" tabIndex={0} aria-label="Mission file">
      {text
        .replace(/\n$/, "")
        .split("\n")
        .map((line, index) => (
          <span key={index} class="yaml-line" data-line={index + 1}>
            <Line text={line} />
            {"\n"}
          </span>
        ))}
    </pre>
  );
}

function Line({ text }: { text: string }) {
  const { body, comment } = splitComment(text);
  const match = LINE.exec(body);
  return (
    <>
      {match ? (
        <>
          {match[1]}
          <span class="yaml-key">{match[2]}</span>
          {match[3]}
          {match[4]}
        </>
      ) : (
        body
      )}
      {comment && <span class="yaml-comment">{comment}</span>}
    </>
  );
}

/** "#" begins a comment at the start or after a space, outside quotes. */
function splitComment(text: string): { body: string; comment: string } {
  let quote = "";
  for (let i = 0; i < text.length; i++) {
    const c = text[i] as string;
    if (quote) {
      if (c === quote) quote = "";
    } else if ((c === '"' || c === "'") && (i === 0 || " [{,:".includes(text[i - 1] as string))) quote = c;
    else if (c === "#" && (i === 0 || text[i - 1] === " "))
      return { body: text.slice(0, i), comment: text.slice(i) };
  }
  return { body: text, comment: "" };
}
