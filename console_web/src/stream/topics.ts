// Topics of the stream, the message each carries and how old it may be before it is stale.
import type { GenMessage } from "@bufbuild/protobuf/codegenv2";
import type { Message } from "@bufbuild/protobuf";
import * as pb from "../gen/bumpless_pb";

interface Topic<T extends Message> {
  schema: GenMessage<T>;
  /** Seconds after which the last value no longer counts as present. */
  freshFor: number;
}

function topic<T extends Message>(schema: GenMessage<T>, freshFor: number): Topic<T> {
  return { schema, freshFor };
}

/** Each control cycle (20 Hz): stale after half a second. Slower topics: after 2.5 periods. */
const CYCLE = 0.5;

export const TOPICS = {
  "tlm/navigation": topic(pb.NavigationSchema, CYCLE),
  "tlm/guidance": topic(pb.GuidanceSchema, CYCLE),
  "tlm/supervisor": topic(pb.SupervisorSchema, CYCLE),
  "tlm/control": topic(pb.ControlSchema, CYCLE),
  "tlm/allocation": topic(pb.AllocationSchema, CYCLE),
  "tlm/actuators": topic(pb.ActuatorsSchema, CYCLE),
  "tlm/target": topic(pb.TargetSchema, CYCLE),
  "tlm/mission": topic(pb.MissionStatusSchema, 1.25),
  "tlm/plan": topic(pb.PlanSchema, 5),
  "tlm/parameters": topic(pb.ParametersStatusSchema, 2.5),
  "tlm/description": topic(pb.VehicleDescriptionSchema, 5),
  "tlm/health": topic(pb.HealthSchema, 2.5),
  "server/status": topic(pb.ServerStatusSchema, 1.25),
} as const;

export type TopicName = keyof typeof TOPICS;
export type MessageOf<K extends TopicName> = (typeof TOPICS)[K] extends Topic<infer T> ? T : never;

export function isTopic(name: string): name is TopicName {
  return Object.hasOwn(TOPICS, name);
}
