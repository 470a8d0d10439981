// Files that the user drops on the page or chooses: they become documents, and the setup takes those that it
// can use.

import type { FileContent } from "../core/file_content";
import { baseName, dialectOfName, kindOfFile, type FileKind } from "../core/file_kinds";
import { openFileDialog } from "../core/files";
import type { Session } from "../core/session";
import type { Setup } from "../core/setup";
import type { Store } from "../core/store";
import { texts } from "../texts";

const words = texts.bar;

interface OpenedFile {
  name: string;
  file: File;
}

const setupKeys: Partial<Record<FileKind, keyof Setup>> = {
  machine: "machine",
  cell: "cell",
  robots: "robots",
  machine_data: "machine_data",
  program: "program",
};

/** Returns the changes of the setup by files, each in its field; of several programs the first. */
function setupForFiles(files: Record<string, FileContent>): Partial<Setup> {
  const change: Record<string, string> = {};
  for (const [name, content] of Object.entries(files)) {
    const kind = kindOfFile(name, content);
    const key = setupKeys[kind];
    if (!key || change[key]) continue;
    change[key] = name;
    if (key === "program") change.dialect = dialectOfName(name);
    if (key === "program" && !change.robots) change.robots = "";
  }
  return change;
}

/**
 * Passes path files and drawings to the form of paths, variants to theirs; of several the first. Returns
 * those that are taken.
 */
function openInForms(files: Record<string, FileContent>, store: Store): string[] {
  const first = (requested: FileKind) => Object.keys(files).find((name) => kindOfFile(name, files[name]) === requested);
  const [path, drawing] = [first("path"), first("drawing")];
  if (path) store.set("pathFile", path);
  // The same name must trigger a change again.
  if (drawing) for (const name of ["", drawing]) store.set("drawing", name);
  if (path || drawing) store.set("form", "paths");
  const variants = first("variants");
  if (variants) store.set("variantsFile", variants);
  if (variants) store.set("form", "variants");
  return [path, drawing, variants].filter((name) => name !== undefined);
}

/** Orders programs to choose the one to run: upper folders before those below, then by name. */
const compareDepth = (a: OpenedFile, b: OpenedFile): number =>
  a.name.split("/").length - b.name.split("/").length || a.name.localeCompare(b.name);

async function open(opened: OpenedFile[], session: Session): Promise<void> {
  const { documents, history, store } = session;
  opened.sort(compareDepth);
  const files: Record<string, FileContent> = {};
  for (const { name, file } of opened) files[name] = documents.read(name, new Uint8Array(await file.arrayBuffer()));
  const names = Object.keys(files);
  const setup = setupForFiles(files);
  if (names.length > 0) history.edit(words.opened(names.map(baseName)), { documents: files, setup });
  const taken = new Set<unknown>([...Object.values(setup), ...openInForms(files, store)]);
  const unopened = names.filter((name) => !taken.has(name));
  const said = unopened.length > 0 ? words.ignoredFiles(names.length - unopened.length, unopened) : "";
  if (Object.keys(setup).length > 0 && session.setup.program) await session.run();
  store.set("notice", said);
}

/** Returns the files of an entry, including subfolders; names are relative to the dropped folder. */
async function entryFiles(entry: FileSystemEntry, path: string): Promise<OpenedFile[]> {
  if (entry.isFile) {
    const file = await new Promise<File>((fulfil, fail) => (entry as FileSystemFileEntry).file(fulfil, fail));
    return [{ name: path + entry.name, file }];
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const found: OpenedFile[] = [];
  for (;;) {
    const entries = await new Promise<FileSystemEntry[]>((fulfil, fail) => reader.readEntries(fulfil, fail));
    if (entries.length === 0) return found;
    for (const each of entries) found.push(...(await entryFiles(each, `${path}${entry.name}/`)));
  }
}

/** Replacement for entries in newer browsers: Chromium does not read entries in a page from a disk. */
interface Handle {
  kind: "file" | "directory";
  name: string;
  getFile(): Promise<File>;
  values(): AsyncIterable<Handle>;
}

async function filesOfHandle(handle: Handle, path: string): Promise<OpenedFile[]> {
  if (handle.kind === "file") return [{ name: path + handle.name, file: await handle.getFile() }];
  const found: OpenedFile[] = [];
  for await (const each of handle.values()) found.push(...(await filesOfHandle(each, `${path}${handle.name}/`)));
  return found;
}

/** Reads the item at once, because its data are not available after the event. */
function itemFiles(item: DataTransferItem): Promise<OpenedFile[]> {
  const asked = (item as { getAsFileSystemHandle?: () => Promise<Handle | null> }).getAsFileSystemHandle?.();
  const entry = item.webkitGetAsEntry();
  const file = item.getAsFile();
  const alone = file ? [{ name: file.name, file }] : [];
  const readEntry = () => (entry?.isDirectory ? entryFiles(entry, "") : Promise.resolve(alone));
  if (!asked) return readEntry();
  return asked.then((handle) => (handle ? filesOfHandle(handle, "") : readEntry())).catch(readEntry);
}

/** Opens files that are dropped anywhere on the page. */
export function acceptDrops(session: Session): void {
  const body = document.body;
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  body.addEventListener("dragover", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    body.dataset.dropping = "";
  });
  body.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) delete body.dataset.dropping;
  });
  body.addEventListener("drop", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    delete body.dataset.dropping;
    const items = [...(event.dataTransfer?.items ?? [])].filter((item) => item.kind === "file");
    Promise.all(items.map(itemFiles))
      .then((all) => open(all.flat(), session))
      .catch((error: unknown) => session.store.set("notice", words.unread(String(error))));
  });
}

/** Opens the system's file dialog. */
export function chooseFiles(session: Session): void {
  openFileDialog(true, (files) => {
    open(files.map((file) => ({ name: file.name, file })), session).catch((error: unknown) =>
      session.store.set("notice", words.unread(String(error))),
    );
  });
}
