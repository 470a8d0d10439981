// Translation that the user wants to edit: it becomes a separate program, which runs instead of the G-code.

import type { Documents } from "../core/documents";

const extension = /\.[^./]*$/;

/**
 * The engine uses this mark to count lines of an unchanged translation as those of the G-code. Here lines are
 * those of the script.
 */
const lineMapMarker = /; line n there is line n\+1 here; hash [0-9a-f]+/;

export class EditedTranslations {
  /** G-code from which a script was made. */
  private readonly sourcePrograms = new Map<string, string>();

  constructor(private readonly documents: Documents) {}

  /** Creates a user's script with a name that is free, or has this very text. */
  make(program: string, translation: string): { name: string; script: string } {
    const script = translation.replace(lineMapMarker, "");
    const stem = program.replace(extension, "");
    let name = `${stem}.lua`;
    for (let i = 2; this.isTaken(name, script); ++i) name = `${stem}-${i}.lua`;
    this.sourcePrograms.set(name, program);
    return { name, script };
  }

  /** Returns undefined if it was opened as it is. */
  sourceProgram(name: string): string | undefined {
    return this.sourcePrograms.get(name);
  }

  private isTaken(name: string, script: string): boolean {
    return this.documents.get(name) !== undefined && this.documents.text(name) !== script;
  }
}
