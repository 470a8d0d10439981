// Runs of programs and their inputs: sends requests to the engine and stores the results in the store.

import { Run, type EngineDiagnostic } from "../run/run";
import type { EngineResponse } from "./engine_response";
import type { Documents } from "./documents";
import type { FileContent } from "./file_content";
import type { RequestResult, Engine, Files, RunStorage } from "./engine";
import { responseDiagnostics } from "./response_diagnostics";
import { isScript, kindOfFile, type FileKind } from "./file_kinds";
import { Debounced } from "./debounced";
import { saveFile } from "./files";
import { PartialRun } from "./partial_run";
import { History } from "./history";
import type { Language } from "./languages";
import type { Message } from "./message";
import type { ActiveSettings, QueryActiveModals } from "./active_modals";
import { affectsRun } from "./affects_run";
import { changedSince, createSnapshot, type Origin, type Versions } from "./run_snapshot";
import { BUILT_IN_MACHINE, overrideController } from "./controller_override";
import { emptySetup, type Setup } from "./setup";
import { texts } from "../texts";
import type { Running, Store } from "./store";

/**
 * Limit for a run in the page, with some 300 bytes for each block: an endless program ends before memory
 * does.
 */
export const MAX_BLOCKS = 4_000_000;

/** True if a run came to its end, so that its time can be compared with that of another run. */
const isComparable = ({ report }: Run): boolean => report?.status === "completed" || report?.status === "violations";

const readProgress = ({ header }: Message): Running => ({ done: header.done as number, total: header.total as number });

/** Sets the error of a run that could not be made; an earlier error of the engine stays. */
function withRunError(run: Run, message: string, code = "refused"): Run {
  run.error ??= { code, message };
  return run;
}

/** Delay after a change by a form; the program runs again if no further change comes within this time. */
const RUN_PAUSE_MS = 400;

export class Session {
  /** What forms have changed. */
  readonly history: History;
  private readonly listeners = new Set<() => void>();
  private readonly rerunTimer = new Debounced(() => {
    if (this.current.program) void this.begin();
  });
  private current = emptySetup();
  private readonly partialRun: PartialRun;
  private readonly snapshots = new WeakMap<Run, Origin>();
  /** Counts runs that were begun or ended, so that an outdated run notices it. */
  private turn = 0;
  private isRequestPending = false;
  /** True if a comparison run ended the page's own run, which is then run again after it. */
  private isRerunDue = false;
  private known: Promise<Language[]> | null = null;
  private activeSettingsQuery: QueryActiveModals = () => Promise.resolve(null);
  private versions: () => Versions = () => new Map();
  private saver = async (name: string): Promise<void> => saveFile(name, this.documents);

  /** Uses two engines, so that a check during typing does not wait for a run. */
  constructor(
    readonly store: Store,
    readonly documents: Documents,
    private readonly runner: Engine,
    private readonly checker: Engine,
  ) {
    this.partialRun = new PartialRun(store);
    this.history = new History(documents, this);
    this.history.on((applied) => {
      if (!applied) return;
      if (Object.keys(applied.setup ?? {}).length > 0) this.runSoon();
      else this.changed(Object.keys(applied.documents ?? {}));
    });
  }

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

  /** Adds a listener for changes of the setup. */
  on(listener: () => void): void {
    this.listeners.add(listener);
  }

  /** Runs when no further change comes for a moment. */
  runSoon(): void {
    this.rerunTimer.after(RUN_PAUSE_MS);
  }

  /**
   * Sends a request of a form to the engine (docs/studio.md), with the documents, and with `more`, which are
   * not documents yet.
   */
  async sendRequest(
    request: Record<string, unknown>,
    more: Record<string, FileContent> = {},
    documents: Files = this.documents.files(),
  ): Promise<EngineResponse> {
    const messages: Message[] = [];
    const files = new Map([...documents, ...Object.entries(more)]);
    const response = await this.checker.ask(request, files, (message) => messages.push(message));
    return { ...response, messages };
  }

  /** Saves a document as the page saves: as a file for the user, or into the folder. */
  save(name: string): Promise<void> {
    return this.saver(name);
  }

  /** Sets another function that saves documents. */
  setSaver(saver: (name: string) => Promise<void>): void {
    this.saver = saver;
  }

