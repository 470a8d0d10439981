// Current files of the machine and its cell: read again whenever one of them changes.

import { responseDiagnostics } from "../../../core/response_diagnostics";
import { Debounced } from "../../../core/debounced";
import { BUILT_IN_MACHINE } from "../../../core/controller_override";
import { isTomlFile, resolved } from "../../../core/references";
import type { Session } from "../../../core/session";
import type { Store } from "../../../core/store";
import type { EngineDiagnostic } from "../../../run/run";
import { requestToml, tablesAt, textAt, type TomlTable } from "./toml";

const CONTROLLERS = "samples/controllers/";
/** Model for a machine file that names none. */
const DEFAULT_MODEL = "exact-stop";

/** What a file is for. */
export type FileRole = "machine" | "cell" | "controller" | "robots";

export interface LoadedFile {
  file: string;
  /** Null if it is not valid TOML: `error` has the position. */
  value: TomlTable | null;
  error: EngineDiagnostic | null;
}

const PAUSE_MS = 20;

export class Model {
  /** Loaded files; undefined if a part has no file. */
  readonly parts = new Map<FileRole, LoadedFile>();
  /**
   * Controller table of the base model that the machine's controller, or its controller file, starts from.
   */
  controllerBase: TomlTable = {};
  private isVisible = false;
  private reading: Promise<void> = Promise.resolve();
  private asked = 0;
  private readonly updateTimer = new Debounced(() => void this.read());
  private readonly listeners = new Set<() => void>();
  /** Texts that have been read. */
  private readonly known = new Map<string, { text: string; loaded: LoadedFile }>();

  constructor(
    readonly store: Store,
    readonly session: Session,
  ) {
    session.documents.on(() => this.refresh());
    session.on(() => this.refresh());
    store.on("robot", () => this.refresh());
  }

  /** Adds a listener for each new reading of the files. */
  on(listener: () => void): void {
    this.listeners.add(listener);
  }

  /** Reads files only while the form is visible. */
  show(isVisible: boolean): void {
    this.isVisible = isVisible;
    if (isVisible) this.refresh();
  }

  file(part: FileRole): string {
    return this.parts.get(part)?.file ?? "";
  }

  value(part: FileRole): TomlTable {
    return this.parts.get(part)?.value ?? {};
  }

  /** Number of the shown robot, among the robots of a file. */
  get robot(): number {
    return this.shownRobotIndex(this.value("robots"));
  }

  private shownRobotIndex(robots: TomlTable): number {
    return Math.min(this.store.get("robot"), Math.max(tablesAt(robots, ["robot"]).length - 1, 0));
  }

  private refresh(): void {
    if (this.isVisible) this.updateTimer.after(PAUSE_MS);
  }

  /** Waits until the current files are read. */
  read(): Promise<void> {
    this.updateTimer.cancel();
    this.reading = this.readAll();
    return this.reading;
  }

  private async readAll(): Promise<void> {
    const asked = ++this.asked;
    const parts = new Map<FileRole, LoadedFile>();
    const load = async (part: FileRole, file: string) => {
      if (file) parts.set(part, await this.load(file));
      return parts.get(part);
    };
    const { setup } = this.session;
    const robots = await load("robots", setup.robots);
    const referenceOfRobot = (key: string) =>
      robots ? this.resolveReference(robots, ["robot", this.shownRobotIndex(robots.value ?? {}), key]) : "";
    const cell = await load("cell", robots ? referenceOfRobot("cell") : setup.cell);
    const machineFile = robots ? referenceOfRobot("machine") : setup.machine;
    const machine = await load(
      "machine",
      machineFile || (cell ? this.resolveReference(cell, ["cell", "machine"]) : "") || BUILT_IN_MACHINE,
    );
    const model = textAt(machine?.value ?? {}, ["controller", "model"]);
    const controller = isTomlFile(model) ? await load("controller", resolved(machine!.file, model)) : undefined;
    const base = controller ? textAt(controller.value ?? {}, ["controller", "model"]) : model;
    const loadedBase = await this.load(`${CONTROLLERS}${base || DEFAULT_MODEL}.toml`);
    if (asked !== this.asked) return this.reading;
    this.parts.clear();
    for (const [part, loaded] of parts) this.parts.set(part, loaded);
    this.controllerBase = (loadedBase.value?.controller ?? {}) as TomlTable;
    for (const listener of this.listeners) listener();
  }

  private resolveReference({ file, value }: LoadedFile, at: (string | number)[]): string {
    const reference = textAt(value ?? {}, at);
    return reference && resolved(file, reference);
  }

  private async load(file: string): Promise<LoadedFile> {
    // Settings of a controller are read as they are, and changed as text.
    if (!isTomlFile(file)) return { file, value: null, error: null };
    const text = this.session.documents.text(file);
    const known = this.known.get(file);
    if (known?.text === text) return known.loaded;
    const { written, error } = await requestToml(this.session, file, []);
    const loaded = { file, value: written?.value ?? null, error };
    this.known.set(file, { text, loaded });
    return loaded;
  }
}

/** Results of the engine for the machine's files, and for the machine that they define. */
export interface CheckResponse {
  errors: EngineDiagnostic[];
  check: Record<string, unknown> | null;
}

export async function checkMachine(session: Session, machine: string, cell: string, more: Record<string, string> = {}): Promise<CheckResponse> {
  const response = await session.sendRequest({ do: "machine", machine, cell }, more);
  const found = response.messages.find(({ is }) => is === "machine");
  return { errors: responseDiagnostics(response), check: (found?.header.check as Record<string, unknown>) ?? null };
}
