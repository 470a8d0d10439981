// What a run was made of: its set-up, and the documents as they were when it began.

import type { Run } from "../run/run";
import type { Documents } from "./documents";
import type { FileContent } from "./file_content";
import { isOfRun } from "./of_run";
import type { Setup } from "./setup";

/** Of files in a folder that the engine reads by itself the version on the disk, by name: another one each time that it is written. */
export type Versions = ReadonlyMap<string, string>;

export interface Origin {
  setup: Readonly<Setup>;
  /** What a person had put there, by name; samples never change. */
  own: ReadonlyMap<string, FileContent>;
  /** Of the folder by then; the page may have had no text of some of them yet. */
  versions: Versions;
  /** Texts of the program and of all that a person had put there. */
  texts: Map<string, string>;
}

export function originOf(setup: Readonly<Setup>, documents: Documents, versions: Versions = new Map()): Origin {
  const own = new Map(documents.ownNames().map((name) => [name, documents.get(name)!]));
  const names = [setup.program, ...own.keys()].filter((name) => typeof documents.get(name) === "string");
  return { setup: { ...setup }, own, versions, texts: new Map(names.map((name) => [name, documents.text(name)])) };
}

/** Documents that the run would read otherwise today, by name. */
export function changedSince(run: Run, { setup, own, versions }: Origin, documents: Documents, now: Versions = new Map()): string[] {
  const names = new Set([...own.keys(), ...documents.ownNames(), ...versions.keys(), ...now.keys()]);
  const isSame = (name: string) => {
    // Read from the folder: a text that has come since is no other one by that.
    if (!own.has(name) && versions.has(name)) return versions.get(name) === now.get(name) && !documents.isUnsaved(name);
    if (own.get(name) === documents.own(name)) return own.has(name) || !now.has(name);
    // A copy of a sample that says the same is none.
    return (own.get(name) ?? documents.samples.get(name)) === documents.get(name);
  };
  return [...names].filter((name) => !isSame(name) && isOfRun(name, documents.kindOf(name), setup, run));
}
