// Path file as it is shown.

import type { PathFile } from "../run/path/path_file";
import type { PathTraversal } from "../run/path/path_traversal";

/** Shown path file; without paths if its text is not a path file. */
export interface DisplayedPath {
  name: string;
  text: string;
  file: PathFile;
  walk: PathTraversal;
  /** Reason why the text is no path file; empty: it is one. */
  error: string;
}
