// Current files of the machine and its cell: read again whenever one of them changes.

import { faultsOf } from "../../../core/faults";
import { Debounced } from "../../../core/debounced";
import { BUILT_IN_MACHINE } from "../../../core/other_control";
import { isFile, resolved } from "../../../core/references";
import type { Session } from "../../../core/session";
import type { Store } from "../../../core/store";
import type { Told } from "../../../run/run";
import { askToml, tablesAt, textAt, type TomlTable } from "./toml";

const CONTROLLERS = "samples/controllers/";
/** Model for a machine file that names none. */
const DEFAULT_MODEL = "exact-stop";

/** What a file is for. */
export type Part = "machine" | "cell" | "controller" | "robots";

export interface Loaded {
  file: string;
  /** Null if it is not valid TOML: `fault` has the position. */
  value: TomlTable | null;
  fault: Told | null;
}

const PAUSE_MS = 20;

export class Model {
  /** Loaded files; undefined if a part has no file. */
  readonly parts = new Map<Part, Loaded>();
  /**
   * Controller table of the base model that the machine's controller, or its controller file, starts from.
   */
  controllerBase: TomlTable = {};
  private isShown = false;
  private reading: Promise<void> = Promise.resolve();
  private asked = 0;
  private readonly soon = new Debounced(() => void this.read());
  private readonly listeners = new Set<() => void>();
  /** Texts that have been read. */
  private readonly known = new Map<string, { text: string; loaded: Loaded }>();

  constructor(
    readonly store: Store,
    readonly session: Session,
  ) {
    session.documents.on(() => this.renew());
    session.on(() => this.renew());
    store.on("robot", () => this.renew());
  }

  /** Adds a listener for each new reading of the files. */
  on(listener: () => void): void {
    this.listeners.add(listener);
  }

  /** Reads files only while the form is visible. */
  show(isShown: boolean): void {
    this.isShown = isShown;
    if (isShown) this.renew();
  }

  file(part: Part): string {
    return this.parts.get(part)?.file ?? "";
  }

  value(part: Part): TomlTable {
    return this.parts.get(part)?.value ?? {};
  }

  /** Number of the shown robot, among the robots of a file. */
  get robot(): number {
    return this.shownOf(this.value("robots"));
  }

  private shownOf(robots: TomlTable): number {
    return Math.min(this.store.get("robot"), Math.max(tablesAt(robots, ["robot"]).length - 1, 0));
  }

  private renew(): void {
    if (this.isShown) this.soon.after(PAUSE_MS);
  }

  /** Waits until the current files are read. */
  read(): Promise<void> {
    this.soon.cancel();
    this.reading = this.readAll();
    return this.reading;
  }

  private async readAll(): Promise<void> {
    const asked = ++this.asked;
    const parts = new Map<Part, Loaded>();
    const load = async (part: Part, file: string) => {
      if (file) parts.set(part, await this.load(file));
      return parts.get(part);
    };
    const { setup } = this.session;
    const robots = await load("robots", setup.robots);
    const ofRobot = (key: string) => (robots ? this.referred(robots, ["robot", this.shownOf(robots.value ?? {}), key]) : "");
    const cell = await load("cell", robots ? ofRobot("cell") : setup.cell);
    const named = robots ? ofRobot("machine") : setup.machine;
    const machine = await load("machine", named || (cell ? this.referred(cell, ["cell", "machine"]) : "") || BUILT_IN_MACHINE);
    const model = textAt(machine?.value ?? {}, ["controller", "model"]);
    const controller = isFile(model) ? await load("controller", resolved(machine!.file, model)) : undefined;
    const base = controller ? textAt(controller.value ?? {}, ["controller", "model"]) : model;
    const ofBase = await this.load(`${CONTROLLERS}${base || DEFAULT_MODEL}.toml`);
    if (asked !== this.asked) return this.reading;
    this.parts.clear();
    for (const [part, loaded] of parts) this.parts.set(part, loaded);
    this.controllerBase = (ofBase.value?.controller ?? {}) as TomlTable;
    for (const listener of this.listeners) listener();
  }

  private referred({ file, value }: Loaded, at: (string | number)[]): string {
    const reference = textAt(value ?? {}, at);
    return reference && resolved(file, reference);
  }

  private async load(file: string): Promise<Loaded> {
    // Settings of a controller are read as they are, and changed as text.
    if (!isFile(file)) return { file, value: null, fault: null };
    const text = this.session.documents.text(file);
    const known = this.known.get(file);
    if (known?.text === text) return known.loaded;
    const { written, fault } = await askToml(this.session, file, []);
    const loaded = { file, value: written?.value ?? null, fault };
    this.known.set(file, { text, loaded });
    return loaded;
  }
}

/** Results of the engine for the machine's files, and for the machine that they define. */
export interface Checked {
  faults: Told[];
  check: Record<string, unknown> | null;
}

export async function checkMachine(session: Session, machine: string, cell: string, more: Record<string, string> = {}): Promise<Checked> {
  const answer = await session.question({ do: "machine", machine, cell }, more);
  const found = answer.messages.find(({ is }) => is === "machine");
  return { faults: faultsOf(answer), check: (found?.header.check as Record<string, unknown>) ?? null };
}
