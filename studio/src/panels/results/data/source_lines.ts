// Lines of a source, found once.

export class SourceLines {
  private readonly starts: Uint32Array;

  constructor(readonly text: string) {
    const starts = [0];
    for (let at = text.indexOf("\n"); at >= 0; at = text.indexOf("\n", at + 1)) starts.push(at + 1);
    this.starts = Uint32Array.from(starts);
  }

  get count(): number {
    return this.starts.length;
  }

  /** Returns a line, counted from 1, without its line end. */
  line(number: number): string {
    if (number < 1 || number > this.count) return "";
    const end = number < this.count ? this.starts[number] - 1 : this.text.length;
    return this.text.slice(this.starts[number - 1], end).trimEnd();
  }

  /** Returns the first character of a line that is not a blank; empty: none. */
  firstCharacter(number: number): string {
    let at = this.starts[number - 1];
    while (" \t\r".includes(this.text[at] ?? "\n")) ++at;
    return this.text[at] === "\n" ? "" : (this.text[at] ?? "");
  }

  /** Returns 1 for each line number with the words, in upper or lower case. */
  linesWith(words: string): Uint8Array {
    const found = new Uint8Array(this.count + 1);
    const text = this.text.toLowerCase();
    let line = 1;
    let end = text.indexOf("\n");
    for (let at = text.indexOf(words); at >= 0; at = text.indexOf(words, at + 1)) {
      while (end >= 0 && end < at) {
        end = text.indexOf("\n", end + 1);
        ++line;
      }
      found[line] = 1;
    }
    return found;
  }
}

const known = new WeakMap<Map<string, string>, Map<string, SourceLines>>();

/** Returns the lines of the source with this name. */
export function linesOf(sources: Map<string, string>, name: string): SourceLines {
  const of = known.get(sources) ?? new Map<string, SourceLines>();
  known.set(sources, of);
  const lines = of.get(name) ?? new SourceLines(sources.get(name) ?? "");
  of.set(name, lines);
  return lines;
}
