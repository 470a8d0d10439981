// Selection in a path: a target or several adjacent ones, or a path itself. The last one chosen is in the
// store.

import type { Store } from "../../core/store";
import { isSameTarget, type TargetId } from "../../run/path/path_file";

/** Consecutive targets of a path; with a target of -1: the path itself. */
export interface Range {
  place: TargetId;
  count: number;
}

export class TargetSelection {
  /** Other end of the selection; null: a single target. */
  private anchor: TargetId | null = null;
  private isSelecting = false;
  private readonly listeners = new Set<() => void>();

  constructor(private readonly store: Store) {
    store.on("pathPoint", () => {
      if (!this.isSelecting) this.anchor = null;
      this.tell();
    });
  }

  /** Adds a listener for changes. */
  on(listener: () => void): void {
    this.listeners.add(listener);
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }

  get point(): TargetId | null {
    return this.store.get("pathPoint");
  }

  /** Returns null without a selection. */
  get range(): Range | null {
    const { point, anchor } = this;
    if (!point) return null;
    if (!anchor || anchor.path !== point.path || anchor.target < 0 || point.target < 0) return { place: point, count: 1 };
    const [first, last] = [Math.min(point.target, anchor.target), Math.max(point.target, anchor.target)];
    return { place: { path: point.path, target: first }, count: last - first + 1 };
  }

  has({ path, target }: TargetId): boolean {
    const { range } = this;
    return range?.place.path === path && target >= range.place.target && target < range.place.target + range.count;
  }

  /** `extended`: with all targets between it and the one that was chosen first. */
  choose(place: TargetId, extended = false): void {
    this.anchor = extended ? (this.anchor ?? this.point) : null;
    if (isSameTarget(place, this.point)) return this.tell();
    this.isSelecting = true;
    this.store.set("pathPoint", place);
    this.isSelecting = false;
  }

  selectRange({ place, count }: Range): void {
    this.choose(place);
    if (count > 1) this.choose({ path: place.path, target: place.target + count - 1 }, true);
  }
}
