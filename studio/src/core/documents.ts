// The files that a person has opened, beside the samples: programs, machines, cells, tools, meshes.

import { readText, writeText, type Writing } from "./encoding";
import type { Files } from "./engine";
import type { FileContent } from "./file_content";
import { isLikeProgram, kindOfFile, type FileKind } from "./kinds";

/** What a program is called that was typed into an empty page. */
export const UNTITLED = "untitled.nc";

/** Of a folder, larger files are not read: an editor does not hold them. */
export const SHOWN_BYTES = 64_000_000;

/** A file as a disk has it. */
interface Kept {
  content: FileContent;
  /** A text with lines as an editor has them. */
  plain: string;
  bytes: Uint8Array;
  writing: Writing;
}

const PLAIN: Writing = { encoding: "utf-8", marked: false, crlf: false };

const plain = (text: string): string => (text.includes("\r") ? text.replaceAll("\r\n", "\n") : text);

/** Programs are texts whatever bytes they have, so that what is wrong with them is said. */
function keptOf(name: string, bytes: Uint8Array): Kept {
  const { text, writing } = readText(bytes);
  if (text.includes("\0") && !isLikeProgram(name)) return { content: bytes, plain: "", bytes, writing };
  return { content: text, plain: plain(text), bytes, writing };
}

/** Files by name; who listens is told the name of each that changes. */
export class Documents {
  private readonly ownFiles = new Map<string, FileContent>();
  /** What was opened from a disk, or saved there last. */
  private readonly onDisk = new Map<string, Kept>();
  /** Sizes of files in a folder which the engine reads by itself. */
  private readonly elsewhere = new Map<string, number>();
  private readonly kinds = new Map<string, FileKind>();
  private readonly listeners = new Set<(name: string) => void>();

  /** `engineHasSamples`: it reads them by itself. */
  constructor(
    readonly samples: ReadonlyMap<string, FileContent>,
    private readonly engineHasSamples = false,
  ) {}

  get(name: string): FileContent | undefined {
    return this.ownFiles.get(name) ?? this.samples.get(name);
  }

  text(name: string): string {
    const content = this.get(name);
    if (content === undefined) return "";
    return typeof content === "string" ? content : new TextDecoder().decode(content);
  }

  /**
   * The contents of a file of a person's disk, to be put here; nothing of it is lost until it is edited. In place of a
   * file of the folder it is an edit.
   */
  read(name: string, bytes: Uint8Array): FileContent {
    const kept = keptOf(name, bytes);
    if (!this.elsewhere.has(name)) this.onDisk.set(name, kept);
    return kept.content;
  }

  /** Puts a file as the folder has it. */
  take(name: string, bytes: Uint8Array): void {
    const kept = keptOf(name, bytes);
    this.onDisk.set(name, kept);
    this.elsewhere.set(name, bytes.length);
    this.put(name, kept.content);
  }

  /** Knows of a file in the folder. */
  list(name: string, bytes: number): void {
    this.elsewhere.set(name, bytes);
  }

  /** The folder has it no longer. */
  unlist(name: string): void {
    if (this.elsewhere.delete(name)) this.tell(name);
  }

  kindOf(name: string): FileKind {
    const known = this.kinds.get(name) ?? kindOfFile(name, this.get(name));
    this.kinds.set(name, known);
    return known;
  }

  /** The size of a file that is in the folder and not in the page; undefined: there is no such file. */
  sizeElsewhere(name: string): number | undefined {
    return this.ownFiles.has(name) ? undefined : this.elsewhere.get(name);
  }

  /** Whether there is such a file: here, among the samples, or in the folder and not read yet. */
  exists(name: string): boolean {
    return this.get(name) !== undefined || this.elsewhere.has(name);
  }

  /** The bytes to save: as they were opened, where nothing is edited; else in the same encoding. */
  toSave(name: string): Uint8Array | undefined {
    const content = this.get(name);
    if (content === undefined || typeof content !== "string") return content;
    const disk = this.onDisk.get(name);
    if (disk && typeof disk.content === "string" && disk.plain === plain(content)) return disk.bytes;
    return writeText(content, disk?.writing ?? PLAIN);
  }

  /** This content is on a disk now, in these bytes. */
  saved(name: string, content: FileContent, bytes: Uint8Array): void {
    const writing = this.onDisk.get(name)?.writing ?? PLAIN;
    this.onDisk.set(name, { content, plain: typeof content === "string" ? plain(content) : "", bytes, writing });
    this.tell(name);
  }

  /** The bytes to save, which are on a disk from now on. */
  save(name: string): Uint8Array | undefined {
    const content = this.get(name);
    const bytes = this.toSave(name);
    if (content !== undefined && bytes !== undefined) this.saved(name, content, bytes);
    return bytes;
  }

  /** Whether something was made or changed that is on no disk. */
  get unsaved(): boolean {
    return this.ownNames().some((name) => this.isUnsaved(name));
  }

  /** Whether it has something that is neither on a disk nor a sample's. */
  isUnsaved(name: string): boolean {
    const content = this.ownFiles.get(name);
    if (content === undefined) return false;
    const disk = this.onDisk.get(name);
    const kept = disk?.content ?? this.samples.get(name) ?? "";
    if (content === kept) return false;
    if (typeof content !== "string" || typeof kept !== "string") return true;
    return plain(content) !== (disk?.plain ?? plain(kept));
  }

  unsavedNames(): string[] {
    return this.ownNames().filter((name) => this.isUnsaved(name));
  }

  /** Puts a file; samples of that name are left as they are beneath it. */
  put(name: string, content: FileContent): void {
    this.ownFiles.set(name, content);
    this.tell(name);
  }

  /** What a person has put there; undefined: the sample, or nothing. */
  own(name: string): FileContent | undefined {
    return this.ownFiles.get(name);
  }

  /** Takes a file away; a sample of that name is there again. */
  remove(name: string): void {
    if (!this.ownFiles.delete(name)) return;
    this.tell(name);
  }

  /** Whether a person has opened or changed it. */
  isOwn(name: string): boolean {
    return this.ownFiles.has(name);
  }

  ownNames(): string[] {
    return [...this.ownFiles.keys()];
  }

  /** All that may be chosen: what a person has opened, what else is in the folder, then samples. */
  names(): string[] {
    const opened = this.ownNames().filter((name) => !this.elsewhere.has(name));
    return [...new Set([...opened, ...this.elsewhere.keys(), ...this.samples.keys()])];
  }

  /** Told of each file that is another one, is saved, or is in the folder no longer. */
  on(listener: (name: string) => void): void {
    this.listeners.add(listener);
  }

  /** All that the engine may ask for and cannot read by itself. */
  files(): Files {
    const own = [...this.ownFiles].filter(([name]) => !this.elsewhere.has(name) || this.isUnsaved(name));
    return new Map([...(this.engineHasSamples ? [] : this.samples), ...own]);
  }

  private tell(name: string): void {
    this.kinds.delete(name);
    for (const listener of this.listeners) listener(name);
  }
}
