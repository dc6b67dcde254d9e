// The plan flown ahead by the server: asked at each edit, the newest edit alone counts.
import {
  batch,
  computed,
  effect,
  type ReadonlySignal,
  type Signal,
  signal,
  untracked,
} from "@preact/signals";
import type { components } from "../../gen/api";
import type { Held } from "../../lib/held";
import { endingNamed } from "../../ui/endings";
import { hashOf } from "../model/hash";

type Schemas = components["schemas"];
export type Finding = Schemas["ForesightFinding"];
export type Mend = Schemas["ForesightMend"];
export type Nominal = Schemas["ForesightNominal"];
export type Flight = Schemas["ForesightFlight"];
export type Chance = Schemas["ForesightChance"];
export type SeaFloor = Schemas["ForesightFloor"];
export type TextProblem = Schemas["ForesightProblem"];
export type Overrides = Schemas["Overrides"];
type Message = Schemas["ForesightMessage"];

/** What the server has told of one text. */
export interface Forecast {
  /** The text that it is of. */
  text: string;
  problems: TextProblem[];
  findings: Finding[] | undefined;
  /** The sea floor along the plan; undefined: the mission names none. */
  floor: SeaFloor | undefined;
  /** Which headings hold station in the plan's current; undefined: the vehicle does not hover. */
  station: Held | undefined;
  nominal: Nominal | undefined;
  flights: Flight[];
  chance: Chance | undefined;
  /** Flights asked for. */
  of: number;
  state: "flying" | "done" | "failed";
  reason: string;
}

export type LinkState = "closed" | "connecting" | "open" | "lost";

const FIRST_RETRY_MS = 500;
const LAST_RETRY_MS = 5000;

function url(): string {
  const to = new URL("./ws/foresight", location.href);
  to.protocol = to.protocol === "https:" ? "wss:" : "ws:";
  to.hash = "";
  return to.href;
}

function fresh(text: string): Forecast {
  return {
    text,
    problems: [],
    findings: undefined,
    floor: undefined,
    station: undefined,
    nominal: undefined,
    flights: [],
    chance: undefined,
    of: 0,
    state: "flying",
    reason: "",
  };
}

/** A forecast after one more message of its request. */
export function told(before: Forecast, message: Message): Forecast {
  switch (message.kind) {
    case "problems":
      return { ...before, problems: message.problems, findings: [], state: "done" };
    case "findings":
      return {
        ...before,
        findings: message.findings,
        floor: message.floor ?? undefined,
        station: message.station ?? undefined,
      };
    case "nominal":
      return { ...before, nominal: message };
    case "fan":
      return {
        ...before,
        flights: [...before.flights, ...message.flights],
        chance: message.chance,
        of: message.of,
      };
    case "done":
      return { ...before, state: "done" };
    case "failed":
      return { ...before, state: "failed", reason: message.reason };
  }
}

export interface Ask {
  text: string;
  flights: number;
  overrides?: Overrides;
}

/** One line of foresight: each request takes the place of the one before. */
export class Foresight {
  readonly link = signal<LinkState>("closed");
  /** What is shown: the newest request that something has come of. */
  readonly shown: Signal<Forecast | undefined> = signal<Forecast | undefined>(undefined);
  /** Edit to nominal track received, ms. */
  readonly latencyMs = signal<number | undefined>(undefined);
  readonly asked = signal("");
  private socket: WebSocket | undefined;
  private id = 0;
  private sent = 0;
  private growing: Forecast | undefined;
  private last: Ask | undefined;
  private retryMs = FIRST_RETRY_MS;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private wanted = false;

