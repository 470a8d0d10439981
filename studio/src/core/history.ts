// What a person has changed, by whatever part of the page: texts of documents and choices of the setup, to be taken back and
// done again.

import type { Documents } from "./documents";
import type { FileContent } from "./file_content";
import type { Setup } from "./setup";

/** Documents with their contents (null: there is none of a person's own), and choices of the setup. */
export interface Change {
  documents?: Record<string, FileContent | null>;
  setup?: Partial<Setup>;
}

/** What the history needs of the session. */
interface HasSetup {
  readonly setup: Readonly<Setup>;
  change(setup: Partial<Setup>): void;
}

/** What was changed, and what was there: on the other side of the change. */
interface Step {
  label: string;
  other: Required<Change>;
  /** Steps that follow on each other with the same word are one, as letters of a word that is typed; empty: never. */
  merge: string;
  at_ms: number;
}

/** Steps of one word that are this near to each other are one. */
const MERGE_MS = 1500;
/** Texts of large programs are kept whole: the oldest steps go when all together have more characters than this. */
const MOST_CHARACTERS = 200_000_000;

const whole = ({ documents = {}, setup = {} }: Change): Required<Change> => ({ documents, setup });

const sizeOf = ({ other }: Step): number =>
  Object.values(other.documents).reduce((sum, content) => sum + (content?.length ?? 0), 0);

/** Of two changes of the same documents and choices. */
function isSame(one: Required<Change>, other: Required<Change>): boolean {
  const equal = (a: object, b: object) => Object.entries(a).every(([key, value]) => (b as Record<string, unknown>)[key] === value);
  return equal(one.documents, other.documents) && equal(one.setup, other.setup);
}

export class History {
  private readonly done: Step[] = [];
  private readonly undone: Step[] = [];
  private readonly listeners = new Set<(applied: Change | null) => void>();
  private readonly keepers = new Set<() => void>();

  constructor(
    private readonly documents: Documents,
    private readonly session: HasSetup,
    private readonly mostCharacters = MOST_CHARACTERS,
  ) {}

  /** What undo() would take back, and redo() do again; empty: nothing. */
  get undoLabel(): string {
    return this.done.at(-1)?.label ?? "";
  }

  get redoLabel(): string {
    return this.undone.at(-1)?.label ?? "";
  }

  /** Makes a change and keeps what was there. `label` says what, for people. What changes nothing is no step. */
  edit(label: string, change: Change, merge = ""): void {
    this.keepTyped();
    const wanted = whole(change);
    const before = this.present(wanted);
    if (isSame(before, wanted)) return;
    this.apply(wanted);
    this.keep(label, before, merge);
    this.tell(wanted);
  }

  /** Keeps what was there before a change that has been made already, as by typing. */
  made(label: string, before: Change, merge = ""): void {
    const other = whole(before);
    if (isSame(other, this.present(other))) return;
    this.keep(label, other, merge);
    this.tell(null);
  }

  undo(): void {
    this.go(this.done, this.undone);
  }

  redo(): void {
    this.go(this.undone, this.done);
  }

  /** Told of each change of what can be undone, with what was applied; null: it had been made already. */
  on(listener: (applied: Change | null) => void): void {
    this.listeners.add(listener);
  }

  /** What a person has typed becomes a step of its own, wherever it is still kept back. */
  keepTyped(): void {
    for (const keeper of this.keepers) keeper();
  }

  /** Called before each step: hands over by made() what a person has typed and no document has yet. */
  onStep(keeper: () => void): void {
    this.keepers.add(keeper);
  }

  private go(from: Step[], to: Step[]): void {
    this.keepTyped();
    const step = from.pop();
    if (!step) return;
    // As it is now, and not as the step left it: what was changed since without a step of its own comes back, too.
    to.push({ label: step.label, other: this.present(step.other), merge: "", at_ms: 0 });
    this.apply(step.other);
    this.forget();
    this.tell(step.other);
  }

  /** What stands where a change would be. */
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
    this.undone.length = 0;
    const at_ms = Date.now();
    const last = this.done.at(-1);
    if (last && merge && last.merge === merge && at_ms - last.at_ms < MERGE_MS) {
      // Of two that touch the same, the first one knows what was there.
      last.other = { documents: { ...other.documents, ...last.other.documents }, setup: { ...other.setup, ...last.other.setup } };
      last.at_ms = at_ms;
    } else {
      this.done.push({ label, other, merge, at_ms });
    }
    this.forget();
  }

  /** The oldest steps, where all together are too large; the last one stays. */
  private forget(): void {
    let characters = [...this.done, ...this.undone].reduce((sum, step) => sum + sizeOf(step), 0);
    while (characters > this.mostCharacters && this.done.length > 1) characters -= sizeOf(this.done.shift()!);
  }

  private tell(applied: Change | null): void {
    for (const listener of this.listeners) listener(applied);
  }
}
