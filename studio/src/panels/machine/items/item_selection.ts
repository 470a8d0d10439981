// Object, frame or body that is open in the form: it has the handle in the view.

import type { FileRole } from "../file/model";
import type { ItemKind } from "./tree";

export interface Item {
  part: FileRole;
  kind: ItemKind;
  name: string;
}

export class ItemSelection {
  private one: Item | null = null;
  private readonly listeners = new Set<() => void>();

  get item(): Item | null {
    return this.one;
  }

  is(part: FileRole, kind: ItemKind, name: string): boolean {
    return this.one !== null && this.one.part === part && this.one.kind === kind && this.one.name === name;
  }

  choose(item: Item | null): void {
    this.one = item;
    for (const listener of this.listeners) listener();
  }

  rename(part: FileRole, kind: ItemKind, from: string, to: string): void {
    if (this.is(part, kind, from)) this.choose({ part, kind, name: to });
  }

  on(listener: () => void): void {
    this.listeners.add(listener);
  }
}
