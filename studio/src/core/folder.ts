// Folder that gsim-studio serves: its files as documents, saving them, and changes by other programs.

import { MAX_DOCUMENT_BYTES } from "./documents";
import type { FileContent } from "./file_content";
import { readText } from "./encoding";
import { texts } from "../texts";
import { RejectedRequest, type FolderChange, type FolderFile, type Server } from "./server";
import type { Session } from "./session";
import { TaskQueues } from "./task_queues";

/**
 * Unsaved: typed here and not written; conflict: another program has written it meanwhile; gone: removed from
 * the folder.
 */
export type FileMark = "" | "unsaved" | "conflict" | "gone";

export type SaveResult = { kind: "saved" } | { kind: "conflict" } | { kind: "failed"; why: string };

interface Entry {
  bytes: number;
  /** Tag of the version on the disk; null: it is gone. */
  tag: string | null;
  /** Tag of the version from which the document comes; null: none. */
  base: string | null;
}

/** Files up to so many bytes in total are read at the start of the page, the small ones first. */
const MAX_INITIAL_BYTES = 32_000_000;
const MAX_INITIAL_FILES = 2000;
const MAX_PARALLEL_READS = 3;
const RECONNECT_MS = 2000;

const pause = (ms: number) => new Promise((go) => setTimeout(go, ms));

export class Folder {
  /** Whether the server has ended. */
  isDisconnected = false;
  private readonly files = new Map<string, Entry>();
  /** Serialises writing a file, reading it and handling changes by other programs. */
  private readonly taskQueues = new TaskQueues();
  private readonly reading = new Set<string>();
  private readonly listeners = new Set<() => void>();

  constructor(
    private readonly server: Server,
    private readonly session: Session,
  ) {
    session.on(() => this.readSelectedFiles());
    session.store.watch(["pathFile", "variantsFile"], () => this.readSelectedFiles());
    session.documents.on((name) => {
      if (this.isCreationUndone(name)) void this.readAll([name]);
      this.tell();
    });
  }

  /** Reads the names of the files in the folder. */
  async open(): Promise<void> {
    await this.updateList();
  }

  /** Reads all files that are not too large, and follows changes by other programs. */
  async follow(): Promise<void> {
    void this.readAll(this.initialFileNames());
    for (;;) {
      const changed = (change: FolderChange) => void this.changed(change);
      await this.server.follow(() => void this.updateList().catch(() => {}), changed);
      this.setDisconnected(true);
      await pause(RECONNECT_MS);
    }
  }

  /** Registers a listener for each change of this state. */
  on(listener: () => void): void {
    this.listeners.add(listener);
  }

  has(name: string): boolean {
    return this.files.get(name)?.tag != null;
  }

  /** Returns the version of each file on the disk, by name. */
  versions(): Map<string, string> {
    return new Map([...this.files].flatMap(([name, { tag }]) => (tag === null ? [] : [[name, tag] as const])));
  }

  markFor(name: string): FileMark {
    const entry = this.files.get(name);
    if (entry && entry.tag === null) return "gone";
    if (!this.session.documents.isUnsaved(name)) return "";
    return entry && entry.base !== entry.tag ? "conflict" : "unsaved";
  }

  /** Names with a mark. */
  fileMarks(): Map<string, FileMark> {
    const names = this.session.documents.userFileNames();
    return new Map(names.map((name) => [name, this.markFor(name)] as const).filter(([, mark]) => mark !== ""));
  }

  /** Writes a document into the folder, replacing the version from which it comes. */
  save(name: string): Promise<SaveResult> {
    return this.taskQueues.accept(name, async () => {
      const entry = this.files.get(name);
      // The disk has another version than the page, even if that version could not be read.
      if (entry && entry.tag !== null && entry.base !== entry.tag) return { kind: "conflict" };
      return this.overwriteFile(name, entry?.tag ?? null);
    });
  }

  /** Writes a document under a name that is not used yet, and uses that instead from now on. */
  async saveAs(name: string, to: string): Promise<SaveResult> {
    const { documents, history } = this.session;
    history.flushTypedText();
    const content = documents.get(name);
    const bytes = documents.bytesToSave(name);
    if (bytes === undefined) return { kind: "failed", why: texts.folder.noDocument };
    const isTaken = this.has(to) || (to !== name && documents.own(to) !== undefined);
    const saved = isTaken ? ({ kind: "conflict" } as const) : await this.taskQueues.accept(to, () => this.write(to, bytes, null));
    if (saved.kind === "conflict") return { kind: "failed", why: texts.folder.exists };
    if (saved.kind === "failed") return saved;
    history.flushTypedText();
    documents.storeFolderFile(to, bytes);
    const chosen = Object.entries(this.session.setup).filter(([, value]) => value === name);
    const setup = Object.fromEntries(chosen.map(([key]) => [key, to]));
    const left: Record<string, null> = this.has(name) ? {} : { [name]: null };
    // The user typed while it was written.
    const now = documents.get(name);
    const typed = now === undefined || now === content ? {} : { [to]: now };
    history.edit(texts.folder.savedAs(name, to), { setup, documents: { ...left, ...typed } });
    return saved;
  }

