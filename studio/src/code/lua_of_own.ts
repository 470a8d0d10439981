// A translation that a person wants to edit becomes a program of its own, which runs in place of the G-code.

import type { Documents } from "../core/documents";

const ending = /\.[^./]*$/;

/** By this the engine counts lines of an unchanged translation as those of the G-code; here lines are the script's own. */
const lineMark = /; line n there is line n\+1 here; hash [0-9a-f]+/;

export class LuaOfOwn {
  /** The G-code that a script was made of. */
  private readonly origins = new Map<string, string>();

  constructor(private readonly documents: Documents) {}

  /** A script of one's own, with a name that is free, or has this very text. */
  make(program: string, translation: string): { name: string; script: string } {
    const script = translation.replace(lineMark, "");
    const stem = program.replace(ending, "");
    let name = `${stem}.lua`;
    for (let i = 2; this.isTaken(name, script); ++i) name = `${stem}-${i}.lua`;
    this.origins.set(name, program);
    return { name, script };
  }

  /** Undefined: it was opened as it is. */
  originOf(name: string): string | undefined {
    return this.origins.get(name);
  }

  private isTaken(name: string, script: string): boolean {
    return this.documents.get(name) !== undefined && this.documents.text(name) !== script;
  }
}