  open(): void {
    this.wanted = true;
    clearTimeout(this.timer);
    if (this.socket) return;
    this.link.value = "connecting";
    const socket = new WebSocket(url());
    this.socket = socket;
    socket.onopen = () => {
      this.retryMs = FIRST_RETRY_MS;
      this.link.value = "open";
      if (this.last) this.send(this.last);
    };
    socket.onmessage = (event: MessageEvent<string>) => this.receive(event.data);
    socket.onclose = () => {
      if (this.socket !== socket) return;
      this.socket = undefined;
      this.link.value = this.wanted ? "lost" : "closed";
      if (!this.wanted) return;
      this.timer = setTimeout(() => this.open(), this.retryMs);
      this.retryMs = Math.min(LAST_RETRY_MS, this.retryMs * 1.7);
    };
  }

  close(): void {
    this.wanted = false;
    clearTimeout(this.timer);
    const socket = this.socket;
    this.socket = undefined;
    socket?.close();
    this.link.value = "closed";
  }

  ask(wanted: Ask): void {
    this.last = wanted;
    this.asked.value = wanted.text;
    if (this.link.peek() === "open") this.send(wanted);
  }

  /** Forget what was shown: another plan is open. */
  clear(): void {
    this.last = undefined;
    this.growing = undefined;
    this.id += 1;
    this.shown.value = undefined;
    this.asked.value = "";
  }

  private send({ text, flights, overrides }: Ask): void {
    this.id += 1;
    this.sent = performance.now();
    this.growing = fresh(text);
    this.socket?.send(JSON.stringify({ id: this.id, text, flights, ...(overrides ? { overrides } : {}) }));
  }

  private receive(data: string): void {
    const message = JSON.parse(data) as Message;
    if (message.id !== this.id || !this.growing) return; // of an edit that is past
    this.growing = told(this.growing, message);
    const grown = this.growing;
    batch(() => {
      if (message.kind === "nominal") this.latencyMs.value = performance.now() - this.sent;
      // Findings alone would blank the track for a moment: shown together with it.
      if (message.kind !== "findings" || !this.shown.peek()?.nominal) this.shown.value = grown;
    });
  }
}

export const FLIGHTS = 200;

/** The forecast of the plan as it is shown, with whether it is of this very text. */
export class PlanForesight {
  readonly line = new Foresight();
  readonly forecast = computed(() => this.line.shown.value);
  readonly current: ReadonlySignal<boolean>;
  /** Seed of the flight that is picked out of the fan. */
  readonly picked = signal<number | undefined>(undefined);

  constructor(private readonly text: { readonly value: string }) {
    this.current = computed(() => this.forecast.value?.text === this.text.value);
  }

  /** Ask at each change of the text. */
  follow(ready: () => boolean): () => void {
    this.line.open();
    const stop = effect(() => {
      const text = this.text.value;
      const on = ready();
      untracked(() => {
        if (!on) this.line.clear();
        else if (text !== this.line.asked.peek()) {
          this.picked.value = undefined;
          this.line.ask({ text, flights: FLIGHTS });
        }
      });
    });
    return () => {
      stop();
      this.line.close();
    };
  }
}

/** Share that docked, in whole percent, never 100 while one did not. */
export function percent(share: number): number {
  return share >= 1 ? 100 : Math.min(99, Math.round(share * 100));
}

/** "waved off 11; out of time 2": all that did not dock, the most frequent first. */
export function othersIn(chance: Chance): string {
  return Object.entries(chance.counts)
    .filter(([ending, count]) => ending !== "docked" && count > 0)
    .sort((a, b) => b[1] - a[1])
    .map(([ending, count]) => `${endingNamed(ending)?.word ?? ending} ${count}`)
    .join("; ");
}

/** The flights that ended worst: those that did not dock, the farthest first. */
export function worst(flights: readonly Flight[], most: number): Flight[] {
  return flights
    .filter((flight) => flight.outcome !== "docked")
    .sort((a, b) => b.closest_m - a.closest_m)
    .slice(0, most);
}

/** Whether a forecast is of a text's bytes. */
export function isOf(nominal: Nominal | undefined, text: string): boolean {
  return nominal?.sha256 === hashOf(text);
}