  /** Returns the conflicting version on the disk; null: it is gone meanwhile. */
  async readDiskVersion(name: string): Promise<{ content: FileContent; bytes: Uint8Array; tag: string } | null> {
    const read = await this.server.read(name);
    if (!read) return null;
    const isText = typeof this.session.documents.get(name) === "string";
    return { ...read, content: isText ? readText(read.bytes).text : read.bytes };
  }

  /** Overwrites the version on the disk by this page's; undo restores it. */
  keepMine(name: string): Promise<SaveResult> {
    return this.taskQueues.accept(name, async () => {
      try {
        const theirs = await this.readDiskVersion(name);
        const saved = await this.overwriteFile(name, theirs?.tag ?? null);
        if (saved.kind === "saved" && theirs) this.addUndoStep(name, theirs.content);
        return saved;
      } catch (error) {
        return { kind: "failed", why: errorText(error) };
      }
    });
  }

  /** Shows the version on the disk instead of this page's, which undo restores. */
  loadDiskVersion(name: string): Promise<void> {
    return this.taskQueues.accept(name, async () => {
      try {
        const theirs = await this.readDiskVersion(name);
        if (theirs) this.replaceWithDiskVersion(name, theirs);
        else this.handleRemoval(name);
      } catch (error) {
        this.session.store.set("notice", texts.folder.unread(name, errorText(error)));
      }
    });
  }

  private replaceWithDiskVersion(name: string, theirs: { bytes: Uint8Array; tag: string }): void {
    const { documents, history } = this.session;
    history.flushTypedText();
    const mine = documents.own(name);
    this.recordBaseVersion(name, theirs);
    documents.storeFolderFile(name, theirs.bytes);
    history.recordChange(texts.folder.replaced(name), { documents: { [name]: mine ?? null } });
    this.session.changed([name]);
    this.tell();
  }

  /** Records that the document comes from the folder's version. */
  private recordBaseVersion(name: string, { bytes, tag }: { bytes: Uint8Array; tag: string }): void {
    this.files.set(name, { bytes: bytes.length, tag, base: tag });
  }

  private addUndoStep(name: string, content: FileContent): void {
    this.session.history.recordChange(texts.folder.overwritten(name), { documents: { [name]: content } });
  }

  private async overwriteFile(name: string, tag: string | null): Promise<SaveResult> {
    const { documents, history } = this.session;
    history.flushTypedText();
    const content = documents.get(name);
    const bytes = documents.bytesToSave(name);
    if (content === undefined || bytes === undefined) return { kind: "failed", why: texts.folder.noDocument };
    const saved = await this.write(name, bytes, tag);
    if (saved.kind !== "saved") return saved;
    history.flushTypedText();
    documents.list(name, bytes.length);
    documents.saved(name, content, bytes);
    return saved;
  }

  private async write(name: string, bytes: Uint8Array, tag: string | null): Promise<SaveResult> {
    try {
      let written = await this.server.write(name, bytes, tag);
      // A file that was removed meanwhile is written as a new one.
      if (!written.ok && written.tag === null && tag !== null) written = await this.server.write(name, bytes, null);
      const base = written.ok ? written.tag : (this.files.get(name)?.base ?? null);
      this.files.set(name, { bytes: bytes.length, tag: written.tag, base });
      return { kind: written.ok ? "saved" : "conflict" };
    } catch (error) {
      return { kind: "failed", why: errorText(error) };
    } finally {
      this.tell();
    }
  }

  private async updateList(): Promise<void> {
    const { files, cut } = await this.server.list();
    this.setDisconnected(false);
    if (cut) this.session.store.set("notice", texts.folder.cut);
    const before = [...this.files.keys()];
    const present = new Set(files.map(({ name }) => name));
    for (const file of files) {
      if (this.files.has(file.name)) await this.changed(file);
      else this.add(file);
    }
    // Files missing in a cut list may still exist.
    if (!cut) for (const name of before.filter((each) => !present.has(each))) await this.changed({ name, tag: null });
    this.tell();
  }

  private add({ name, bytes, tag }: FolderFile): void {
    this.files.set(name, { bytes, tag, base: null });
    this.session.documents.list(name, bytes);
  }

  /** Handles a change by another program, or by this page itself. */
  private changed(change: FolderChange): Promise<void> {
    return this.taskQueues.accept(change.name, () => this.applyChange(change));
  }

