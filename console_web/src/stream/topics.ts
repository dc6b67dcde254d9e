// Topics of the stream and the message each carries, as the server has them.
import type { MessageShape } from "@bufbuild/protobuf";
import { SCHEMAS } from "../gen/topics";

export type TopicName = keyof typeof SCHEMAS;
export type MessageOf<K extends TopicName> = MessageShape<(typeof SCHEMAS)[K]>;

export function isTopic(name: string): name is TopicName {
  return Object.hasOwn(SCHEMAS, name);
}
