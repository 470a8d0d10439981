// Tree of a path file: paths, sub-paths and points. Arrows move between its rows and open them, with Shift
// they extend the selection, with Alt they move it; a dragged row moves to the row that it is dropped on.

import { element } from "../../core/dom";
import type { DisplayedPath } from "../../core/displayed_path";
import type { Store } from "../../core/store";
import { lengthNumber } from "../../core/units";
import { isMachinePoint, isSubPath, type MachinePoint, type TargetId, type Point } from "../../run/path/path_file";
import { texts } from "../../texts";
import type { TargetSelection } from "./target_selection";
import { isRowForTarget, reveal, visibleRows, TreeState, type TreeRow } from "./tree_rows";

const words = texts.paths.tree;

/** What is done with what is chosen. */
export interface TreeActions {
  /** Moves the selection by so many positions. */
  move(by: number): void;
  /** Moves the selection to the position of another target. */
  moveTo(place: TargetId): void;
  remove(): void;
  duplicate(): void;
}

export class PathTree {
  readonly element = element("div", { class: "tree", role: "tree", "aria-label": words.label, "aria-multiselectable": "true" });
  private readonly state = new TreeState();
  private rows: TreeRow[] = [];
  /** Row that the Tab key reaches. */
  private current = 0;
  private name = "";

  constructor(
    private readonly store: Store,
    private readonly choice: TargetSelection,
    private readonly actions: TreeActions,
  ) {
    const { element: tree } = this;
    tree.addEventListener("click", (event) => this.handleClick(event));
    tree.addEventListener("keydown", (event) => this.onKeyDown(event));
    tree.addEventListener("dragstart", (event) => this.onDragStart(event));
    tree.addEventListener("dragover", (event) => {
      if (this.dropPosition(event)) event.preventDefault();
    });
    tree.addEventListener("drop", (event) => this.dropped(event));
  }

  /** Redraws the tree; the focus is kept, and follows the selection. */
  show(displayed: DisplayedPath | null): void {
    if (displayed && displayed.name !== this.name) this.begin(displayed);
    this.name = displayed?.name ?? "";
    const { point } = this.choice;
    if (displayed && point) reveal(displayed, this.state, point);
    this.rows = displayed ? [...visibleRows(displayed, this.state)] : [];
    const hadFocus = this.element.contains(document.activeElement);
    const now = this.rows[this.current];
    if (!now || !isRowForTarget(now, point)) {
      const chosen = this.rows.findIndex((row) => isRowForTarget(row, point));
      if (chosen >= 0) this.current = chosen;
    }
    this.current = Math.min(this.current, Math.max(this.rows.length - 1, 0));
    while (this.element.childElementCount > this.rows.length) this.element.lastElementChild!.remove();
    while (this.element.childElementCount < this.rows.length) this.element.append(element("div", { role: "treeitem" }));
    this.rows.forEach((row, i) => this.fill(this.element.children[i] as HTMLElement, row, i, displayed!));
    const item = this.element.children[this.current] as HTMLElement | undefined;
    if (hadFocus) item?.focus({ preventScroll: true });
    if (item) this.scrollIntoSight(item);
  }

  /** Scrolls within the tree; the remainder of the page keeps its position. */
  private scrollIntoSight(item: HTMLElement): void {
    const { element: tree } = this;
    const top = item.offsetTop - tree.offsetTop;
    if (top < tree.scrollTop) tree.scrollTop = top;
    else if (top + item.offsetHeight > tree.scrollTop + tree.clientHeight) tree.scrollTop = top + item.offsetHeight - tree.clientHeight;
  }

  private begin({ file, walk }: DisplayedPath): void {
    this.current = 0;
    // Short paths are open.
    file.paths.forEach((_, path) => {
      if (path === 0 || !walk.used.has(path)) this.state.set(String(path), true);
    });
    this.state.set(String(Math.max(0, file.paths.findIndex(({ name }) => name === file.root))), true);
  }

  private fill(item: HTMLElement, row: TreeRow, i: number, displayed: DisplayedPath): void {
    const isSelected = row.more === 0 && this.choice.has(row.place);
    item.setAttribute("aria-level", String(row.level));
    item.setAttribute("aria-selected", String(isSelected));
    if (row.below >= 0) item.setAttribute("aria-expanded", String(row.open));
    else item.removeAttribute("aria-expanded");
    item.tabIndex = i === this.current ? 0 : -1;
    item.draggable = row.place.target >= 0 && row.more === 0;
    item.className = ["row", row.motion ?? (row.more > 0 ? "more" : "path"), row.error ? "faulty" : ""].join(" ");
    item.title = row.error;
    item.style.setProperty("--level", String(row.level));
    const parts = row.more > 0 ? [words.more(row.more)] : this.rowTexts(row, displayed);
    const text = parts.join("\n");
    if (item.dataset.text === text) return;
    item.dataset.text = text;
    item.replaceChildren(
      element("span", { class: "twisty", "aria-hidden": "true" }),
      ...parts.map((part, k) => element("span", { class: `part-${k}` }, part)),
    );
  }

