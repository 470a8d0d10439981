// Changes of the machine's files, one after another: each is made on the text that the one before has left.

import type { Change } from "../../../core/history";
import { referenceTo } from "../../../core/references";
import type { Setup } from "../../../core/setup";
import { texts } from "../../../texts";
import { moved, copyName } from "./file_names";
import type { Model, FileRole } from "./model";
import { requestToml, type TomlPath, type TomlChange } from "./toml";

const words = texts.machine;

/** Error with a message why a change could not be made. */
class RejectedRequest extends Error {}

/** Place that names a file. */
type Owner = { key: keyof Setup } | { part: FileRole; at: TomlPath };

const MAX_ATTEMPTS = 3;

export class Edits {
  private last: Promise<unknown> = Promise.resolve();
  /** Copies of samples that were made here, by the names of the samples. */
  private readonly copies = new Map<string, string>();

  constructor(private readonly model: Model) {}

  /**
   * Makes changes of the shown file; a sample is copied first. Returns an empty text, or why nothing was
   * changed. Calls `made` when it is certain what the change will be, before anything is redrawn.
   */
  change(part: FileRole, label: string, changes: TomlChange[], made = () => {}): Promise<string> {
    const file = this.model.file(part);
    const change = async () => (this.isStillUsed(part, file) ? this.changed(part, changes) : null);
    return this.queue(() => this.make(label, change, made));
  }

  /** True if a part still uses the given file, or the copy of that. */
  private isStillUsed(part: FileRole, file: string): boolean {
    const now = this.model.file(part);
    return now === file || now === this.copies.get(file);
  }

  /** Copies the file if it is a sample; returns the name of the file that may be changed. */
  async own(part: FileRole): Promise<string> {
    const file = await this.untilSettled(part);
    if (file !== this.model.file(part)) return file;
    const name = this.userFileName(part);
    if (name !== this.model.file(part)) await this.change(part, words.copied(name), []);
    return name;
  }

  /** Returns the name of the shown file, after all earlier changes of files have been made. */
  untilSettled(part: FileRole): Promise<string> {
    const file = this.model.file(part);
    return this.queue(async () => {
      await this.model.read();
      return this.isStillUsed(part, file) ? this.model.file(part) : (this.copies.get(file) ?? file);
    });
  }

  private queue<T>(act: () => Promise<T>): Promise<T> {
    const next = this.last.then(act, act);
    this.last = next;
    return next;
  }

  /** A change of null means that its file is no longer in use. */
  private async make(label: string, change: () => Promise<Change | null>, made: () => void): Promise<string> {
    const { history } = this.model.session;
    try {
      for (let i = 0; i < MAX_ATTEMPTS; ++i) {
        await this.model.read();
        const before = this.currentTexts();
        const requested = await change();
        // The user may have edited the text meanwhile.
        if (before !== this.currentTexts()) continue;
        if (!requested) return this.dropped(words.otherFile(label));
        made();
        history.edit(label, requested);
        await this.model.read();
        return "";
      }
      return this.dropped(words.changedMeanwhile);
    } catch (error) {
      if (error instanceof RejectedRequest) return error.message;
      throw error;
    }
  }

  /** Reports in the notice, because the form that requested it may now show something else. */
  private dropped(why: string): string {
    this.model.store.set("notice", why);
    return why;
  }

  /** Returns the inputs of a change: the texts of the files, and their names. */
  private currentTexts(): string {
    const { session, parts, store } = this.model;
    const { machine, cell, robots } = session.setup;
    const files = [...parts.values()].map(({ file }) => `${file}\n${session.documents.text(file)}`);
    return [machine, cell, robots, store.get("robot"), ...files].join("\n");
  }

  private userFileName(part: FileRole): string {
    const { documents } = this.model.session;
    const file = this.model.file(part);
    return documents.isUserFile(file) ? file : copyName(file, (name) => documents.exists(name));
  }

  /** Returns the changes of all files that a change of one of them causes. */
  private async changed(part: FileRole, changes: TomlChange[]): Promise<Change> {
    const { model } = this;
    const file = model.file(part);
    const name = this.userFileName(part);
    const { written, error } = await requestToml(model.session, file, [...moved(model.value(part), file, name), ...changes]);
    if (!written) throw new RejectedRequest(error.text);
    const named = name === file ? {} : await this.named(part, name);
    if (name !== file) this.copies.set(file, name);
    return { documents: { ...named.documents, [name]: written.text }, setup: named.setup ?? {} };
  }

  private async named(part: FileRole, name: string): Promise<Change> {
    const owner = this.ownerOf(part);
    if ("key" in owner) return { setup: { [owner.key]: name } };
    const ownerFile = this.userFileName(owner.part);
    return this.changed(owner.part, [{ op: "set", at: owner.at, value: referenceTo(ownerFile, name) }]);
  }

  private ownerOf(part: FileRole): Owner {
    if (part === "controller") return { part: "machine", at: ["controller", "model"] };
    if (part === "robots") return { key: "robots" };
    return this.model.parts.has("robots") ? { part: "robots", at: ["robot", this.model.robot, part] } : { key: part };
  }

  /** Uses a file, which may be new, for a part. */
  choose(part: FileRole, label: string, name: string, text?: string): Promise<string> {
    const chosen = async () => {
      const { documents = {}, setup = {} } = await this.named(part, name);
      return { documents: text === undefined ? documents : { ...documents, [name]: text }, setup };
    };
    return this.queue(() => this.make(label, chosen, () => {}));
  }
}
