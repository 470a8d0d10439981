// Comparison of two variants in messages: the faster one, the lines with the difference, and notes.

import { limitText } from "../../core/display_names";
import { percentText, timeText } from "../../core/units";
import { texts } from "../../texts";
import { cachedBlockTable } from "../results/data/block_table";
import { MIN_DIFFERENCE_S } from "../results/data/comparison";
import { blockLimit } from "../results/data/limit_texts";
import { isCompleteRun, type Differences, type Row } from "./data/differences";
import { signedTime } from "./variant_texts";

const words = texts.variants;
const MAX_LISTED_LINES = 3;

interface NamedComparison {
  differences: Differences;
  names: readonly [string, string];
}

/** Returns "speed of B" for a run, or an empty text if it does not have the block. */
export function limitInRun(differences: Differences, side: 0 | 1, block: number): string {
  if (block < 0) return "";
  const { robot } = side === 0 ? differences.a : differences.b;
  return limitText(blockLimit(cachedBlockTable(robot), block, robot.letters));
}

export const passText = ({ pass, passes }: Row): string => (passes > 1 ? `, ${words.pass(pass, passes)}` : "");

const isAnyStopped = ({ differences: { a, b } }: NamedComparison): boolean => !isCompleteRun(a.run) || !isCompleteRun(b.run);

/**
 * Returns the total, then its largest part. Empty if a run did not come to its end, or did not reach the
 * start of the count.
 */
export function comparisonMessages(named: NamedComparison): string[] {
  const { differences, names } = named;
  const { totals_s, total_s, from, reachesStart } = differences;
  if (!reachesStart || isAnyStopped(named)) return [];
  const begin = from ? words.fromHere(from.line) : "";
  if (Math.abs(total_s) < MIN_DIFFERENCE_S) return [`${begin}${words.same(names[1], names[0], timeText(totals_s[0]))}`];
  const [fast, slow] = total_s < 0 ? [1, 0] : [0, 1];
  const size = timeText(Math.abs(total_s));
  const percent = percentText(Math.abs(total_s), totals_s[slow]);
  const first = words.faster(names[fast], size, percent, timeText(totals_s[fast]), names[slow], timeText(totals_s[slow]));
  return [`${begin}${first}`, ...largestDifferenceMessages(differences), ...betweenBlocksMessages(differences)];
}

function largestDifferenceMessages(differences: Differences): string[] {
  const rows = differences.largestDifferences(MAX_LISTED_LINES);
  if (rows.length === 0) return [];
  const timeChange_s = ({ times_s }: Row) => times_s[1] - times_s[0];
  // The limit of the slower run is the cause of the difference.
  const slowerRunLimit = ({ blocks }: Row) => limitInRun(differences, differences.total_s < 0 ? 0 : 1, blocks[differences.total_s < 0 ? 0 : 1]);
  const places = rows.map((row) => words.place(row.line, passText(row), signedTime(timeChange_s(row)), slowerRunLimit(row))).join(", ");
  const sum_s = rows.reduce((sum, row) => sum + timeChange_s(row), 0);
  return [words.most(places, percentText(Math.abs(sum_s), Math.abs(differences.total_s)))];
}

function betweenBlocksMessages({ total_s, blockDifference_s }: Differences): string[] {
  const between_s = total_s - blockDifference_s;
  return Math.abs(between_s) < MIN_DIFFERENCE_S ? [] : [words.between(signedTime(between_s))];
}

/** Returns notes on differences of the work, and on times that are not comparable. */
export function comparisonNotes({ differences, names }: NamedComparison): string[] {
  const { a, b, from, startBlocks, matching } = differences;
  const never = from ? startBlocks.flatMap((begin, i) => (begin < 0 ? [`“${names[i]}” ${words.lineNotReached(from.line)}.`] : [])) : [];
  const stopped = [a, b].flatMap(({ run }, i) => (isCompleteRun(run) ? [] : [words.stoppedEarly(names[i], timeText(run.end_s))]));
  return [
    ...never,
    ...stopped,
    ...(from ? [words.fullRunNote] : []),
    ...matching.otherTexts.map((pair) => words.otherTexts(pair.a, pair.b)),
    ...matching.unloadedTexts.map((pair) => words.unreadTexts(pair.a, pair.b)),
  ];
}
