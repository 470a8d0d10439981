// Files that a person drops on the page or chooses: they become documents, and the setup takes those that it can use.

import type { Documents, FileContent } from "../core/documents";
import { dialectOfName, kindOfFile, type FileKind } from "../core/kinds";
import type { Session, Setup } from "../core/session";

interface Opened {
  name: string;
  file: File;
}

const hasText = (bytes: Uint8Array): boolean => !bytes.subarray(0, 4096).includes(0);

async function contentOf(file: File): Promise<FileContent> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  return hasText(bytes) ? new TextDecoder().decode(bytes) : bytes;
}

const keyOf: Partial<Record<FileKind, keyof Setup>> = {
  machine: "machine",
  cell: "cell",
  robots: "robots",
  machine_data: "machine_data",
  program: "program",
};

/** Puts files into the setup, each where it belongs; of several programs the first. */
export function takeFiles(names: string[], documents: Documents): Partial<Setup> {
  const change: Record<string, string> = {};
  for (const name of names) {
    const kind = kindOfFile(name, documents.get(name) ?? "");
    const key = keyOf[kind];
    if (!key || change[key]) continue;
    change[key] = name;
    if (key === "program") change.dialect = dialectOfName(name);
    if (key === "program" && !change.robots) change.robots = "";
  }
  return change;
}

async function open(opened: Opened[], session: Session): Promise<void> {
  for (const { name, file } of opened) session.documents.put(name, await contentOf(file));
  const change = takeFiles(
    opened.map(({ name }) => name),
    session.documents,
  );
  if (Object.keys(change).length === 0) return;
  session.change(change);
  if (session.setup.program) await session.run();
}

/** The files of what was dropped, folders gone through; names are those below the dropped folder. */
async function filesOf(entry: FileSystemEntry, path: string): Promise<Opened[]> {
  if (entry.isFile) {
    const file = await new Promise<File>((take, fail) => (entry as FileSystemFileEntry).file(take, fail));
    return [{ name: path + entry.name, file }];
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const found: Opened[] = [];
  for (;;) {
    const entries = await new Promise<FileSystemEntry[]>((take, fail) => reader.readEntries(take, fail));
    if (entries.length === 0) return found;
    for (const each of entries) found.push(...(await filesOf(each, `${path}${entry.name}/`)));
  }
}

/** What is dropped anywhere on the page is opened. */
export function acceptDrops(session: Session): void {
  const body = document.body;
  body.addEventListener("dragover", (event) => {
    event.preventDefault();
    body.dataset.dropping = "";
  });
  body.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) delete body.dataset.dropping;
  });
  body.addEventListener("drop", (event) => {
    event.preventDefault();
    delete body.dataset.dropping;
    const entries = [...(event.dataTransfer?.items ?? [])].flatMap((item) => item.webkitGetAsEntry() ?? []);
    void Promise.all(entries.map((entry) => filesOf(entry, ""))).then((all) => open(all.flat(), session));
  });
}

/** Asks for files by the system's dialog. */
export function chooseFiles(session: Session): void {
  const input = document.createElement("input");
  input.type = "file";
  input.multiple = true;
  input.onchange = () => {
    const opened = [...(input.files ?? [])].map((file) => ({ name: file.name, file }));
    void open(opened, session);
  };
  input.click();
}

/** Gives a document to the person as a file. */
export function saveFile(name: string, documents: Documents): void {
  const content = documents.get(name);
  if (content === undefined) return;
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content as BlobPart]));
  link.download = name.split("/").pop() ?? name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
