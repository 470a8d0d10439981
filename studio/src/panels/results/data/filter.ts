// Filters blocks by the text that a user has typed.

import { limitText } from "../../../core/names";
import { DWELL, limitOf } from "../../../run/limits";
import type { Robot, Run } from "../../../run/run";
import { limitKinds, moveKinds } from "../../../run/kinds";
import { texts } from "../../../texts";
import type { BlockTable } from "./block_table";
import { linesOf } from "./source_lines";

/**
 * "230": that line, or the block N230; "200-260": lines; other words: part of the text of the line, of the
 * kind of motion or of its limit.
 */
export function filterOf(words: string, run: Run, robot: Robot, table: BlockTable): (block: number) => boolean {
  const wanted = words.trim().toLowerCase();
  if (wanted === "") return () => true;
  const [, from, to] = /^(\d+)\s*-\s*(\d+)$/.exec(wanted) ?? [];
  if (from) return (block) => table.line[block] >= Number(from) && table.line[block] <= Number(to);
  if (/^\d+$/.test(wanted)) {
    const byNumber = matchingLines(`n${wanted} `, run, robot);
    return (block) => table.line[block] === Number(wanted) || byNumber[table.file[block]]?.[table.line[block]] === 1;
  }
  const byText = matchingLines(wanted, run, robot);
  const byKind = moveKinds.map((kind) => texts.run.kinds[kind].includes(wanted));
  const byLimit = limitMatches(wanted, robot);
  const columns = robot.scene.axes.length + 1;
  return (block) => {
    if (byText[table.file[block]]?.[table.line[block]] === 1 || byKind[table.kind[block]]) return true;
    if (moveKinds[table.kind[block]] === "dwell") return byLimit[0];
    return byLimit[1 + table.limit[block] * columns + table.axis[block] + 1];
  };
}

const matchingLines = (words: string, run: Run, robot: Robot): Uint8Array[] =>
  robot.files.map((file) => linesOf(run.sources, file).matching(words));

/** Returns matches: first the dwell, then each limit for no axis and for each axis. */
function limitMatches(wanted: string, robot: Robot): boolean[] {
  const { letters } = robot;
  const matches = (text: string) => text.toLowerCase().includes(wanted);
  const all = limitKinds.flatMap((_, limit) =>
    [-1, ...letters.keys()].map((axis) => matches(limitText(limitOf(limit, axis, letters)))),
  );
  return [matches(limitText(DWELL)), ...all];
}
