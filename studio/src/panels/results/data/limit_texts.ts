// Limit of a block, and advice for the programmer.

import { limitColours } from "../../../core/colours";
import { DWELL, toNamedLimit, type NamedLimit } from "../../../run/limits";
import { moveKinds } from "../../../run/kinds";
import { texts } from "../../../texts";
import type { BlockTable } from "./block_table";

export const limitHint = ({ kind }: NamedLimit): string => texts.panels.limitHints[kind];

export const limitColour = ({ kind }: NamedLimit): string => limitColours[kind];

/** Returns the limit, for axes with these letters. */
export const blockLimit = (table: BlockTable, block: number, letters: readonly string[]): NamedLimit =>
  moveKinds[table.kind[block]] === "dwell" ? DWELL : toNamedLimit(table.limit[block], table.axis[block], letters);
