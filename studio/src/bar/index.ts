// Bar at the top: program and machine, running and cancelling, files, units, theme, help.

import "./bar.css";
import { element } from "../core/dom";
import type { Folder } from "../core/folder";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import { texts } from "../texts";
import { createFolderControls } from "./folder";
import { showGallery } from "./gallery";
import { acceptDrops, chooseFiles } from "./open_files";
import { preferences } from "./preferences";
import { createChoices } from "./setup";
import { createUndo } from "./undo";

const t = texts.bar;

/** Creates the Run button, which is replaced by Cancel and the progress. */
function runControls(store: Store, session: Session): HTMLElement {
  const run = element("button", { class: "primary", id: "run-button", title: t.runTitle, onclick: () => void session.run() }, t.run);
  const cancel = element("button", { id: "cancel-button", onclick: () => session.cancel() }, t.cancel);
  const progress = element("progress", { "aria-label": t.running, max: 1 });
  const done = element("span", { class: "done" });
  const draw = () => {
    const running = store.get("running");
    const hadFocus = [run, cancel].includes(document.activeElement as HTMLButtonElement);
    run.disabled = !session.setup.program;
    run.hidden = running !== null;
    for (const each of [cancel, progress, done]) each.hidden = running === null;
    // The button that appears also takes over the keyboard focus.
    if (hadFocus) (running ? cancel : run).focus();
    if (!running) return;
    if (running.total > 0) progress.value = Math.min(1, running.done / running.total);
    else progress.removeAttribute("value");
    done.textContent = running.done > 0 ? t.blocks(running.done) : t.running;
  };
  store.watch(["running"], draw);
  session.on(draw);
  return element("span", { class: "run" }, run, cancel, progress, done);
}

/** Creates a message line below the bar, shown until it is dismissed or the user runs the program. */
function noticeLine(store: Store): HTMLElement {
  const text = element("span", {});
  const dismiss = element("button", { onclick: () => store.set("notice", ""), "aria-label": t.dismiss }, "×");
  const host = element("div", { class: "notice", role: "status" }, text, dismiss);
  store.watch(["notice"], () => {
    text.textContent = store.get("notice");
    host.hidden = !text.textContent;
  });
  return host;
}

/** Warns the user about unsaved text before the page is closed. */
function warnBeforeUnload(session: Session, folder: Folder | null): void {
  addEventListener("beforeunload", (event) => {
    session.history.flushTypedText();
    if (session.documents.unsaved || (folder?.fileMarks().size ?? 0) > 0) event.preventDefault();
  });
}

/** Fills the bar. `folder`: the one that gsim-studio serves; null: the page is used without a server. */
export function createBar(host: HTMLElement, store: Store, session: Session, folder: Folder | null): void {
  const controls = folder && createFolderControls(session, folder);
  const choices = createChoices(session, controls?.markFor ?? (() => ""));
  folder?.on(() => choices.refresh());
  const save = element("button", { title: t.saveTitle, onclick: () => void session.save(session.setup.program) }, t.save);
  host.append(
    element("strong", { class: "name" }, texts.page.title),
    element("button", { id: "gallery-button", onclick: () => showGallery(session) }, t.samples),
    element("button", { id: "open-button", title: t.openTitle, onclick: () => chooseFiles(session) }, t.open),
    controls?.buttons ?? save,
    createUndo(store, session),
    choices.element,
    runControls(store, session),
    preferences(store, folder !== null),
  );
  host.append(element("div", { class: "notices" }, ...(controls ? [controls.messageArea] : []), noticeLine(store)));
  warnBeforeUnload(session, folder);
  acceptDrops(session);
  document.addEventListener("keydown", (event) => {
    if (!event.defaultPrevented && event.key === "Enter" && (event.ctrlKey || event.metaKey)) void session.run();
  });
}
