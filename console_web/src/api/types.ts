// What the server answers with, by the names of its own models. Made from its interface by `make gen`.
import type { components } from "../gen/api";

type Schemas = components["schemas"];
export type AuditEntry = Schemas["AuditEntry"];
export type CommandReply = Schemas["CommandReply"];
export type Metrics = Schemas["Metrics"];
export type MissionDetail = Schemas["MissionDetail"];
export type MissionSummary = Schemas["MissionSummary"];
export type EndErrors = Schemas["EndErrors"];
export type ModeMetrics = Schemas["ModeMetrics"];
export type Outcome = Schemas["Outcome"];
export type Preset = Schemas["Preset"];
export type Problem = Schemas["Problem"];
export type Range = Schemas["Range"];
export type RunSummary = Schemas["RunAnswer"];
export type SwitchMetrics = Schemas["SwitchMetrics"];
