// Elements of the bar for the folder that gsim-studio serves: saving, marks of unsaved documents, and
// permanent messages.

import { Debounced } from "../../core/debounced";
import { element } from "../../core/dom";
import { download } from "../../core/files";
import type { FileMark, Folder } from "../../core/folder";
import type { Session } from "../../core/session";
import { texts } from "../../texts";
import { FolderSaver } from "./folder_saver";

const words = texts.folder;

const markTexts: Record<FileMark, string> = {
  "": "",
  unsaved: words.unsavedMark,
  gone: words.unsavedMark,
  conflict: words.conflictMark,
};

export interface FolderControls {
  /** Save, and Save all. */
  buttons: HTMLElement;
  /** Messages that stay until their cause has ended. */
  messageArea: HTMLElement;
  /** Returns the mark after a name in choices. */
  markFor(name: string): string;
}

export function createFolderControls(session: Session, folder: Folder): FolderControls {
  const { store } = session;
  const saving = new FolderSaver(session, folder);
  session.setSaver(async (name) => {
    const saved = await saving.save(name);
    if (saved) store.set("notice", words.saved([saved]));
  });
  const saveCurrent = () => session.save(store.get("document"));
  const save = element("button", { id: "save-button", onclick: () => void saveCurrent() }, words.save);
  const all = element("button", { id: "save-all-button", onclick: () => void saving.saveAll() });
  const messageArea = element("div", { class: "standing" });
  const draw = () => {
    const fileMarks = folder.fileMarks();
    const name = store.get("document");
    // A file that was dropped on the page is not in the folder, even if no text was typed.
    const isToSave = fileMarks.has(name) || (session.documents.isUserFile(name) && !folder.has(name));
    if (folder.isDisconnected) showDownloadButtons(save, all, name, fileMarks);
    else showSaveButtons(save, all, name, isToSave, fileMarks);
    messageArea.replaceChildren(...permanentMessages(session, folder, saving, fileMarks));
  };
  const redrawTimer = new Debounced(draw);
  folder.on(() => redrawTimer.after(0));
  store.watch(["document"], draw);
  handleSaveKey(saveCurrent);
  return { buttons: element("span", { class: "saving" }, save, all), messageArea, markFor: (name) => markTexts[folder.markFor(name)] };
}

type FileMarks = Map<string, FileMark>;

function showSaveButtons(save: HTMLButtonElement, all: HTMLButtonElement, name: string, isToSave: boolean, fileMarks: FileMarks): void {
  save.textContent = words.save;
  save.disabled = !isToSave;
  save.title = isToSave ? words.saveTitle(name) : words.savedTitle(name);
  all.hidden = [...fileMarks.keys()].every((each) => each === name);
  all.textContent = words.saveAll(fileMarks.size);
  all.title = words.saveAllTitle([...fileMarks.keys()]);
}

function showDownloadButtons(save: HTMLButtonElement, all: HTMLButtonElement, name: string, fileMarks: FileMarks): void {
  save.textContent = words.download;
  save.disabled = false;
  save.title = words.downloadTitle(name);
  all.hidden = [...fileMarks.keys()].every((each) => each === name);
  all.textContent = words.downloadAll(fileMarks.size);
  all.title = words.downloadTitle([...fileMarks.keys()].join(", "));
}

const messageRow = (text: string, button: string, act: () => void): HTMLElement =>
  element("div", { class: "notice", role: "status" }, text, element("button", { onclick: act }, button));

function permanentMessages(session: Session, folder: Folder, saving: FolderSaver, fileMarks: FileMarks): HTMLElement[] {
  const found: HTMLElement[] = [];
  if (folder.isDisconnected) {
    const name = session.store.get("document");
    found.push(messageRow(words.ended, words.download, () => download(name, session.documents)));
  }
  for (const [name, mark] of fileMarks) {
    if (mark === "conflict") found.push(messageRow(words.conflict(name), words.resolve, () => void saving.resolveConflict(name)));
    if (mark === "gone") found.push(messageRow(words.gone(name), words.saveAgain, () => void saving.save(name)));
  }
  return found;
}

function handleSaveKey(save: () => Promise<void>): void {
  document.addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() !== "s" || !(event.ctrlKey || event.metaKey) || event.altKey || event.shiftKey) return;
    event.preventDefault();
    // A held key saves only once. An open dialog concerns data that the page must leave unchanged.
    if (!event.repeat && !document.querySelector("dialog[open]")) void save();
  });
}
