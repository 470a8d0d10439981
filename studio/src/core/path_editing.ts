// Path file that forms and the view edit: kept in the store as it is shown, changed by steps of the history.

import { isPathFile, readPathFile, targetAt, type PathFile, type TargetId } from "../run/path/path_file";
import { traversePath, type PathTraversal } from "../run/path/path_traversal";
import type { DisplayedPath } from "./displayed_path";
import type { Session } from "./session";
import type { Store } from "./store";

const EMPTY_TRAVERSAL: PathTraversal = { motions: [], before: new Map(), used: new Set(), errors: [] };

/** Returns a text as it is shown. */
export function toDisplayedPath(name: string, text: string): DisplayedPath {
  const read = readPathFile(text);
  if (!isPathFile(read)) return { name, text, file: { paths: [] }, walk: EMPTY_TRAVERSAL, error: read.text };
  return { name, text, file: read, walk: traversePath(read), error: "" };
}

const exists = (file: PathFile, place: TargetId): boolean =>
  place.target < 0 ? file.paths[place.path] !== undefined : targetAt(file, place) !== undefined;

/** Keeps the shown path up to date with the file. */
export function watchPath(store: Store, { documents }: Session): void {
  const refresh = () => {
    const name = store.get("pathFile");
    if (name && !documents.exists(name)) return store.set("pathFile", "");
    // A file of the folder may not be loaded yet: it is shown as soon as it is.
    if (name && documents.get(name) === undefined) return store.set("path", null);
    const text = documents.text(name);
    const displayed = store.get("path");
    if (name && displayed?.name === name && displayed.text === text) return;
    store.set("path", name ? toDisplayedPath(name, text) : null);
    const [point, now] = [store.get("pathPoint"), store.get("path")];
    if (point && (displayed?.name !== name || !now || !exists(now.file, point))) store.set("pathPoint", null);
  };
  store.watch(["pathFile"], refresh);
  documents.on((name) => {
    if (name === store.get("pathFile")) refresh();
  });
}

/**
 * Changes the path file by a step of the history named `label`, and chooses a point; null: the selection
 * stays.
 */
export function editPath(store: Store, session: Session, label: string, text: string, point: TargetId | null = null): void {
  const name = store.get("pathFile");
  if (!name) return;
  session.history.edit(label, { documents: { [name]: text } });
  if (point) store.set("pathPoint", point);
}