  /** Sets the function by which the folder, if any, reports the versions of its files. */
  setVersionSource(versions: () => Versions): void {
    this.versions = versions;
  }

  /** Returns the modal state at the start of a line, or null if it is not known. */
  activeSettingsAt(file: string, line: number): Promise<ActiveSettings | null> {
    return this.activeSettingsQuery(file, line);
  }

  /** Sets the source of the modal state: the part of the page that knows the texts. */
  setActiveSettingsQuery(activeSettingsQuery: QueryActiveModals): void {
    this.activeSettingsQuery = activeSettingsQuery;
  }

  /** Runs again if these documents change the run; returns true if they do. */
  changed(names: string[]): boolean {
    const ran = this.store.get("run");
    if (!names.some((name) => affectsRun(name, this.documents.kindOf(name), this.current, ran))) return false;
    this.runSoon();
    return true;
  }

  private request(what: string, program: string, setup: Readonly<Setup> = this.current): Record<string, unknown> {
    const { machine, dialect, cell, machine_data } = setup;
    return { do: what, program, machine, dialect, cell, machine_data };
  }

  /** Runs the program, in place of a run in progress. The previous run stays for comparison. */
  async run(): Promise<void> {
    this.store.set("notice", "");
    await this.begin();
  }

  // A run that starts by itself keeps the notice of the page.
  private async begin(runStorage = this.runner.runStorage): Promise<void> {
    this.end();
    this.isRerunDue = false;
    const { store, current } = this;
    store.set("running", { done: 0, total: 0 });
    const onMessage = (run: Run, message: Message) => {
      if (message.is === "progress") store.set("running", readProgress(message));
      else if (message.is === "segments") this.partialRun.show(run);
    };
    const run = await this.execute(current, onMessage, runStorage);
    if (!run) return;
    if (run.error?.code === "no-room") {
      store.set("notice", texts.folder.notStored(run.error.message));
      return this.begin(null);
    }
    // Listeners to a run that was begun here can distinguish it from an earlier run.
    const { turn } = this;
    this.show(run);
    if (turn === this.turn) store.set("running", null);
  }

  /**
   * Runs another setup than the page's, in place of any run in progress, and shows nothing of it. Returns
   * null if another run or cancelRun() has ended it. A run of the page's own that was due or in progress
   * follows after it, or after those that follow it at once.
   */
  async runComparison(setup: Readonly<Setup>, progress: (running: Running) => void): Promise<Run | null> {
    this.postponeRun();
    const running = this.execute(setup, (_, message) => {
      if (message.is === "progress") progress(readProgress(message));
    });
    const { turn } = this;
    try {
      return await running;
    } finally {
      if (turn === this.turn) this.runPostponed();
    }
  }

  /** Ends the current run; a run of the page's own is made later. */
  private postponeRun(): void {
    this.isRerunDue ||= this.rerunTimer.isDue || this.store.get("running") !== null;
    this.end();
  }

  private runPostponed(): void {
    if (this.isRerunDue) this.runSoon();
    this.isRerunDue = false;
  }

  /**
   * Returns the names of documents that a run would read with other contents now; none for a run that came
   * with the page.
   */
  changedSince(run: Run): string[] {
    const origin = this.snapshots.get(run);
    return origin ? changedSince(run, origin, this.documents, this.versions()) : [];
  }

  /** Returns the inputs of a run; undefined if it came with the page. */
  origin(run: Run): Origin | undefined {
    return this.snapshots.get(run);
  }

  /** Executes a run. With `runStorage` the run may be too long for the page; without it the run is complete. */
  private async execute(
    setup: Readonly<Setup>,
    onMessage: (run: Run, message: Message) => void,
    runStorage: RunStorage | null = null,
  ): Promise<Run | null> {
    const turn = ++this.turn;
    const origin = createSnapshot(setup, this.documents, this.versions());
    const run = runStorage ? this.partialRun.begin(origin.texts, runStorage) : new Run(origin.texts);
    this.snapshots.set(run, origin);
    let files = this.documents.files();
    if (setup.controller) {
      const other = await overrideController(setup, (request) => this.sendRequest(request));
      if (turn !== this.turn) return null;
      if ("refusal" in other) return withRunError(run, other.refusal);
      files = new Map([...files, [other.machine, other.text]]);
    }
    const { robots, collisions, feed_override_percent, rapid_override_percent, spindle_override_percent } = setup;
    const request = {
      ...this.request("run", setup.program, setup),
      ...(setup.controller && { machine: setup.machine || BUILT_IN_MACHINE }),
      ...{ robots, collisions, feed_override_percent, rapid_override_percent, spindle_override_percent },
      explain: true,
      blocks: runStorage?.blocks ?? MAX_BLOCKS,
    };
    this.isRequestPending = true;
    const addMessage = (message: Message) => {
      if (message.is !== "progress") run.addMessage(message);
      onMessage(run, message);
    };
    const response = await this.runner.ask(request, files, addMessage, run.storageKey);
    if (turn === this.turn) this.isRequestPending = false;
    if (response.code === "cancelled") return null;
    return response.ok ? run : withRunError(run, response.message, response.code);
  }

