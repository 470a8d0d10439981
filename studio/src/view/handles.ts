// What there is to take hold of where a run can be changed: points of the path by hand, and bodies.

import { BodyHand } from "./body_hand";
import { PathHand } from "./hand_path/path_hand";
import type { CreateHolds } from "./holds";

export const createHandles: CreateHolds = (place) => [new PathHand(place), new BodyHand(place)];
