// File of machine data that the form edits: that of the setup, or one that the first change makes.

import { kindOfFile } from "../../core/file_kinds";
import type { Session } from "../../core/session";
import { texts } from "../../texts";
import { requestData, type DataResult, type DataChange } from "./data_request";

const words = texts.data;

/** What new data are called. */
const DEFAULT_NAME = "shop";

export class DataFile {
  // One change at a time: each is made on the text that the one before has left.
  private last: Promise<unknown> = Promise.resolve();

  constructor(private readonly session: Session) {}

  /** True if no data are chosen: `name` is then the name for new data. */
  get isNew(): boolean {
    return this.session.setup.machine_data === "";
  }

  get name(): string {
    return this.session.setup.machine_data || this.newName;
  }

  get newName(): string {
    const taken = new Set(this.session.documents.names());
    let name = `${DEFAULT_NAME}.txt`;
    for (let i = 2; taken.has(name); ++i) name = `${DEFAULT_NAME}-${i}.txt`;
    return name;
  }

  read(): Promise<DataResult> {
    return requestData(this.session, this.name, []);
  }

  /**
   * Makes a change of the chosen file, which undo reverts; `label` names it. Returns an error message, or an
   * empty text.
   */
  change(label: string, change: DataChange, isNew = false): Promise<string> {
    const { name } = this;
    const act = () => this.make(name, label, change, isNew);
    const made = this.last.then(act, act);
    this.last = made;
    return made;
  }

  /** Waits until all changes that were begun before have been made or refused. */
  async untilSettled(): Promise<void> {
    await this.last.catch(() => {});
  }

  /** Returns why a change is not possible, or an empty text; changes nothing. */
  async findError(change: DataChange, isNew = false): Promise<string> {
    const response = await this.after(change, isNew);
    return response.data ? "" : response.refusal;
  }

  /** Uses a file from a disk for the run; returns an error message, or an empty text. */
  accept(name: string, bytes: Uint8Array): string {
    const { documents, history } = this.session;
    if (kindOfFile(name, bytes) !== "machine_data") return words.notData(name);
    const read = { [name]: documents.read(name, bytes) };
    history.edit(words.steps.opened(name), { documents: read, setup: { machine_data: name } });
    return "";
  }

  private async make(name: string, label: string, change: DataChange, isNew: boolean): Promise<string> {
    const { documents, history } = this.session;
    for (;;) {
      if (this.name !== name) return words.otherFile(name);
      const content = documents.get(name);
      const response = await this.after(change, isNew);
      // If the text has changed meanwhile, the change is made again on the new text.
      if (this.name !== name || documents.get(name) !== content) continue;
      if (!response.data) return response.refusal;
      history.edit(label, { documents: { [name]: response.data.text }, setup: { machine_data: name } });
      return "";
    }
  }

  /** Returns the result of a change. `isNew`: the change adds an entry and must not alter existing ones. */
  private async after(change: DataChange, isNew: boolean): Promise<DataResult> {
    const response = await requestData(this.session, this.name, [change]);
    if (!isNew || !response.data || change.op !== "set") return response;
    const before = await this.read();
    const count = ({ data }: DataResult) => data?.entries[change.section]?.length ?? 0;
    if (count(response) > count(before)) return response;
    return { diagnostics: response.diagnostics, data: null, refusal: words.alreadyExists(change.id) };
  }
}
