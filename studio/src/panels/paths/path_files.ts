// New path files.

import type { Documents } from "../../core/documents";
import type { Session } from "../../core/session";
import type { Store } from "../../core/store";
import { newPathFile } from "../../run/path/path_edit";
import type { Point } from "../../run/path/path_file";
import { texts } from "../../texts";

const words = texts.paths;

/** Returns a name that no file has yet: "part 2.path.json". */
export function freeFileName(documents: Documents, stem: string): string {
  let name = `${stem}.path.json`;
  for (let i = 2; documents.exists(name); ++i) name = `${stem} ${i}.path.json`;
  return name;
}

/** Inserts a path file by a step of the history, and opens it for editing. */
export function insertFile(store: Store, session: Session, label: string, name: string, text: string): void {
  session.history.edit(label, { documents: { [name]: text } });
  store.set("pathFile", name);
}

/** Creates a file with one point, which is selected. */
export function createFile(store: Store, session: Session, point: Point): void {
  const name = freeFileName(session.documents, words.file.part);
  insertFile(store, session, words.labels.begin, name, newPathFile(words.file.part, point));
  store.set("pathPoint", { path: 0, target: 0 });
}
