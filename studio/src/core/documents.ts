// Files that the user has opened, in addition to the samples: programs, machines, cells, tools, meshes.

import { readText, writeText, type TextFormat } from "./encoding";
import type { Files } from "./engine";
import type { FileContent } from "./file_content";
import { hasProgramName, kindOfFile, type FileKind } from "./file_kinds";

/** Name of a program that was typed into an empty page. */
export const UNTITLED = "untitled.nc";

/** Larger files of a folder are not read, because an editor cannot hold them. */
export const MAX_DOCUMENT_BYTES = 64_000_000;

/** File as on a disk. */
interface DiskFile {
  content: FileContent;
  /** Text with the editor's line ends. */
  plain: string;
  bytes: Uint8Array;
  textFormat: TextFormat;
}

const DEFAULT_FORMAT: TextFormat = { encoding: "utf-8", hasByteOrderMark: false, crlf: false };

const plain = (text: string): string => (text.includes("\r") ? text.replaceAll("\r\n", "\n") : text);

/** Returns the file. Programs are texts whatever bytes they have, so that their errors are reported. */
function toDiskFile(name: string, bytes: Uint8Array): DiskFile {
  const { text, textFormat } = readText(bytes);
  if (text.includes("\0") && !hasProgramName(name)) return { content: bytes, plain: "", bytes, textFormat };
  return { content: text, plain: plain(text), bytes, textFormat };
}

/** Files by name; listeners get the name of each file that changes. */
export class Documents {
  private readonly userFiles = new Map<string, FileContent>();
  /** Content that was opened from a disk, or saved there last. */
  private readonly diskFiles = new Map<string, DiskFile>();
  /** Sizes of files in a folder that the engine reads by itself. */
  private readonly folderFileSizes = new Map<string, number>();
  private readonly kinds = new Map<string, FileKind>();
  private readonly listeners = new Set<(name: string) => void>();

  /** `engineHasSamples`: the engine reads them by itself. */
  constructor(
    readonly samples: ReadonlyMap<string, FileContent>,
    private readonly engineHasSamples = false,
  ) {}

  get(name: string): FileContent | undefined {
    return this.userFiles.get(name) ?? this.samples.get(name);
  }

  text(name: string): string {
    const content = this.get(name);
    if (content === undefined) return "";
    return typeof content === "string" ? content : new TextDecoder().decode(content);
  }

  /**
   * Returns the content of a file from the user's disk, to be stored here. It counts as saved until it is
   * edited. If it replaces a file of the folder, it is an edit.
   */
  read(name: string, bytes: Uint8Array): FileContent {
    const diskFile = toDiskFile(name, bytes);
    if (!this.folderFileSizes.has(name)) this.diskFiles.set(name, diskFile);
    return diskFile.content;
  }

  /** Stores a file as it is in the folder. */
  storeFolderFile(name: string, bytes: Uint8Array): void {
    const diskFile = toDiskFile(name, bytes);
    this.diskFiles.set(name, diskFile);
    this.folderFileSizes.set(name, bytes.length);
    this.put(name, diskFile.content);
  }

  /** Records a file in the folder. */
  list(name: string, bytes: number): void {
    this.folderFileSizes.set(name, bytes);
  }

  /** Removes a file that is no longer in the folder. */
  removeFolderFile(name: string): void {
    if (this.folderFileSizes.delete(name)) this.tell(name);
  }

  kindOf(name: string): FileKind {
    const known = this.kinds.get(name) ?? kindOfFile(name, this.get(name));
    this.kinds.set(name, known);
    return known;
  }

  /** Returns the size of a file that is in the folder but not in the page; undefined: no such file. */
  folderFileSize(name: string): number | undefined {
    return this.userFiles.has(name) ? undefined : this.folderFileSizes.get(name);
  }

  /** Returns true if the file exists: here, among the samples, or in the folder and not read yet. */
  exists(name: string): boolean {
    return this.get(name) !== undefined || this.folderFileSizes.has(name);
  }

  /** Returns the bytes to save: the opened ones if the text is not edited; else in the same encoding. */
  bytesToSave(name: string): Uint8Array | undefined {
    const content = this.get(name);
    if (content === undefined || typeof content !== "string") return content;
    const disk = this.diskFiles.get(name);
    if (disk && typeof disk.content === "string" && disk.plain === plain(content)) return disk.bytes;
    return writeText(content, disk?.textFormat ?? DEFAULT_FORMAT);
  }

  /** Records that this content is on a disk now, in these bytes. */
  saved(name: string, content: FileContent, bytes: Uint8Array): void {
    const textFormat = this.diskFiles.get(name)?.textFormat ?? DEFAULT_FORMAT;
    this.diskFiles.set(name, { content, plain: typeof content === "string" ? plain(content) : "", bytes, textFormat });
    this.tell(name);
  }

  /** Returns the bytes to save, and counts them as saved from now on. */
  save(name: string): Uint8Array | undefined {
    const content = this.get(name);
    const bytes = this.bytesToSave(name);
    if (content !== undefined && bytes !== undefined) this.saved(name, content, bytes);
    return bytes;
  }

  /** Returns true if new or changed content is on no disk. */
  get unsaved(): boolean {
    return this.userFileNames().some((name) => this.isUnsaved(name));
  }

  /** Returns true if its content is neither on a disk nor a sample's. */
  isUnsaved(name: string): boolean {
    const content = this.userFiles.get(name);
    if (content === undefined) return false;
    const disk = this.diskFiles.get(name);
    const stored = disk?.content ?? this.samples.get(name) ?? "";
    if (content === stored) return false;
    if (typeof content !== "string" || typeof stored !== "string") return true;
    return plain(content) !== (disk?.plain ?? plain(stored));
  }

  unsavedNames(): string[] {
    return this.userFileNames().filter((name) => this.isUnsaved(name));
  }

  /** Stores a file; a sample of that name stays unchanged beneath it. */
  put(name: string, content: FileContent): void {
    this.userFiles.set(name, content);
    this.tell(name);
  }

  /** Returns the user's content; undefined: the sample, or no file. */
  own(name: string): FileContent | undefined {
    return this.userFiles.get(name);
  }

  /** Removes a file; a sample of that name becomes visible again. */
  remove(name: string): void {
    if (!this.userFiles.delete(name)) return;
    this.tell(name);
  }

  /** Returns true if the user has opened or changed it. */
  isUserFile(name: string): boolean {
    return this.userFiles.has(name);
  }

  userFileNames(): string[] {
    return [...this.userFiles.keys()];
  }

  /** Returns all files for the choices: those the user has opened, the others in the folder, then samples. */
  names(): string[] {
    const opened = this.userFileNames().filter((name) => !this.folderFileSizes.has(name));
    return [...new Set([...opened, ...this.folderFileSizes.keys(), ...this.samples.keys()])];
  }

  /** Registers a listener for each file that changes, is saved, or is no longer in the folder. */
  on(listener: (name: string) => void): void {
    this.listeners.add(listener);
  }

  /** Returns all files that the engine may need and cannot read by itself. */
  files(): Files {
    const own = [...this.userFiles].filter(([name]) => !this.folderFileSizes.has(name) || this.isUnsaved(name));
    return new Map([...(this.engineHasSamples ? [] : this.samples), ...own]);
  }

  private tell(name: string): void {
    this.kinds.delete(name);
    for (const listener of this.listeners) listener(name);
  }
}
