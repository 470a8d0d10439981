// Blocks of a run in a table: the slowest first, or by another column; filtered by words.

import { kindColours } from "../../../core/colours";
import { Debounced } from "../../../core/debounced";
import { element } from "../../../core/dom";
import { goToBlock } from "../../../core/navigation";
import { limitText } from "../../../core/display_names";
import type { Store } from "../../../core/store";
import { countText, feedText, lengthShort, percentText, programmedFeedText, timeText } from "../../../core/units";
import { moveKinds } from "../../../run/kinds";
import { texts } from "../../../texts";
import type { Context, Tab } from "../context";
import { cachedBlockTable, type BlockTable } from "../data/block_table";
import { createFilter } from "../data/filter";
import { largestIndices } from "../data/largest_indices";
import { limitColour, limitHint, blockLimit } from "../data/limit_texts";
import { linesOf } from "../data/source_lines";
import { initializeTabStops, makeRows } from "../rows";

const words = texts.panels;
const INITIAL_ROWS = 200;
const TYPING_PAUSE_MS = 150;

const columns = ["line", "duration", "share", "limit", "kind", "length", "speed", "feed"] as const;
type Column = (typeof columns)[number];

/** Returns the sort key of a column. */
function sortKey(column: Column, table: BlockTable): (block: number) => number {
  switch (column) {
    case "line":
      return (block) => table.file[block] * 1e8 + table.line[block];
    case "limit":
      return (block) => table.limit[block] * 32 + table.axis[block];
    case "kind":
      return (block) => table.kind[block];
    case "length":
      return (block) => table.length_mm[block];
    case "speed":
      return (block) => table.meanSpeed_mm_s(block);
    case "feed":
      return (block) => table.feed_per_min[block];
    default:
      return (block) => table.duration_s[block];
  }
}

export class BlocksTab implements Tab {
  private readonly search = element("input", {
    type: "search",
    placeholder: words.filter,
    "aria-label": words.filter,
    title: words.filterHint,
    oninput: () => this.filterTimer.after(TYPING_PAUSE_MS),
  });
  private readonly heads = columns.map((column) =>
    element("button", { onclick: () => this.sortBy(column) }, words.blockColumns[column]),
  );
  private readonly cells = this.heads.map((head) => element("th", { scope: "col", "aria-sort": "none" }, head));
  private readonly body = element("tbody");
  private readonly count = element("p", { class: "note", role: "status" });
  private readonly partialNote = element("p", { class: "note", hidden: true }, words.onlyFirst);
  private readonly more = element("button", { class: "more", onclick: () => this.showMore() });
  private column: Column = "duration";
  private descending = true;
  private most = INITIAL_ROWS;
  private displayed: ArrayLike<number> = [];
  private context: Context | null = null;
  private readonly filterTimer = new Debounced(() => this.filter(this.search.value));
  readonly element: HTMLElement;

  constructor(private readonly store: Store) {
    const head = element("thead", {}, element("tr", {}, ...this.cells));
    const caption = element("caption", { class: "unseen" }, words.blockCaption);
    const table = element("table", { class: "blocks" }, caption, head, this.body);
    this.element = element("div", {}, this.search, this.partialNote, this.count, element("div", { class: "wide" }, table), this.more);
    makeRows(this.body, (row) => goToBlock(store, this.displayed[row]));
    store.on("selection", () => this.showSelection());
  }

  draw(context: Context): void {
    this.context = context;
    this.most = INITIAL_ROWS;
    this.fill();
  }

  forget(): void {
    this.context = null;
    this.fill();
  }

  filter(text: string): void {
    this.search.value = text;
    this.most = INITIAL_ROWS;
    this.fill();
  }

  private sortBy(column: Column): void {
    this.descending = column === this.column ? !this.descending : column !== "line";
    this.column = column;
    this.most = INITIAL_ROWS;
    this.fill();
  }

  private showMore(): void {
    this.most *= 2;
    this.fill();
  }

  private fill(): void {
    this.cells.forEach((cell, i) => {
      const sorted = columns[i] === this.column ? (this.descending ? "descending" : "ascending") : "none";
      cell.setAttribute("aria-sort", sorted);
    });
    const { run, robot } = this.context ?? {};
    this.partialNote.hidden = !robot?.segments.isLong;
    if (!run || !robot) {
      this.body.replaceChildren();
      this.count.textContent = words.noBlocks;
      this.more.hidden = true;
      return;
    }
    const table = cachedBlockTable(robot);
    const passes = createFilter(this.search.value, run, robot, table);
    const key = sortKey(this.column, table);
    const { indices, passed } = largestIndices(table.count, this.most, this.descending ? key : (i) => -key(i), passes);
    this.displayed = indices;
    this.body.replaceChildren(...Array.from(indices, (block) => this.createRow(block, table)));
    initializeTabStops(this.body);
    this.showCount(table, passed, passes);
    this.showSelection();
  }

  private showCount(table: BlockTable, passed: number, passes: (block: number) => boolean): void {
    let time_s = 0;
    for (let block = 0; block < table.count; ++block) if (passes(block)) time_s += table.duration_s[block];
    const displayed = countText(this.displayed.length);
    this.count.textContent =
      passed === 0 ? words.noBlocks : words.blockCount(displayed, countText(passed), timeText(time_s, 2));
    this.more.hidden = passed <= this.displayed.length;
    this.more.textContent = words.more(Math.min(this.most, passed - this.displayed.length));
  }

  private createRow(block: number, table: BlockTable): HTMLElement {
    const { run, robot } = this.context!;
    const units = this.store.get("units");
    const { letters } = robot!;
    const kind = moveKinds[table.kind[block]];
    const limit = blockLimit(table, block, letters);
    const feed = table.feed_per_min[block];
    const moves = table.length_mm[block] > 0;
    const file = robot!.files[table.file[block]] ?? "";
    const cells: [text: string, title?: string, colour?: string][] = [
      [String(table.line[block]), `${file}: ${linesOf(run!.sources, file).line(table.line[block])}`],
      [timeText(table.duration_s[block])],
      [`${percentText(table.duration_s[block], table.total_s)} %`],
      [limitText(limit), limitHint(limit), limitColour(limit)],
      [texts.run.kinds[kind], "", kindColours[kind]],
      [moves ? lengthShort(table.length_mm[block], units) : "–"],
      [moves ? feedText(table.meanSpeed_mm_s(block), units) : "–"],
      [feed > 0 ? programmedFeedText(feed, table.length_mm[block], units) : "–"],
    ];
    return element(
      "tr",
      { "aria-selected": "false" },
      ...cells.map(([text, title, dot], i) =>
        element("td", { title: title ?? false, class: columns[i], style: dot ? `--colour:${dot}` : false }, text),
      ),
    );
  }

  /** Highlights the rows of the chosen block, or of all blocks of the chosen line. */
  private showSelection(): void {
    const selection = this.store.get("selection");
    const robot = this.context?.robot;
    if (!robot) return;
    const table = cachedBlockTable(robot);
    const file = selection ? robot.files.indexOf(selection.file) : -1;
    [...this.body.children].forEach((row, i) => {
      const block = this.displayed[i];
      const here = selection !== null && table.file[block] === file && table.line[block] === selection.line;
      const chosen = here && (selection.block < 0 || selection.block === block);
      row.setAttribute("aria-selected", String(chosen));
    });
  }
}

export const createBlocks = (store: Store): BlocksTab => new BlocksTab(store);
