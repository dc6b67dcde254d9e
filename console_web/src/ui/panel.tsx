// A titled box. Given a topic it dims and says how old the values are when they are not present.
import type { ComponentChildren } from "preact";
import { age } from "../lib/format";
import { screen } from "../stream/screen";
import type { TopicName } from "../stream/topics";
import "./panel.css";

interface PanelProps {
  title: string;
  /** The topic whose age decides whether the content is present. */
  topic?: TopicName;
  unit?: string;
  aside?: ComponentChildren;
  class?: string;
  /** Its content scrolls: the keyboard must reach it. */
  scrolls?: boolean;
  children: ComponentChildren;
}

export function Panel({ title, topic, unit, aside, class: name, scrolls, children }: PanelProps) {
  return (
    <section class={`panel ${name ?? ""}`} aria-label={title}>
      <header class="panel-head">
        <h2>{title}</h2>
        {unit && <span class="unit">{unit}</span>}
        <span class="grow" />
        {topic && <AgeChip topic={topic} />}
        {aside}
      </header>
      {topic ? (
        <Freshness topic={topic}>{children}</Freshness>
      ) : (
        <div class="panel-body" {...(scrolls ? { tabIndex: 0, role: "group", "aria-label": title } : {})}>
          {children}
        </div>
      )}
    </section>
  );
}

/** Nothing while the topic is present; its age when it is not. */
export function AgeChip({ topic }: { topic: TopicName }) {
  const seconds = screen.age(topic);
  if (screen.isFresh(topic)) return null;
  const text = seconds === undefined ? "no data" : `stale ${age(seconds)}`;
  return (
    <span class="age-chip" data-testid={`age-${topic}`}>
      {text}
    </span>
  );
}

function Freshness({ topic, children }: { topic: TopicName; children: ComponentChildren }) {
  const known = screen.latest(topic) !== undefined;
  const state = screen.isFresh(topic) ? "fresh" : known ? "stale" : "empty";
  return (
    <div class="panel-body" data-state={state}>
      {children}
    </div>
  );
}

/** What to do next, where there is nothing to show yet. */
export function Empty({ children }: { children: ComponentChildren }) {
  return <p class="empty">{children}</p>;
}
