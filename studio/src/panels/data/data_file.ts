// The file of machine data that the form is of: the setup's, or one that the first change makes.

import { kindOfFile } from "../../core/kinds";
import type { Session } from "../../core/session";
import { texts } from "../../texts";
import { askData, type Answered, type DataChange } from "./asked";

const words = texts.data;

/** What new data are called. */
const NEW = "shop";

export class DataFile {
  // One change at a time: each is made of the text that the one before left.
  private last: Promise<unknown> = Promise.resolve();

  constructor(private readonly session: Session) {}

  /** Whether no data are chosen: `name` is then what new ones will be called. */
  get isNew(): boolean {
    return this.session.setup.machine_data === "";
  }

  get name(): string {
    return this.session.setup.machine_data || this.newName;
  }

  get newName(): string {
    const taken = new Set(this.session.documents.names());
    let name = `${NEW}.txt`;
    for (let i = 2; taken.has(name); ++i) name = `${NEW}-${i}.txt`;
    return name;
  }

  read(): Promise<Answered> {
    return askData(this.session, this.name, []);
  }

  /** Makes a change of the file that is chosen, which undo takes back; `label` says what. Answers why not, or nothing. */
  change(label: string, change: DataChange, isNew = false): Promise<string> {
    const { name } = this;
    const act = () => this.make(name, label, change, isNew);
    const made = this.last.then(act, act);
    this.last = made;
    return made;
  }

  /** Until all changes that were begun before have been made, or refused. */
  async settled(): Promise<void> {
    await this.last.catch(() => {});
  }

  /** Why a change could not be, or nothing; nothing is changed. */
  async refusalOf(change: DataChange, isNew = false): Promise<string> {
    const answered = await this.after(change, isNew);
    return answered.data ? "" : answered.refusal;
  }

  /** Takes a file of a disk for the run; answers why not, or nothing. */
  take(name: string, bytes: Uint8Array): string {
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
      const answered = await this.after(change, isNew);
      // What has been written there meanwhile is changed in its turn.
      if (this.name !== name || documents.get(name) !== content) continue;
      if (!answered.data) return answered.refusal;
      history.edit(label, { documents: { [name]: answered.data.text }, setup: { machine_data: name } });
      return "";
    }
  }

  /** What comes of a change; `isNew`: of one that adds an entry, and leaves those alone that there are. */
  private async after(change: DataChange, isNew: boolean): Promise<Answered> {
    const answered = await askData(this.session, this.name, [change]);
    if (!isNew || !answered.data || change.op !== "set") return answered;
    const before = await this.read();
    const count = ({ data }: Answered) => data?.entries[change.section]?.length ?? 0;
    if (count(answered) > count(before)) return answered;
    return { told: answered.told, data: null, refusal: words.isThere(change.id) };
  }
}
