// The page's one history of the stream.
import { History } from "./history";
import { live } from "./store";

export const history = new History(live);
