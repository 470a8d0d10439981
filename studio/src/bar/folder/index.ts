// Elements of the bar for the folder that gsim-studio serves: saving, marks of unsaved documents, and
// permanent messages.

import { Debounced } from "../../core/debounced";
import { element } from "../../core/dom";
import { download } from "../../core/files";
import type { FileMark, Folder } from "../../core/folder";
import type { Session } from "../../core/session";
import { texts } from "../../texts";
import { Saving } from "./saving";

const words = texts.folder;

const signs: Record<FileMark, string> = {
  "": "",
  unsaved: words.unsavedMark,
  gone: words.unsavedMark,
  conflict: words.conflictMark,
};

export interface FolderControls {
  /** Save, and Save all. */
  buttons: HTMLElement;
  /** Messages that stay until their cause has ended. */
  standing: HTMLElement;
  /** Returns the mark after a name in choices. */
  markOf(name: string): string;
}

export function createFolderControls(session: Session, folder: Folder): FolderControls {
  const { store } = session;
  const saving = new Saving(session, folder);
  session.saveBy(async (name) => {
    const saved = await saving.save(name);
    if (saved) store.set("notice", words.saved([saved]));
  });
  const saveShown = () => session.save(store.get("document"));
  const save = element("button", { id: "save-button", onclick: () => void saveShown() }, words.save);
  const all = element("button", { id: "save-all-button", onclick: () => void saving.saveAll() });
  const standing = element("div", { class: "standing" });
  const draw = () => {
    const marked = folder.marked();
    const name = store.get("document");
    // A file that was dropped on the page is not in the folder, even if no text was typed.
    const isToSave = marked.has(name) || (session.documents.isOwn(name) && !folder.has(name));
    if (folder.isLost) drawDownloads(save, all, name, marked);
    else drawSaves(save, all, name, isToSave, marked);
    standing.replaceChildren(...sentences(session, folder, saving, marked));
  };
  const soon = new Debounced(draw);
  folder.on(() => soon.after(0));
  store.watch(["document"], draw);
  listenToKeys(saveShown);
  return { buttons: element("span", { class: "saving" }, save, all), standing, markOf: (name) => signs[folder.markOf(name)] };
}

type Marked = Map<string, FileMark>;

function drawSaves(save: HTMLButtonElement, all: HTMLButtonElement, name: string, isToSave: boolean, marked: Marked): void {
  save.textContent = words.save;
  save.disabled = !isToSave;
  save.title = isToSave ? words.saveTitle(name) : words.savedTitle(name);
  all.hidden = [...marked.keys()].every((each) => each === name);
  all.textContent = words.saveAll(marked.size);
  all.title = words.saveAllTitle([...marked.keys()]);
}

function drawDownloads(save: HTMLButtonElement, all: HTMLButtonElement, name: string, marked: Marked): void {
  save.textContent = words.download;
  save.disabled = false;
  save.title = words.downloadTitle(name);
  all.hidden = [...marked.keys()].every((each) => each === name);
  all.textContent = words.downloadAll(marked.size);
  all.title = words.downloadTitle([...marked.keys()].join(", "));
}

const sentence = (text: string, button: string, act: () => void): HTMLElement =>
  element("div", { class: "notice", role: "status" }, text, element("button", { onclick: act }, button));

function sentences(session: Session, folder: Folder, saving: Saving, marked: Marked): HTMLElement[] {
  const found: HTMLElement[] = [];
  if (folder.isLost) {
    const name = session.store.get("document");
    found.push(sentence(words.ended, words.download, () => download(name, session.documents)));
  }
  for (const [name, mark] of marked) {
    if (mark === "conflict") found.push(sentence(words.conflict(name), words.resolve, () => void saving.decide(name)));
    if (mark === "gone") found.push(sentence(words.gone(name), words.goneSave, () => void saving.save(name)));
  }
  return found;
}

function listenToKeys(save: () => Promise<void>): void {
  document.addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() !== "s" || !(event.ctrlKey || event.metaKey) || event.altKey || event.shiftKey) return;
    event.preventDefault();
    // A held key saves only once. An open dialog concerns data that the page must leave unchanged.
    if (!event.repeat && !document.querySelector("dialog[open]")) void save();
  });
}