  private show(run: Run): void {
    const before = this.store.get("run");
    if (run.isLong || before?.isLong) this.store.set("previous", null);
    else if (before && isComparable(before)) this.store.set("previous", before);
    this.put(run, before?.report?.program === run.report?.program);
  }

  /** Shows the run; with `goesOn`, at the instant of the previous run of the same program. */
  private put(run: Run, goesOn: boolean): void {
    this.store.set("playing", false);
    this.store.set("run", run);
    this.partialRun.end();
    this.store.set("time_s", goesOn ? Math.min(this.store.get("time_s"), run.end_s) : 0);
  }

  /**
   * Shows an existing run of the documents as they are now. The page takes its setup by a history step named
   * `label`.
   */
  showRun(run: Run, label: string): void {
    const origin = this.snapshots.get(run);
    if (!origin) return;
    if (this.store.get("running")) this.end();
    this.history.edit(label, { setup: origin.setup });
    this.rerunTimer.cancel();
    this.isRerunDue = false;
    const before = this.store.get("run");
    if (run !== before) this.put(run, before?.report?.program === run.report?.program);
  }

  cancel(): void {
    if (!this.store.get("running")) return;
    this.end();
    this.store.set("notice", texts.bar.cancelled(this.store.get("run")?.report?.program ?? ""));
  }

  /** Ends a comparison run. */
  cancelRun(): void {
    this.postponeRun();
    this.runPostponed();
  }

  private end(): void {
    this.rerunTimer.cancel();
    ++this.turn;
    if (this.isRequestPending) this.runner.cancel();
    this.isRequestPending = false;
    this.partialRun.end();
    this.store.set("running", null);
  }

  /** Returns the errors of a program text; none for a Lua script, which is only checked when it runs. */
  async check(program: string): Promise<EngineDiagnostic[]> {
    const diagnostics: EngineDiagnostic[] = [];
    if (!program || isScript(program)) return diagnostics;
    await this.ask("check", program, (header) => diagnostics.push(header as unknown as EngineDiagnostic));
    return diagnostics;
  }

  /** Returns the errors of a file that is not a program, found by the reader of such files. */
  async checkFile(name: string): Promise<EngineDiagnostic[]> {
    const { machine, cell } = this.current;
    const requests: Partial<Record<FileKind, Record<string, unknown>>> = {
      machine: { do: "machine", machine: name },
      cell: { do: "machine", machine, cell: name },
      machine_data: { do: "data", file: name },
      other: machine || cell ? { do: "machine", machine, cell } : undefined,
    };
    const request = requests[kindOfFile(name, this.documents.get(name) ?? "")];
    return request ? responseDiagnostics(await this.sendRequest(request)) : [];
  }

  /** Returns a program as Lua, or null if it has errors or is Lua. */
  async translate(program: string): Promise<string | null> {
    if (!program || isScript(program)) return null;
    let script: string | null = null;
    await this.checker.ask(this.request("translate", program), this.documents.files(), (message) => {
      if (message.is === "script") script = new TextDecoder().decode(message.columns.get("lua") as Uint8Array);
    });
    return script;
  }

  /**
   * Returns the volume that the tool reaches, as binary or text STL (mm), or null if it cannot be determined.
   */
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

  private ask(what: string, program: string, onDiagnostic: (header: Record<string, unknown>) => void): Promise<RequestResult> {
    return this.checker.ask(this.request(what, program), this.documents.files(), (message) => {
      if (message.is === "diagnostic") onDiagnostic(message.header);
    });
  }
}
