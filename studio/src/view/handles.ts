// Handles for pages that can change a run: points of the manual path, and bodies.

import { BodyHand } from "./body_hand";
import { PathHand } from "./hand_path/path_hand";
import type { CreateHolds } from "./holds";

export const createHandles: CreateHolds = (place) => [new PathHand(place), new BodyHand(place)];
