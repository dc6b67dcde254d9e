// What may befall the vehicle at a time: a fault, an outage of sight, one of the Doppler log.
export const EVENTS = ["fault", "outage", "dvl"] as const;
export type EventKind = (typeof EVENTS)[number];
