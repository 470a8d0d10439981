// Changes by the user, in any part of the page: texts of documents and choices of the setup, for undo and
// redo.

import type { Documents } from "./documents";
import type { FileContent } from "./file_content";
import type { Setup } from "./setup";

/** Documents with their contents (null: none of the user), and choices of the setup. */
export interface Change {
  documents?: Record<string, FileContent | null>;
  setup?: Partial<Setup>;
}

/** Interface of the session for the history. */
interface SetupOwner {
  readonly setup: Readonly<Setup>;
  change(setup: Partial<Setup>): void;
}

/** Label of a change, and the state on the other side of it. */
interface Step {
  label: string;
  other: Required<Change>;
  /** Consecutive steps with the same word are one, such as letters of a typed word; empty: never. */
  merge: string;
  at_ms: number;
}

/** Max time between steps of one word to be merged. */
const MERGE_MS = 1500;
/**
 * Complete texts of large programs are kept, so the oldest steps are dropped if all together exceed this
 * number of characters.
 */
const MAX_CHARACTERS = 200_000_000;

const whole = ({ documents = {}, setup = {} }: Change): Required<Change> => ({ documents, setup });

const stepSize = ({ other }: Step): number =>
  Object.values(other.documents).reduce((sum, content) => sum + (content?.length ?? 0), 0);

/** Returns true if two changes of the same documents and choices are equal. */
function isSame(one: Required<Change>, other: Required<Change>): boolean {
  const equal = (a: object, b: object) => Object.entries(a).every(([key, value]) => (b as Record<string, unknown>)[key] === value);
  return equal(one.documents, other.documents) && equal(one.setup, other.setup);
}

export class History {
  private readonly done: Step[] = [];
  private readonly undoneSteps: Step[] = [];
  private readonly listeners = new Set<(applied: Change | null) => void>();
  private readonly beforeStepListeners = new Set<() => void>();

  constructor(
    private readonly documents: Documents,
    private readonly session: SetupOwner,
    private readonly mostCharacters = MAX_CHARACTERS,
  ) {}

  /** Returns the label of the step that undo() would revert, and redo() repeat; empty: none. */
  get undoLabel(): string {
    return this.done.at(-1)?.label ?? "";
  }

  get redoLabel(): string {
    return this.undoneSteps.at(-1)?.label ?? "";
  }

  /**
   * Makes a change and keeps the previous state. `label` describes it for the user. A change without effect
   * is no step.
   */
  edit(label: string, change: Change, merge = ""): void {
    this.flushTypedText();
    const requested = whole(change);
    const before = this.present(requested);
    if (isSame(before, requested)) return;
    this.apply(requested);
    this.keep(label, before, merge);
    this.tell(requested);
  }

  /** Keeps the state before a change that has been made already, for example by typing. */
  recordChange(label: string, before: Change, merge = ""): void {
    const other = whole(before);
    if (isSame(other, this.present(other))) return;
    this.keep(label, other, merge);
    this.tell(null);
  }

  undo(): void {
    this.go(this.done, this.undoneSteps);
  }

  redo(): void {
    this.go(this.undoneSteps, this.done);
  }

  /**
   * Registers a listener for changes of the undo state, with the applied change; null: it had been made
   * already.
   */
  on(listener: (applied: Change | null) => void): void {
    this.listeners.add(listener);
  }

  /** Turns pending typed text into a separate step. */
  flushTypedText(): void {
    for (const callback of this.beforeStepListeners) callback();
  }

  /**
   * Registers a function that is called before each step: it passes typed text that is in no document yet to
   * recordChange().
   */
  onStep(callback: () => void): void {
    this.beforeStepListeners.add(callback);
  }

  private go(from: Step[], to: Step[]): void {
    this.flushTypedText();
    const step = from.pop();
    if (!step) return;
    // The present state is stored, not the state after the step, so that later changes without a step are
    // restored, too.
    to.push({ label: step.label, other: this.present(step.other), merge: "", at_ms: 0 });
    this.apply(step.other);
    this.forget();
    this.tell(step.other);
  }

  /** Returns the present state of the items of a change. */
  private present({ documents, setup }: Required<Change>): Required<Change> {
    const now = this.session.setup as unknown as Record<string, unknown>;
    return {
      documents: Object.fromEntries(Object.keys(documents).map((name) => [name, this.documents.own(name) ?? null])),
      setup: Object.fromEntries(Object.keys(setup).map((key) => [key, now[key]])),
    };
  }

  private apply({ documents, setup }: Required<Change>): void {
    for (const [name, content] of Object.entries(documents)) {
      if (content === null) this.documents.remove(name);
      else this.documents.put(name, content);
    }
    if (Object.keys(setup).length > 0) this.session.change(setup);
  }

  private keep(label: string, other: Required<Change>, merge: string): void {
    this.undoneSteps.length = 0;
    const at_ms = Date.now();
    const last = this.done.at(-1);
    if (last && merge && last.merge === merge && at_ms - last.at_ms < MERGE_MS) {
      // If two steps affect the same item, the first one has the original state.
      last.other = { documents: { ...other.documents, ...last.other.documents }, setup: { ...other.setup, ...last.other.setup } };
      last.at_ms = at_ms;
    } else {
      this.done.push({ label, other, merge, at_ms });
    }
    this.forget();
  }

  /** Drops the oldest steps if all together are too large; the last one stays. */
  private forget(): void {
    let characters = [...this.done, ...this.undoneSteps].reduce((sum, step) => sum + stepSize(step), 0);
    while (characters > this.mostCharacters && this.done.length > 1) characters -= stepSize(this.done.shift()!);
  }

  private tell(applied: Change | null): void {
    for (const listener of this.listeners) listener(applied);
  }
}
