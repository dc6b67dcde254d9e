import { effect } from "@preact/signals";
import { describe, expect, it, vi } from "vitest";
import { LinkState, Mode, NavigationSchema, ServerStatusSchema } from "../gen/bumpless_pb";
import { cycle, event, frame, said, store } from "./frames";

const status = said("server/status", ServerStatusSchema, { link: LinkState.LIVE });

describe("the live store", () => {
  it("takes in everything and shows it once per animation frame", () => {
    const { live, show } = store();
    const drawn: (number | undefined)[] = [];
    effect(() => {
      drawn.push(live.latest("tlm/navigation")?.depthM);
    });
    for (const depthM of [1, 2, 3])
      live.receive(frame([said("tlm/navigation", NavigationSchema, { depthM })]));
    expect(drawn).toEqual([undefined]);
    expect(live.received("tlm/navigation")?.depthM).toBe(3);
    show();
    expect(drawn).toEqual([undefined, 3]);
  });

  it("counts an age from the moment the server received the message", () => {
    const { live, show } = store();
    live.receive(frame(cycle(1, Mode.FORWARD), 3));
    live.receive(frame([status]));
    show();
    expect(live.age("tlm/navigation")).toBeCloseTo(3, 1);
    expect(live.isFresh("tlm/navigation")).toBe(false);
    expect(live.isFresh("server/status")).toBe(true);
  });

  it("calls nothing present once the connection is lost", () => {
    const { live, show } = store();
    live.receive(frame([status]));
    show();
    live.lose(400);
    show();
    expect(live.connection.value).toBe("lost");
    expect(live.isFresh("server/status")).toBe(false);
  });

  it("lets a value become old while nothing comes", () => {
    vi.useFakeTimers({ toFake: ["performance", "setInterval"] });
    try {
      const { live, show } = store();
      live.keepTime();
      live.receive(frame([status]));
      show();
      expect(live.isFresh("server/status")).toBe(true);
      vi.advanceTimersByTime(2000);
      show();
      expect(live.isFresh("server/status")).toBe(false);
    } finally {
      vi.useRealTimers();
    }
  });

  it("calls a server silent when nothing comes, and not while telemetry does", () => {
    vi.useFakeTimers({ toFake: ["performance", "setInterval"] });
    try {
      const { live, show } = store();
      live.keepTime();
      live.receive(frame([status]));
      vi.advanceTimersByTime(5000);
      live.receive(frame([said("tlm/navigation", NavigationSchema, {})]));
      show();
      expect(live.isFresh("server/status")).toBe(false);
      expect(live.silent).toBe(false);
      vi.advanceTimersByTime(5000);
      show();
      expect(live.silent).toBe(true);
    } finally {
      vi.useRealTimers();
    }
  });

  it("keeps events newest first and each once", () => {
    const { live, show } = store();
    live.receive(frame([event(31, "late"), event(24, "early")]));
    live.receive(frame([event(24, "early")]));
    expect(live.events).toEqual([]);
    show();
    expect(live.events.map(({ text }) => text)).toEqual(["late", "early"]);
  });

  it("sorts events by when they came: a vehicle's clock that stepped back puts none below old ones", () => {
    const { live, show } = store();
    live.receive(frame([event(300, "before the step")], 2));
    live.receive(frame([event(1, "after the step")], 1));
    show();
    expect(live.events.map(({ text }) => text)).toEqual(["after the step", "before the step"]);
  });
});
