// The page before the console: name and password, and what the server says to them. No other part of it is loaded.
import "../base/tokens.css";
import "../base/base.css";
import "../base/parts.css";
import "./login.css";

const form = document.querySelector<HTMLFormElement>("#login");
const why = document.querySelector<HTMLElement>("#why");

/** The sentence that says why not. */
async function refused(answer: Response): Promise<string> {
  try {
    const told = (await answer.json()) as { detail?: string };
    if (told.detail) return told.detail;
  } catch {
    // not our answer: a proxy's, perhaps
  }
  return `The server answered ${answer.status}.`;
}

async function logIn(given: HTMLFormElement, say: (text: string) => void): Promise<void> {
  const button = given.querySelector("button");
  if (button?.getAttribute("aria-disabled") === "true") return;
  const password = given.querySelector<HTMLInputElement>("[name=password]");
  bar(button, "The server is being asked");
  say("");
  const body = JSON.stringify(Object.fromEntries(new FormData(given)));
  const headers = { "content-type": "application/json" };
  try {
    const answer = await fetch("./api/login", { method: "POST", headers, body, cache: "no-store" });
    if (answer.ok) {
      location.replace(`./${location.hash}`);
      return;
    }
    say(await refused(answer));
    if (password) {
      password.value = "";
      password.focus();
    }
  } catch {
    say("The server cannot be reached.");
  }
  bar(button, "");
}

/** Out of use, and why; "": in use again. A disabled button would drop the keyboard's place. */
function bar(button: HTMLButtonElement | null, why: string): void {
  button?.setAttribute("aria-disabled", String(why !== ""));
  if (button) button.title = why;
}

form?.addEventListener("submit", (event) => {
  event.preventDefault();
  void logIn(form, (text) => {
    if (why)
      why.textContent =
        text && `${text.charAt(0).toUpperCase()}${text.slice(1)}${/[.!?]$/.test(text) ? "" : "."}`;
  });
});
