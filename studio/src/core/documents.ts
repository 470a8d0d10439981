// The files that a person has opened, beside the samples: programs, machines, cells, tools, meshes.

import { readText, writeText, type Writing } from "./encoding";
import type { Files } from "./engine";

export type FileContent = string | Uint8Array;

/** Files that are shown as programs whatever bytes they have, so that what is wrong with them is said. */
const LIKE_PROGRAMS = /\.(nc|ngc|tap|cnc|gcode|g|mpf|eia|txt|lua)$/i;

/** Files by name; who listens is told the name of each that changes. */
export class Documents {
  private readonly own = new Map<string, FileContent>();
  /** What was opened from a disk, or saved there last. */
  private readonly onDisk = new Map<string, { text: string; bytes: Uint8Array; writing: Writing }>();
  private readonly listeners = new Set<(name: string) => void>();

  constructor(readonly samples: ReadonlyMap<string, FileContent>) {}

  get(name: string): FileContent | undefined {
    return this.own.get(name) ?? this.samples.get(name);
  }

  text(name: string): string {
    const content = this.get(name);
    if (content === undefined) return "";
    return typeof content === "string" ? content : new TextDecoder().decode(content);
  }

  /** Puts a file of a disk, of which nothing is lost until it is edited. */
  open(name: string, bytes: Uint8Array): void {
    const { text, writing } = readText(bytes);
    if (text.includes("\0") && !LIKE_PROGRAMS.test(name)) return this.put(name, bytes);
    this.onDisk.set(name, { text, bytes, writing });
    this.put(name, text);
  }

  /** The bytes to save: as they were opened, where nothing is edited; else in the same encoding. */
  save(name: string): Uint8Array | undefined {
    const content = this.get(name);
    if (content === undefined || typeof content !== "string") return content;
    const disk = this.onDisk.get(name);
    const plain = (text: string) => text.replaceAll("\r\n", "\n");
    if (disk && plain(disk.text) === plain(content)) return disk.bytes;
    const writing = disk?.writing ?? { encoding: "utf-8", marked: false, crlf: false };
    const bytes = writeText(content, writing);
    this.onDisk.set(name, { text: content, bytes, writing });
    return bytes;
  }

  /** Whether something was typed that is on no disk. */
  get unsaved(): boolean {
    return [...this.own].some(([name, content]) => {
      const kept = this.onDisk.get(name)?.text ?? this.samples.get(name);
      return typeof content === "string" && typeof kept === "string" && content !== kept.replaceAll("\r\n", "\n") && content !== kept;
    });
  }

  /** Puts a file; samples of that name are left as they are beneath it. */
  put(name: string, content: FileContent): void {
    this.own.set(name, content);
    for (const listener of this.listeners) listener(name);
  }

  /** Whether a person has opened or changed it. */
  isOwn(name: string): boolean {
    return this.own.has(name);
  }

  ownNames(): string[] {
    return [...this.own.keys()];
  }

  on(listener: (name: string) => void): void {
    this.listeners.add(listener);
  }

  /** All that the engine may ask for. */
  files(): Files {
    return new Map([...this.samples, ...this.own]);
  }
}
