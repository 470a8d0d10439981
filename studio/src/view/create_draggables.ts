// Handles for pages that can change a run: points of the manual path, and bodies.

import { BodyDragger } from "./body_dragger";
import { PathEditor } from "./path_editing/path_editor";
import type { CreateDraggables } from "./draggables";

export const createHandleDraggables: CreateDraggables = (place) => [new PathEditor(place), new BodyDragger(place)];
