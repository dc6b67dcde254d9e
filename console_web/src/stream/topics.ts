// Topics of the stream and the message each carries. How old a value may be is the server's word.
import type { Message } from "@bufbuild/protobuf";
import type { GenMessage } from "@bufbuild/protobuf/codegenv2";
import * as pb from "../gen/bumpless_pb";
import type { FRESH_FOR_S } from "../gen/house";

export type TopicName = keyof typeof FRESH_FOR_S;

export const SCHEMAS = {
  "tlm/navigation": pb.NavigationSchema,
  "tlm/guidance": pb.GuidanceSchema,
  "tlm/supervisor": pb.SupervisorSchema,
  "tlm/control": pb.ControlSchema,
  "tlm/allocation": pb.AllocationSchema,
  "tlm/actuators": pb.ActuatorsSchema,
  "tlm/target": pb.TargetSchema,
  "tlm/mission": pb.MissionStatusSchema,
  "tlm/plan": pb.PlanSchema,
  "tlm/parameters": pb.ParametersStatusSchema,
  "tlm/description": pb.VehicleDescriptionSchema,
  "tlm/health": pb.HealthSchema,
  "server/status": pb.ServerStatusSchema,
} satisfies Record<TopicName, GenMessage<Message>>;

export type MessageOf<K extends TopicName> = (typeof SCHEMAS)[K] extends GenMessage<infer T> ? T : never;

export function isTopic(name: string): name is TopicName {
  return Object.hasOwn(SCHEMAS, name);
}
