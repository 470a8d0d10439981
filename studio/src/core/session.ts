// What is run, and with what: asks the engine and puts what comes of it into the store.

import { Run, type Told } from "../run/run";
import type { Documents } from "./documents";
import type { Answer, Engine } from "./engine";
import { isScript } from "./kinds";
import type { Language } from "./languages";
import { texts } from "../texts";
import type { Store } from "./store";

/** What a run is made of, as names of documents; empty: none. */
export interface Setup {
  program: string;
  /** Empty: the machine of the cell, or the one built in. */
  machine: string;
  /** "ab9", "rs274ngc"; empty: as the machine file says. */
  dialect: string;
  cell: string;
  machine_data: string;
  robots: string;
  /** Of a control other than the machine file's: its name; empty: as the machine file says. */
  controller: string;
  collisions: boolean;
  feed_override_percent: number;
}

export const emptySetup = (): Setup => ({
  program: "",
  machine: "",
  dialect: "",
  cell: "",
  machine_data: "",
  robots: "",
  controller: "",
  collisions: true,
  feed_override_percent: 100,
});

/** Of a run in the page, each of which takes some 300 bytes: an endless program ends before memory does. */
const MOST_BLOCKS = 4_000_000;

/** Whether a run came to its end, so that its time means something beside another's. */
const isComparable = ({ report }: Run): boolean => report?.status === "completed" || report?.status === "violations";

export class Session {
  private readonly listeners = new Set<() => void>();
  private current = emptySetup();
  private known: Promise<Language[]> | null = null;

  /** Two engines, so that checking while one types does not wait for a run. */
  constructor(
    readonly store: Store,
    readonly documents: Documents,
    private readonly runner: Engine,
    private readonly checker: Engine,
  ) {}

  get setup(): Readonly<Setup> {
    return this.current;
  }

  get canRun(): boolean {
    return this.runner.available;
  }

  change(change: Partial<Setup>): void {
    this.current = { ...this.current, ...change };
    for (const listener of this.listeners) listener();
  }

  /** Told of each change of the setup. */
  on(listener: () => void): void {
    this.listeners.add(listener);
  }

  private request(what: string, program: string): Record<string, unknown> {
    const { machine, dialect, cell, machine_data } = this.current;
    return { do: what, program, machine, dialect, cell, machine_data };
  }

  /** Runs the program, in place of a run under way. The run before stays for comparing. */
  async run(): Promise<void> {
    if (this.store.get("running")) this.cancel();
    const { store, documents, current } = this;
    const run = new Run(this.sources());
    const running = { done: 0, total: 0 };
    store.set("running", running);
    const request = {
      ...this.request("run", current.program),
      robots: current.robots,
      collisions: current.collisions,
      feed_override_percent: current.feed_override_percent,
      explain: true,
      blocks: MOST_BLOCKS,
    };
    store.set("notice", "");
    const answer = await this.runner.ask(request, documents.files(), (message) => {
      if (message.is === "progress") {
        store.set("running", { done: message.header.done as number, total: message.header.total as number });
      } else {
        run.take(message);
        if (message.is === "segments") this.showMotion(run);
      }
    });
    if (answer.code === "cancelled") return;
    store.set("running", null);
    this.show(run, answer);
  }

  /** Programs of loops tell no progress by their lines: what has moved does. */
  private showMotion(run: Run): void {
    const running = this.store.get("running");
    if (!running || running.total > 0) return;
    this.store.set("running", { done: Math.max(running.done, run.robots[0]?.blocks.count ?? 0), total: 0 });
  }

  private show(run: Run, answer: Answer): void {
    if (!answer.ok) run.failure ??= { code: answer.code, message: answer.message };
    const before = this.store.get("run");
    if (before && isComparable(before)) this.store.set("previous", before);
    this.store.set("playing", false);
    this.store.set("run", run);
    const sameProgram = before?.report?.program === run.report?.program;
    this.store.set("time_s", sameProgram ? Math.min(this.store.get("time_s"), run.end_s) : 0);
  }

  cancel(): void {
    if (!this.store.get("running")) return;
    this.runner.cancel();
    this.store.set("running", null);
    this.store.set("notice", texts.bar.cancelled(this.store.get("run")?.report?.program ?? ""));
  }

  /** What is wrong with a program's text; of a script in Lua nothing is known before it runs. */
  async check(program: string): Promise<Told[]> {
    const told: Told[] = [];
    if (!program || isScript(program)) return told;
    await this.ask("check", program, (header) => told.push(header as unknown as Told));
    return told;
  }

  /** A program as Lua; nothing where it has errors, or is Lua. */
  async translate(program: string): Promise<string | null> {
    if (!program || isScript(program)) return null;
    let script: string | null = null;
    await this.checker.ask(this.request("translate", program), this.documents.files(), (message) => {
      if (message.is === "script") script = new TextDecoder().decode(message.columns.get("lua") as Uint8Array);
    });
    return script;
  }

  /** The volume that the tool reaches, as binary or text STL (mm); null: it cannot be told. */
  async envelope(): Promise<Uint8Array | null> {
    let surface: Uint8Array | null = null;
    await this.checker.ask(this.request("envelope", ""), this.documents.files(), (message) => {
      if (message.is === "envelope") surface = message.columns.get("stl") as Uint8Array;
    });
    return surface;
  }

  /** Both languages; asked for once. */
  languages(): Promise<Language[]> {
    this.known ??= new Promise((resolve) => {
      void this.checker
        .ask({ do: "languages" }, new Map(), (message) => {
          if (message.is === "languages") resolve(message.header.languages as Language[]);
        })
        .then(() => resolve([]));
    });
    return this.known;
  }

  private ask(what: string, program: string, told: (header: Record<string, unknown>) => void): Promise<Answer> {
    return this.checker.ask(this.request(what, program), this.documents.files(), (message) => {
      if (message.is === "told") told(message.header);
    });
  }

  private sources(): Map<string, string> {
    const names = [this.current.program, ...this.documents.ownNames()].filter((name) => name !== "");
    return new Map(names.map((name) => [name, this.documents.text(name)]));
  }
}
