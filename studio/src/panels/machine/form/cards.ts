// List with entries that can be opened: axes, objects, bodies. Entries are identified by name, so that one
// stays open, and keeps the focus, when others come and go.

import { arrange } from "../../../core/dom";

export interface Card {
  element: HTMLElement;
  /** `index`: the current number of its table. */
  draw(index: number): void;
}

export class CardList {
  private readonly cards = new Map<string, Card>();

  constructor(
    readonly host: HTMLElement,
    private readonly make: (name: string) => Card,
  ) {}

  /** Numbers repeated names by position, to keep them distinct. */
  draw(names: readonly string[]): void {
    const uniqueNames = names.map((name, i) => (names.indexOf(name) === i ? name : `${name} ${i}`));
    for (const name of [...this.cards.keys()]) if (!uniqueNames.includes(name)) this.cards.delete(name);
    const all = uniqueNames.map((name) => {
      const card = this.cards.get(name) ?? this.make(name);
      this.cards.set(name, card);
      return card;
    });
    arrange(this.host, all.map((card) => card.element));
    all.forEach((card, index) => card.draw(index));
  }

  /** Renames an entry. */
  rename(from: string, to: string): void {
    const card = this.cards.get(from);
    if (!card || this.cards.has(to)) return;
    this.cards.delete(from);
    this.cards.set(to, card);
  }
}
