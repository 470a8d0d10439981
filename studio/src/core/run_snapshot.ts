// Origin of a run: its setup, and the documents as they were at its start.

import type { Run } from "../run/run";
import type { Documents } from "./documents";
import type { FileContent } from "./file_content";
import { affectsRun } from "./affects_run";
import type { Setup } from "./setup";

/**
 * Versions of files in a folder that the engine reads by itself, by name: a new one each time that the file
 * is written.
 */
export type Versions = ReadonlyMap<string, string>;

export interface Origin {
  setup: Readonly<Setup>;
  /** User's documents, by name; samples never change. */
  own: ReadonlyMap<string, FileContent>;
  /** Versions of the folder by then; the page may not have loaded some texts yet. */
  versions: Versions;
  /** Texts of the program and of all documents of the user. */
  texts: Map<string, string>;
}

export function createSnapshot(setup: Readonly<Setup>, documents: Documents, versions: Versions = new Map()): Origin {
  const own = new Map(documents.userFileNames().map((name) => [name, documents.get(name)!]));
  const names = [setup.program, ...own.keys()].filter((name) => typeof documents.get(name) === "string");
  return { setup: { ...setup }, own, versions, texts: new Map(names.map((name) => [name, documents.text(name)])) };
}

/** Returns documents that the run would read differently today, by name. */
export function changedSince(run: Run, { setup, own, versions }: Origin, documents: Documents, now: Versions = new Map()): string[] {
  const names = new Set([...own.keys(), ...documents.userFileNames(), ...versions.keys(), ...now.keys()]);
  const isSame = (name: string) => {
    // The file was read from the folder, so a text loaded since then is no change.
    if (!own.has(name) && versions.has(name)) return versions.get(name) === now.get(name) && !documents.isUnsaved(name);
    if (own.get(name) === documents.own(name)) return own.has(name) || !now.has(name);
    // An identical copy of a sample is no change.
    return (own.get(name) ?? documents.samples.get(name)) === documents.get(name);
  };
  return [...names].filter((name) => !isSame(name) && affectsRun(name, documents.kindOf(name), setup, run));
}
