// Saves documents into the folder; if two versions exist, the user decides.

import { UNTITLED } from "../../core/documents";
import { baseName } from "../../core/file_kinds";
import { download } from "../../core/files";
import type { Folder, SaveResult } from "../../core/folder";
import type { Session } from "../../core/session";
import { texts } from "../../texts";
import { requestName } from "./request_name";
import { resolveConflict, type ConflictChoice } from "./conflict";

const words = texts.folder;

export class FolderSaver {
  /** Names for which a dialog is open, or about to be. */
  private readonly openDialogs = new Set<string>();

  constructor(
    private readonly session: Session,
    private readonly folder: Folder,
  ) {}

  /** Saves a document. Returns the name under which it is saved now; null: it is not. */
  async save(name: string): Promise<string | null> {
    const { folder, session } = this;
    if (folder.isDisconnected) {
      download(name, session.documents);
      return null;
    }
    if (this.needsName(name)) return this.saveAs(name, baseName(name));
    return this.reportResult(name, await folder.save(name));
  }

  async saveAll(): Promise<void> {
    const saved: string[] = [];
    for (const name of this.folder.fileMarks().keys()) {
      const as = await this.save(name);
      if (as) saved.push(as);
    }
    if (saved.length > 0) this.session.store.set("notice", words.saved(saved));
  }

  /** Shows both versions, and applies the user's decision. */
  async resolveConflict(name: string): Promise<string | null> {
    const { folder } = this;
    switch (await this.ask(name)) {
      case "mine":
        return this.reportResult(name, await folder.keepMine(name));
      case "theirs":
        await folder.loadDiskVersion(name);
        return null;
      case "other": {
        const as = await this.saveAs(name, this.freeName(name));
        if (as) await folder.loadDiskVersion(name);
        return as;
      }
      default:
        return null;
    }
  }

  private async ask(name: string): Promise<ConflictChoice> {
    if (this.openDialogs.has(name)) return "later";
    this.openDialogs.add(name);
    try {
      return await resolveConflict(name, this.folder, this.session.documents);
    } finally {
      this.openDialogs.delete(name);
    }
  }

  private async saveAs(name: string, proposal: string): Promise<string | null> {
    const to = await requestName(name, proposal);
    if (to === null) return null;
    if (to === name) return this.reportResult(name, await this.folder.save(name));
    return this.reportResult(to, await this.folder.saveAs(name, to));
  }

  private async reportResult(name: string, saved: SaveResult): Promise<string | null> {
    if (saved.kind === "conflict") return this.resolveConflict(name);
    if (saved.kind === "saved") return name;
    this.session.store.set("notice", words.notSaved(name, saved.why));
    return null;
  }

  /** Returns true for changed samples, and for text that was typed into an empty page. */
  private needsName(name: string): boolean {
    return !this.folder.has(name) && (name === UNTITLED || name.startsWith("samples/"));
  }

  /** "part-2.nc" */
  private freeName(name: string): string {
    const [, stem, extension] = /^(.*?)(\.[^./]*)?$/.exec(name)!;
    const candidateName = (i: number) => `${stem}-${i}${extension ?? ""}`;
    let i = 2;
    while (this.folder.has(candidateName(i)) || this.session.documents.exists(candidateName(i))) ++i;
    return candidateName(i);
  }
}
