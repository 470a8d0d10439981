// File of variants that is edited: its contents, and its changes, which undo reverts.

import { namesOfKind, baseName } from "../../../core/file_kinds";
import type { Session } from "../../../core/session";
import type { Store } from "../../../core/store";
import { freeName, readVariants, writeVariants, type ReadVariants, type Variant } from "./variants_file";

export class ListFile {
  constructor(
    private readonly store: Store,
    private readonly session: Session,
  ) {}

  /** All that may be chosen. */
  get names(): string[] {
    return namesOfKind("variants", this.session.documents);
  }

  /** True if none or a missing one (any more) is chosen: `name` is then the name for new variants. */
  get isNew(): boolean {
    return !this.session.documents.exists(this.store.get("variantsFile"));
  }

  get name(): string {
    return this.isNew ? this.newName : this.store.get("variantsFile");
  }

  get newName(): string {
    const { documents, setup } = this.session;
    const stem = baseName(setup.program).replace(/\.[^.]*$/, "") || "part";
    let name = `${stem}.variants.json`;
    for (let i = 2; documents.exists(name); ++i) name = `${stem} ${i}.variants.json`;
    return name;
  }

  choose(name: string): void {
    this.store.set("variantsFile", name);
  }

  read(): ReadVariants {
    return this.isNew ? { variants: [], error: "" } : readVariants(this.session.documents.text(this.name));
  }

  /** Makes a change. Does nothing if the file cannot be read, because its contents would be lost. */
  change(label: string, change: (variants: readonly Variant[]) => Variant[]): void {
    const { variants } = this.read();
    if (!variants) return;
    const { name } = this;
    this.session.history.edit(label, { documents: { [name]: writeVariants(change(variants)) } });
    this.store.set("variantsFile", name);
  }

  /** Returns a name that no variant has yet. */
  free(name: string): string {
    return freeName(name, (this.read().variants ?? []).map((each) => each.name));
  }
}