  /** Returns number, kind and actions of a row. */
  private rowTexts({ place, target, below }: TreeRow, { file, walk }: DisplayedPath): string[] {
    if (!target) {
      const { name, targets } = file.paths[below];
      const isReferenced = walk.used.has(below);
      return ["", name, isReferenced ? words.targets(targets.length) : words.unused];
    }
    const number = String(place.target + 1);
    if (isSubPath(target)) return [number, target.path, target.repeats ? words.times(target.repeats) : ""];
    if (isMachinePoint(target))
      return [number, words.machinePoint(target.name ?? "", target.fixed ?? null, target.reference ?? 0), this.actionsText(target)];
    return [number, this.nameOf(target), this.actionsText(target)];
  }

  private nameOf({ name, motion, position_mm }: Point): string {
    const units = this.store.get("units");
    const place = position_mm.map((each) => lengthNumber(each, units)).join("  ");
    return `${words.signs[motion ?? "linear"]} ${name ? `${name}: ${place}` : place}`;
  }

  private actionsText({ actions, dwell_s, ...motion }: Point | MachinePoint): string {
    const feed_mm_min = "feed_mm_min" in motion ? motion.feed_mm_min : undefined;
    const parts = [...(actions ?? []).map((action) => action.replaceAll("_", " "))];
    if (dwell_s) parts.unshift(words.dwell(dwell_s));
    if (feed_mm_min) parts.unshift(words.feed(lengthNumber(feed_mm_min, this.store.get("units")).replace(/\.?0+$/, "")));
    return parts.join(", ");
  }

  private eventRow(event: Event): number {
    const item = (event.target as HTMLElement).closest("[role=treeitem]");
    return item ? [...this.element.children].indexOf(item) : -1;
  }

  private handleClick(event: MouseEvent): void {
    const i = this.eventRow(event);
    if (i < 0) return;
    this.current = i;
    const row = this.rows[i];
    (this.element.children[i] as HTMLElement).focus();
    if ((event.target as HTMLElement).classList.contains("twisty") && row.below >= 0) return this.open(row, !row.open);
    this.select(row, event.shiftKey);
  }

  private select(row: TreeRow, extended: boolean): void {
    if (row.more === 0) return this.choice.choose(row.place, extended);
    this.state.expand(row.key.replace(/\/more$/, ""), row.place.target);
    this.show(this.store.get("path"));
  }

  private open(row: TreeRow, open: boolean): void {
    this.state.set(row.key, open);
    const rows = this.rows;
    const at = rows.indexOf(row);
    this.show(this.store.get("path"));
    this.goTo(Math.min(at, this.rows.length - 1));
  }

  /** Sets the focus to a row. */
  private goTo(i: number): void {
    const to = Math.min(Math.max(i, 0), this.rows.length - 1);
    [...this.element.children].forEach((item, k) => ((item as HTMLElement).tabIndex = k === to ? 0 : -1));
    this.current = to;
    (this.element.children[to] as HTMLElement | undefined)?.focus();
  }

  /** Moves by so many rows, and selects the new one. */
  private step(by: number, extended: boolean): void {
    this.goTo(this.current + by);
    const row = this.rows[this.current];
    if (row?.more === 0) this.choice.choose(row.place, extended);
  }

  private onKeyDown(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey) return;
    const row = this.rows[this.current];
    if (!row) return;
    const act = event.altKey ? this.keysWithAlt(event.key) : this.keys(row, event.shiftKey)[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  private keysWithAlt(key: string): (() => void) | undefined {
    return { ArrowUp: () => this.actions.move(-1), ArrowDown: () => this.actions.move(1) }[key];
  }

  private keys(row: TreeRow, shift: boolean): Record<string, () => void> {
    return {
      ArrowDown: () => this.step(1, shift),
      ArrowUp: () => this.step(-1, shift),
      PageDown: () => this.step(10, shift),
      PageUp: () => this.step(-10, shift),
      Home: () => this.step(-this.rows.length, shift),
      End: () => this.step(this.rows.length, shift),
      ArrowRight: () => (row.below >= 0 && !row.open ? this.open(row, true) : this.step(row.below >= 0 ? 1 : 0, false)),
      ArrowLeft: () => (row.open ? this.open(row, false) : this.step(this.parentOf(row) - this.current, false)),
      Enter: () => this.select(row, shift),
      " ": () => this.select(row, shift),
      Delete: () => this.actions.remove(),
      Insert: () => this.actions.duplicate(),
    };
  }

  private parentOf(row: TreeRow): number {
    const at = this.rows.indexOf(row);
    const parent = this.rows.findLastIndex((each, i) => i < at && each.level < row.level);
    return parent < 0 ? at : parent;
  }

  private onDragStart(event: DragEvent): void {
    const row = this.rows[this.eventRow(event)];
    if (!row || !event.dataTransfer) return;
    if (!this.choice.has(row.place)) this.choice.choose(row.place);
    event.dataTransfer.setData("text/plain", row.key);
    event.dataTransfer.effectAllowed = "move";
  }

  /** Returns the position for a drop: next to targets of the same path. */
  private dropPosition(event: DragEvent): TargetId | null {
    const row = this.rows[this.eventRow(event)];
    const { range } = this.choice;
    const isOwn = range && row?.more === 0 && row.place.path === range.place.path && row.place.target >= 0;
    return isOwn ? row.place : null;
  }

  private dropped(event: DragEvent): void {
    const place = this.dropPosition(event);
    if (!place) return;
    event.preventDefault();
    // The dropped row is not a file to open.
    event.stopPropagation();
    this.actions.moveTo(place);
  }
}
