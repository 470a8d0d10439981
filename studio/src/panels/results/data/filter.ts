// Filters blocks by the text that a user has typed.

import { limitText } from "../../../core/display_names";
import { DWELL, toNamedLimit } from "../../../run/limits";
import type { Robot, Run } from "../../../run/run";
import { limitKinds, moveKinds } from "../../../run/kinds";
import { texts } from "../../../texts";
import type { BlockTable } from "./block_table";
import { linesOf } from "./source_lines";

/**
 * "230": that line, or the block N230; "200-260": lines; other words: part of the text of the line, of the
 * kind of motion or of its limit.
 */
export function createFilter(words: string, run: Run, robot: Robot, table: BlockTable): (block: number) => boolean {
  const queryText = words.trim().toLowerCase();
  if (queryText === "") return () => true;
  const [, from, to] = /^(\d+)\s*-\s*(\d+)$/.exec(queryText) ?? [];
  if (from) return (block) => table.line[block] >= Number(from) && table.line[block] <= Number(to);
  if (/^\d+$/.test(queryText)) {
    const numberMatches = matchingLines(`n${queryText} `, run, robot);
    return (block) => table.line[block] === Number(queryText) || numberMatches[table.file[block]]?.[table.line[block]] === 1;
  }
  const textMatches = matchingLines(queryText, run, robot);
  const kindMatches = moveKinds.map((kind) => texts.run.kinds[kind].includes(queryText));
  const limitMatchTable = limitMatches(queryText, robot);
  const columns = robot.scene.axes.length + 1;
  return (block) => {
    if (textMatches[table.file[block]]?.[table.line[block]] === 1 || kindMatches[table.kind[block]]) return true;
    if (moveKinds[table.kind[block]] === "dwell") return limitMatchTable[0];
    return limitMatchTable[1 + table.limit[block] * columns + table.axis[block] + 1];
  };
}

const matchingLines = (words: string, run: Run, robot: Robot): Uint8Array[] =>
  robot.files.map((file) => linesOf(run.sources, file).linesWith(words));

/** Returns matches: first the dwell, then each limit for no axis and for each axis. */
function limitMatches(queryText: string, robot: Robot): boolean[] {
  const { letters } = robot;
  const matches = (text: string) => text.toLowerCase().includes(queryText);
  const all = limitKinds.flatMap((_, limit) =>
    [-1, ...letters.keys()].map((axis) => matches(limitText(toNamedLimit(limit, axis, letters)))),
  );
  return [matches(limitText(DWELL)), ...all];
}
