// A range of a run as the server sends it: frames of the stream, each behind its length.
import { fromBinary } from "@bufbuild/protobuf";
import { type StreamFrame, StreamFrameSchema } from "../gen/bumpless_pb";
import { SCHEMAS } from "../gen/topics";
import { type CycleRow, cycleRow } from "../stream/cycle_row";
import { isTopic, type MessageOf, type TopicName } from "../stream/topics";

export interface Sample {
  message: unknown;
  /** When the server received it, s. */
  at: number;
}

export function framesOf(data: ArrayBuffer): StreamFrame[] {
  const view = new DataView(data);
  const found: StreamFrame[] = [];
  for (let at = 0; at + 4 <= data.byteLength; ) {
    const size = view.getUint32(at, true);
    found.push(fromBinary(StreamFrameSchema, new Uint8Array(data, at + 4, size)));
    at += 4 + size;
  }
  return found;
}

/** The messages of a frame by topic. */
export function samplesOf(frame: StreamFrame): Map<TopicName, Sample> {
  const found = new Map<TopicName, Sample>();
  for (const { topic, payload, receiveTimeNs } of frame.messages) {
    if (!isTopic(topic)) continue;
    const message: unknown = fromBinary(SCHEMAS[topic] as never, payload);
    found.set(topic, { message, at: Number(receiveTimeNs) / 1e9 });
  }
  return found;
}

/** Rows for the plots, one of each frame; a topic that a frame lacks keeps its last value. */
export function rowsOf(frames: StreamFrame[]): CycleRow[] {
  const known = new Map<TopicName, Sample>();
  const received = <K extends TopicName>(name: K) => known.get(name)?.message as MessageOf<K> | undefined;
  const rows: CycleRow[] = [];
  for (const frame of frames) {
    for (const [topic, sample] of samplesOf(frame)) known.set(topic, sample);
    const row = cycleRow(received);
    if (row) rows.push(row);
  }
  return rows;
}

/** `base` with `detail` in the place of what lies within its range. */
export function merged(base: CycleRow[], detail: CycleRow[]): CycleRow[] {
  const [first, last] = [detail[0], detail.at(-1)];
  if (!first || !last) return base;
  return [
    ...base.filter(({ time }) => time < first.time),
    ...detail,
    ...base.filter(({ time }) => time > last.time),
  ];
}
