// Files of the user's disk: chosen by the system's dialog, and saved.

import type { Documents } from "./documents";
import { element } from "./dom";
import { baseName } from "./file_kinds";

/** Opens the dialog for one file, or for several. */
export function openFileDialog(several: boolean, onFiles: (files: File[]) => void): void {
  const input = element("input", { type: "file", multiple: several, onchange: () => onFiles([...(input.files ?? [])]) });
  input.click();
}

/** Gives a document to the user as a file, and marks it as saved. */
export function saveFile(name: string, documents: Documents): void {
  downloadBytes(name, documents.save(name));
}

/** Does the same for a document that is stored elsewhere. */
export function download(name: string, documents: Documents): void {
  downloadBytes(name, documents.bytesToSave(name));
}

function downloadBytes(name: string, bytes: Uint8Array | undefined): void {
  if (bytes === undefined) return;
  const url = URL.createObjectURL(new Blob([bytes as BlobPart]));
  element("a", { href: url, download: baseName(name) }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}
