// What the alarms watch against, for the bands in the plots and the Operate view.
import { ask } from "../api/client";
import { Resource } from "../api/resource";

export const limits = new Resource(() => ask("get", "/api/alarms/limits"));
