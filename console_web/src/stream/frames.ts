// Frames as the server sends them, for the unit tests.
import { create, type DescMessage, type MessageInitShape, toBinary } from "@bufbuild/protobuf";
import {
  EventSchema,
  MissionPhase,
  type Mode,
  NavigationSchema,
  StreamFrameSchema,
  SupervisorSchema,
} from "../gen/bumpless_pb";
import { LiveStore } from "./store";

const NOW_NS = 1_770_000_000_000_000_000n;
export const START_S = 1_760_000_000;

/** A store whose frames are shown by calling `show`. */
export function store(): { live: LiveStore; show: () => void } {
  const asked: (() => void)[] = [];
  const live = new LiveStore((run) => asked.push(run));
  const show = (): void => {
    for (const run of asked.splice(0)) run();
  };
  return { live, show };
}

interface Payload {
  topic: string;
  payload: Uint8Array;
}

export function said<D extends DescMessage>(topic: string, schema: D, init: MessageInitShape<D>): Payload {
  return { topic, payload: toBinary(schema, create(schema, init)) };
}

export function frame(messages: Payload[], ageS = 0, past = false): Uint8Array {
  const receiveTimeNs = NOW_NS - BigInt(Math.round(ageS * 1e9));
  const stamped = messages.map((message) => ({ ...message, receiveTimeNs }));
  return toBinary(
    StreamFrameSchema,
    create(StreamFrameSchema, { serverTimeNs: NOW_NS, past, messages: stamped }),
  );
}

export function stamp(timeS: number): { timeNs: bigint; missionTimeS: number } {
  return { timeNs: BigInt(Math.round((START_S + timeS) * 1000)) * 1_000_000n, missionTimeS: timeS };
}

/** One cycle of a flight at a mission time. */
export function cycle(timeS: number, mode: Mode, yawDeg = 0): Payload[] {
  const at = stamp(timeS);
  return [
    said("tlm/supervisor", SupervisorSchema, { stamp: at, mode, phase: MissionPhase.RUNNING }),
    said("tlm/navigation", NavigationSchema, { stamp: at, depthM: 3, attitude: { yawDeg } }),
  ];
}

export function event(timeS: number, text: string): Payload {
  return said("event", EventSchema, { stamp: stamp(timeS), text });
}
