// Path file as it is shown.

import type { PathFile } from "../run/path/path_file";
import type { Walk } from "../run/path/path_walk";

/** Shown path file; without paths if its text is not a path file. */
export interface PathShown {
  name: string;
  text: string;
  file: PathFile;
  walk: Walk;
  /** Reason why the text is no path file; empty: it is one. */
  fault: string;
}
