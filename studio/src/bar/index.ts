// The bar on top: what is run on what, running and cancelling, files, units, theme, help.

import "./bar.css";
import { element } from "../core/dom";
import { emptySetup, type Session, type Setup } from "../core/session";
import type { Store } from "../core/store";
import { texts } from "../texts";
import { showGallery } from "./gallery";
import { showHelp } from "./help";
import { acceptDrops, chooseFiles, saveFile } from "./open_files";
import { mainChoices, moreChoices } from "./setup";

const t = texts.bar;

function toggle(label: string, title: string, pressed: () => boolean, flip: () => void): HTMLButtonElement {
  return element("button", { title, "aria-label": title, "aria-pressed": String(pressed()), onclick: flip }, label);
}

/** Run, or cancel and how far it is. */
function runControls(store: Store, session: Session): HTMLElement {
  const host = element("span", { class: "run" });
  const draw = () => {
    const running = store.get("running");
    if (!running) {
      const run = element(
        "button",
        { class: "primary", id: "run-button", title: t.runTitle, disabled: !session.setup.program, onclick: () => void session.run() },
        t.run,
      );
      host.replaceChildren(run);
      return;
    }
    const progress = element("progress", { "aria-label": t.running, max: 1 });
    if (running.total > 0) progress.value = Math.min(1, running.done / running.total);
    const done = element("span", { class: "done" }, running.done > 0 ? t.blocks(running.done) : t.running);
    host.replaceChildren(element("button", { id: "cancel-button", onclick: () => session.cancel() }, t.cancel), progress, done);
  };
  store.watch(["running"], draw);
  session.on(draw);
  return host;
}

/** What a page with a finished run says in place of choices. */
function titleOfRun(store: Store): HTMLElement {
  const host = element("span", { class: "of-run" });
  store.watch(["run"], () => {
    const report = store.get("run")?.report;
    host.textContent = report ? `${report.program} · ${report.machine ?? ""}` : "";
  });
  return host;
}

function preferences(store: Store): HTMLElement {
  const host = element("span", { class: "preferences" });
  const draw = () => {
    const inch = store.get("units") === "inch";
    const dark = store.get("theme") === "dark";
    host.replaceChildren(
      toggle(inch ? "inch" : "mm", t.unitsTitle, () => inch, () => store.set("units", inch ? "mm" : "inch")),
      toggle(dark ? "☾" : "☀", t.themeTitle, () => dark, () => store.set("theme", dark ? "light" : "dark")),
      element("button", { title: t.helpTitle, "aria-label": t.helpTitle, onclick: showHelp }, "?"),
    );
  };
  store.watch(["units", "theme"], draw);
  return host;
}

function choices(session: Session): HTMLElement {
  const host = element("span", { class: "choices" });
  const draw = () => {
    const open = host.querySelector("details")?.open ?? false;
    host.replaceChildren(
      ...mainChoices(session),
      element("details", { open }, element("summary", {}, t.changed(changedSettings(session.setup))), element("div", {}, ...moreChoices(session))),
    );
  };
  session.on(draw);
  session.documents.on((name) => {
    // A name that is new belongs into the choices; what changes in a file does not.
    if (!host.querySelector(`option[value="${CSS.escape(name)}"]`)) draw();
  });
  draw();
  return host;
}

/** How many of the settings behind "More" are not as they are at first: what is out of sight is at work, too. */
function changedSettings(setup: Readonly<Setup>): number {
  const first = emptySetup();
  const hidden = ["dialect", "machine_data", "robots", "feed_override_percent", "collisions"] as const;
  return hidden.filter((key) => setup[key] !== first[key]).length;
}

/** A sentence below the bar, until it is dismissed or the next run begins. */
function noticeLine(store: Store): HTMLElement {
  const host = element("div", { class: "notice", role: "status" });
  store.watch(["notice"], () => {
    const text = store.get("notice");
    host.hidden = !text;
    host.replaceChildren(text, element("button", { onclick: () => store.set("notice", ""), "aria-label": t.dismiss }, "×"));
  });
  return host;
}

/** What was typed and not saved is asked for before the page goes. */
function guardEdits(session: Session): void {
  addEventListener("beforeunload", (event) => {
    if (session.documents.unsaved) event.preventDefault();
  });
}

export function createBar(host: HTMLElement, store: Store, session: Session): void {
  const name = element("strong", { class: "name" }, texts.page.title);
  if (!session.canRun) {
    host.append(name, titleOfRun(store), preferences(store));
    return;
  }
  host.append(
    name,
    element("button", { id: "gallery-button", onclick: () => showGallery(session) }, t.samples),
    element("button", { id: "open-button", title: t.openTitle, onclick: () => chooseFiles(session) }, t.open),
    element("button", { title: t.saveTitle, onclick: () => saveFile(session.setup.program, session.documents) }, t.save),
    choices(session),
    runControls(store, session),
    preferences(store),
  );
  host.append(noticeLine(store));
  guardEdits(session);
  acceptDrops(session);
  document.addEventListener("keydown", (event) => {
    if (!event.defaultPrevented && event.key === "Enter" && (event.ctrlKey || event.metaKey)) void session.run();
  });
}
