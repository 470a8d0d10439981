// Files that a person drops on the page or chooses: they become documents, and the setup takes those that it can use.

import type { Documents } from "../core/documents";
import { baseName, dialectOfName, kindOfFile, type FileKind } from "../core/kinds";
import type { Session, Setup } from "../core/session";
import { texts } from "../texts";

const words = texts.bar;

interface Opened {
  name: string;
  file: File;
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

/** Which of several programs runs: one of the upper folders before those below, by name. */
const byFolder = (a: Opened, b: Opened): number =>
  a.name.split("/").length - b.name.split("/").length || a.name.localeCompare(b.name);

async function open(opened: Opened[], session: Session): Promise<void> {
  const { documents, store } = session;
  opened.sort(byFolder);
  for (const { name, file } of opened) documents.open(name, new Uint8Array(await file.arrayBuffer()));
  const names = opened.map(({ name }) => name);
  const change = takeFiles(names, documents);
  const taken = new Set<unknown>(Object.values(change));
  const aside = names.filter((name) => !taken.has(name));
  const said = aside.length > 0 ? words.aside(names.length - aside.length, aside) : "";
  if (taken.size > 0) {
    session.change(change);
    if (session.setup.program) await session.run();
  }
  store.set("notice", said);
}

/** The files of an entry, folders gone through; names are those below the dropped folder. */
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

/** What newer browsers give in place of entries, which Chromium does not read in a page from a disk. */
interface Handle {
  kind: "file" | "directory";
  name: string;
  getFile(): Promise<File>;
  values(): AsyncIterable<Handle>;
}

async function filesOfHandle(handle: Handle, path: string): Promise<Opened[]> {
  if (handle.kind === "file") return [{ name: path + handle.name, file: await handle.getFile() }];
  const found: Opened[] = [];
  for await (const each of handle.values()) found.push(...(await filesOfHandle(each, `${path}${handle.name}/`)));
  return found;
}

/** Has to ask at once: behind the event there is nothing to be had of its items. */
function filesOfItem(item: DataTransferItem): Promise<Opened[]> {
  const asked = (item as { getAsFileSystemHandle?: () => Promise<Handle | null> }).getAsFileSystemHandle?.();
  const entry = item.webkitGetAsEntry();
  const file = item.getAsFile();
  const alone = file ? [{ name: file.name, file }] : [];
  const byEntry = () => (entry?.isDirectory ? filesOf(entry, "") : Promise.resolve(alone));
  if (!asked) return byEntry();
  return asked.then((handle) => (handle ? filesOfHandle(handle, "") : byEntry())).catch(byEntry);
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
    const items = [...(event.dataTransfer?.items ?? [])].filter((item) => item.kind === "file");
    Promise.all(items.map(filesOfItem))
      .then((all) => open(all.flat(), session))
      .catch((fault: unknown) => session.store.set("notice", words.unread(String(fault))));
  });
}

/** Asks for files by the system's dialog. */
export function chooseFiles(session: Session): void {
  const input = document.createElement("input");
  input.type = "file";
  input.multiple = true;
  input.onchange = () => {
    const opened = [...(input.files ?? [])].map((file) => ({ name: file.name, file }));
    open(opened, session).catch((fault: unknown) => session.store.set("notice", words.unread(String(fault))));
  };
  input.click();
}

/** Gives a document to the person as a file. */
export function saveFile(name: string, documents: Documents): void {
  const bytes = documents.save(name);
  if (bytes === undefined) return;
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([bytes as BlobPart]));
  link.download = baseName(name);
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
