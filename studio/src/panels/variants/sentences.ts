// Comparison of two variants in messages: the faster one, the lines with the difference, and notes.

import { limitText } from "../../core/names";
import { percentText, timeText } from "../../core/units";
import { texts } from "../../texts";
import { blockTableOf } from "../results/data/block_table";
import { SAME_S } from "../results/data/comparison";
import { limitOfBlock } from "../results/data/limit_words";
import { isWhole, type Differences, type Row } from "./data/differences";
import { signed } from "./words";

const words = texts.variants;
const FOREMOST = 3;

interface Named {
  differences: Differences;
  names: readonly [string, string];
}

/** Returns "speed of B" for a run, or an empty text if it does not have the block. */
export function limitIn(differences: Differences, side: 0 | 1, block: number): string {
  if (block < 0) return "";
  const { robot } = side === 0 ? differences.a : differences.b;
  return limitText(limitOfBlock(blockTableOf(robot), block, robot.letters));
}

export const passText = ({ pass, passes }: Row): string => (passes > 1 ? `, ${words.pass(pass, passes)}` : "");

const stoppedOf = ({ differences: { a, b } }: Named): boolean => !isWhole(a.run) || !isWhole(b.run);

/**
 * Returns the total, then its largest part. Empty if a run did not come to its end, or did not reach the
 * start of the count.
 */
export function sentencesOf(named: Named): string[] {
  const { differences, names } = named;
  const { totals_s, total_s, from, isReached } = differences;
  if (!isReached || stoppedOf(named)) return [];
  const begin = from ? words.fromHere(from.line) : "";
  if (Math.abs(total_s) < SAME_S) return [`${begin}${words.same(names[1], names[0], timeText(totals_s[0]))}`];
  const [fast, slow] = total_s < 0 ? [1, 0] : [0, 1];
  const size = timeText(Math.abs(total_s));
  const percent = percentText(Math.abs(total_s), totals_s[slow]);
  const first = words.faster(names[fast], size, percent, timeText(totals_s[fast]), names[slow], timeText(totals_s[slow]));
  return [`${begin}${first}`, ...foremostOf(differences), ...betweenOf(differences)];
}

function foremostOf(differences: Differences): string[] {
  const rows = differences.foremost(FOREMOST);
  if (rows.length === 0) return [];
  const size_s = ({ times_s }: Row) => times_s[1] - times_s[0];
  // The limit of the slower run is the cause of the difference.
  const limitOf = ({ blocks }: Row) => limitIn(differences, differences.total_s < 0 ? 0 : 1, blocks[differences.total_s < 0 ? 0 : 1]);
  const places = rows.map((row) => words.place(row.line, passText(row), signed(size_s(row)), limitOf(row))).join(", ");
  const together_s = rows.reduce((sum, row) => sum + size_s(row), 0);
  return [words.most(places, percentText(Math.abs(together_s), Math.abs(differences.total_s)))];
}

function betweenOf({ total_s, inBlocks_s }: Differences): string[] {
  const between_s = total_s - inBlocks_s;
  return Math.abs(between_s) < SAME_S ? [] : [words.between(signed(between_s))];
}

/** Returns notes on differences of the work, and on times that are not comparable. */
export function notesOf({ differences, names }: Named): string[] {
  const { a, b, from, begins, matching } = differences;
  const never = from ? begins.flatMap((begin, i) => (begin < 0 ? [`“${names[i]}” ${words.neverThere(from.line)}.`] : [])) : [];
  const stopped = [a, b].flatMap(({ run }, i) => (isWhole(run) ? [] : [words.stoppedEarly(names[i], timeText(run.end_s))]));
  return [
    ...never,
    ...stopped,
    ...(from ? [words.wholeRun] : []),
    ...matching.otherTexts.map((pair) => words.otherTexts(pair.a, pair.b)),
    ...matching.unread.map((pair) => words.unreadTexts(pair.a, pair.b)),
  ];
}
