// Draft of a new machine: a sample and the changes to it.

import { baseName } from "../../../core/file_kinds";
import type { Session } from "../../../core/session";
import type { EngineDiagnostic } from "../../../run/run";
import { texts } from "../../../texts";
import { freeName, moved } from "../file/file_names";
import { checkMachine, type CheckResponse } from "../file/model";
import { requestToml, tableAt, tablesAt, valueAt, type TomlPath, type Toml, type TomlChange, type TomlTable } from "../file/toml";
import { machineKinds, type KindName } from "./kinds";

const words = texts.machine.wizard;

/** A machine file. */
export interface NewMachineFile {
  file: string;
  text: string;
}

export class MachineDraft {
  /** What the sample says. */
  sample: TomlTable = {};
  name = "";
  /** True if it has the bodies of the sample; false if the user wants none. */
  hasBodies = true;
  private readonly chosen = new Map<string, Toml | undefined>();

  constructor(
    private readonly session: Session,
    readonly kind: KindName,
  ) {
    this.name = words.kinds[kind].name;
  }

  async begin(): Promise<void> {
    const { written } = await requestToml(this.session, machineKinds[this.kind].sample, []);
    this.sample = written?.value ?? {};
  }

  get axes(): TomlTable[] {
    return tablesAt(this.sample, ["axis"]);
  }

  get(at: TomlPath): Toml | undefined {
    const key = JSON.stringify(at);
    return this.chosen.has(key) ? this.chosen.get(key) : valueAt(this.sample, at);
  }

  /** Sets a value. An axis with its home at an end of its travel keeps it there. */
  set(at: TomlPath, value: Toml | undefined): void {
    const [table, axis, key] = at;
    const unit = /^(?:min|max)_(mm|deg)$/.exec(String(key))?.[1];
    const home = [table, axis, `home_${unit}`];
    const isAtLimit = unit !== undefined && this.get(home) !== undefined && this.get(home) === this.get(at);
    this.chosen.set(JSON.stringify(at), value);
    if (isAtLimit && value !== undefined) this.set(home, value);
  }

  /** "my-mill.toml" */
  get file(): string {
    const bare = this.name.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");
    return freeName(`${bare || "machine"}.toml`, (name) => this.session.documents.exists(name));
  }

  private changes(): TomlChange[] {
    const own = [...this.chosen].flatMap(([key, value]): TomlChange[] => {
      const at = JSON.parse(key) as TomlPath;
      const before = valueAt(this.sample, at);
      if (value === before) return [];
      return [value === undefined ? { op: "remove", at } : { op: "set", at, value }];
    });
    const bodies = ["shape", "ignore"].filter((key) => !this.hasBodies && key in this.sample);
    const { sample, changes } = machineKinds[this.kind];
    return [
      { op: "set", at: ["machine", "name"], value: this.name },
      ...changes,
      ...own,
      ...bodies.map((key): TomlChange => ({ op: "remove", at: [key] })),
      ...moved(this.hasBodies ? this.sample : { ...this.sample, shape: [] }, sample, this.file),
    ];
  }

  /** Returns the draft as a file, or an error if it cannot be made. */
  async make(): Promise<NewMachineFile | EngineDiagnostic> {
    const { sample } = machineKinds[this.kind];
    const { written, error } = await requestToml(this.session, sample, this.changes());
    if (!written) return error;
    const remark = `# ${words.remark(this.name.replaceAll(/\s+/g, " "), baseName(sample))}`;
    return { file: this.file, text: `${remark}\n\n${written.text}` };
  }

  check({ file, text }: NewMachineFile): Promise<CheckResponse> {
    return checkMachine(this.session, file, "", { [file]: text });
  }

  /** True if the sample has bodies. */
  get offersBodies(): boolean {
    return tablesAt(this.sample, ["shape"]).length > 0;
  }

  get model(): string {
    return String(tableAt(this.sample, ["controller"]).model ?? "");
  }
}
