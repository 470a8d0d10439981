// Operations of a program: comments on their own lines before motion name the blocks after them.

import type { Run, Robot } from "../../../run/run";
import type { BlockTable } from "./block_table";
import { linesOf, type SourceLines } from "./source_lines";

const MAX_COMMENTS = 3;
// Line that begins a program or subprogram, and line with nothing but a comment; the first may also contain a
// name.
const PROGRAM_LINE = /^\s*(?:[o:](?:\d+|<[^>]*>))\s*(?:sub|endsub)?\s*(?:\(.*)?$/i;
const COMMENT_LINE = /^\s*(?:[o:](?:\d+|<[^>]*>)\s*(?:sub)?\s*)?(?:N\d+\s*)?(?:\(([^)]*)\)|;(.*))\s*$/i;

/** Returns the operation of each line of a source, as an index into `names`; 0: that of its caller. */
function lineOperations(lines: SourceLines, names: string[]): Uint32Array {
  const operation = new Uint32Array(lines.count + 1);
  let comments: string[] = [];
  let current = 0;
  for (let number = 1; number <= lines.count; ++number) {
    operation[number] = current;
    const first = lines.firstCharacter(number);
    if (first === "") continue;
    const line = "(;oO:nN".includes(first) ? lines.line(number) : "";
    if (PROGRAM_LINE.test(line)) {
      current = 0;
      comments = [];
    }
    const comment = COMMENT_LINE.exec(line)?.slice(1).find((text) => text?.trim());
    if (comment) {
      comments.push(comment.trim());
      current = names.push(comments.slice(-MAX_COMMENTS).join(", ")) - 1;
    } else {
      comments = [];
    }
    operation[number] = current;
  }
  return operation;
}

/** Time of an operation, and its first block. */
export interface Operation {
  name: string;
  time_s: number;
  first: number;
}

/** Returns the operations in the order in which they begin; empty: the program names none. */
export function timeByOperation(run: Run, robot: Robot, table: BlockTable, unnamed: string): Operation[] {
  const names = [unnamed];
  const byFile = robot.files.map((file) => lineOperations(linesOf(run.sources, file), names));
  if (names.length === 1) return [];
  const times_s = new Float64Array(names.length);
  const first = new Int32Array(names.length).fill(-1);
  let current = 0;
  for (let block = 0; block < table.count; ++block) {
    current = byFile[table.file[block]]?.[table.line[block]] || current;
    times_s[current] += table.duration_s[block];
    if (first[current] < 0) first[current] = block;
  }
  return names
    .map((name, i) => ({ name, time_s: times_s[i], first: first[i] }))
    .filter((operation) => operation.first >= 0)
    .sort((a, b) => a.first - b.first);
}