  private async applyChange({ name, tag }: FolderChange): Promise<void> {
    const entry = this.files.get(name);
    if (tag === (entry?.tag ?? null)) return;
    if (tag === null) return this.handleRemoval(name);
    this.files.set(name, { bytes: entry?.bytes ?? 0, tag, base: entry?.base ?? null });
    if (await this.read(name)) this.reportLoadedChange(name);
    this.tell();
  }

  /** Keeps unsaved or running documents, and marks them as gone. */
  private handleRemoval(name: string): void {
    const { documents, history, setup } = this.session;
    history.flushTypedText();
    const isInUse = documents.isUnsaved(name) || (documents.isUserFile(name) && Object.values(setup).includes(name));
    const entry = this.files.get(name);
    if (entry && isInUse) entry.tag = null;
    else this.files.delete(name);
    documents.removeFolderFile(name);
    if (!isInUse) documents.remove(name);
    this.tell();
  }

  private initialFileNames(): string[] {
    const waiting = [...this.files].filter(([, { base }]) => base === null).sort(([, a], [, b]) => a.bytes - b.bytes);
    let bytes = 0;
    return waiting.filter(([, entry]) => (bytes += entry.bytes) <= MAX_INITIAL_BYTES).slice(0, MAX_INITIAL_FILES).map(([name]) => name);
  }

  /** Reads files of the run and of open forms even if they are chosen late. */
  private readSelectedFiles(): void {
    const { setup, store } = this.session;
    const chosen = [...Object.values(setup), store.get("pathFile"), store.get("variantsFile")];
    void this.readAll(chosen.filter((name) => typeof name === "string"));
  }

  /** Returns true for a file that was created and saved here, and then undone: it is still in the folder. */
  private isCreationUndone(name: string): boolean {
    return this.has(name) && this.files.get(name)!.base !== null && !this.session.documents.isUserFile(name);
  }

  private needsReading(name: string): boolean {
    return this.files.get(name)?.base === null || this.isCreationUndone(name);
  }

  /** Reads files if they are not too large and not loaded. */
  async readAll(names: string[]): Promise<void> {
    const waiting = names.filter((name) => this.needsReading(name) && !this.reading.has(name));
    for (const name of waiting) this.reading.add(name);
    const readPending = async () => {
      for (let name = waiting.shift(); name !== undefined; name = waiting.shift()) {
        await this.taskQueues.accept(name, () => this.read(name!));
        this.reading.delete(name);
      }
    };
    await Promise.all(Array.from({ length: MAX_PARALLEL_READS }, readPending));
  }

  /**
   * Updates the document to the folder's version, if no text was typed here. Returns true if it has changed.
   */
  private async read(name: string): Promise<boolean> {
    const { documents, history, store } = this.session;
    if ((this.files.get(name)?.bytes ?? 0) > MAX_DOCUMENT_BYTES) return true;
    try {
      const read = await this.server.read(name);
      if (!read) return false;
      history.flushTypedText();
      const base = this.files.get(name)?.base ?? null;
      const isSame = equalBytes(read.bytes, documents.bytesToSave(name));
      const keepsPageVersion = documents.isUserFile(name) && (read.tag === base || (documents.isUnsaved(name) && !isSame));
      if (keepsPageVersion) {
        this.files.set(name, { bytes: read.bytes.length, tag: read.tag, base });
        return false;
      }
      this.recordBaseVersion(name, read);
      documents.list(name, read.bytes.length);
      if (isSame && documents.isUserFile(name)) documents.saved(name, documents.get(name)!, read.bytes);
      else {
        const before = documents.own(name);
        documents.storeFolderFile(name, read.bytes);
        // A separate step, so that undoing an earlier step does not remove it, too.
        if (before !== undefined) history.recordChange(texts.folder.replaced(name), { documents: { [name]: before } });
      }
      return !isSame;
    } catch (error) {
      store.set("notice", texts.folder.unread(name, errorText(error)));
      return false;
    }
  }

  private reportLoadedChange(name: string): void {
    const { session } = this;
    const words = texts.folder;
    if (session.changed([name])) session.store.set("notice", words.reloadedAndRun(name));
    else if (session.store.get("document") === name) session.store.set("notice", words.taken(name));
  }

  private setDisconnected(isDisconnected: boolean): void {
    if (this.isDisconnected === isDisconnected) return;
    this.isDisconnected = isDisconnected;
    this.tell();
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}

const errorText = (error: unknown): string => (error instanceof RejectedRequest ? error.message : texts.folder.noAnswer);

const equalBytes = (one: Uint8Array, other: Uint8Array | undefined): boolean =>
  one.length === other?.length && one.every((byte, i) => byte === other[i]);
