// The bar on top: what is run on what, running and cancelling, files, units, theme, help.

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

/** Run, or cancel and how far it is. */
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
    // The one takes the other's place, for the keyboard, too.
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

/** A sentence below the bar, until it is dismissed or a person runs the program. */
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

/** What was typed and not saved is asked for before the page goes. */
function guardEdits(session: Session, folder: Folder | null): void {
  addEventListener("beforeunload", (event) => {
    session.history.keepTyped();
    if (session.documents.unsaved || (folder?.marked().size ?? 0) > 0) event.preventDefault();
  });
}

/** `folder`: the one that gsim-studio serves; null: the page stands alone. */
export function createBar(host: HTMLElement, store: Store, session: Session, folder: Folder | null): void {
  const controls = folder && createFolderControls(session, folder);
  const choices = createChoices(session, controls?.markOf ?? (() => ""));
  folder?.on(() => choices.renew());
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
  host.append(element("div", { class: "notices" }, ...(controls ? [controls.standing] : []), noticeLine(store)));
  guardEdits(session, folder);
  acceptDrops(session);
  document.addEventListener("keydown", (event) => {
    if (!event.defaultPrevented && event.key === "Enter" && (event.ctrlKey || event.metaKey)) void session.run();
  });
}
