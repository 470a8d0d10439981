// Puts a page together, be it to work in or to look at a run.

import "./style.css";
import { Documents } from "./core/documents";
import type { Engine } from "./core/engine";
import { fetchShown } from "./core/fetching";
import type { Folder } from "./core/folder";
import { Frames } from "./core/frames";
import { Session } from "./core/session";
import { Store, initialState } from "./core/store";
import { createCode } from "./code";
import { embedded } from "./embedded";
import { createTime } from "./time";
import { createView, type ViewParts } from "./view";

/** In what the one page is another than the other. */
export interface PageKind {
  /** Makes engines of one kind. */
  engineMaker(): Promise<() => Engine>;
  /** Whether files lie in a folder that gsim-studio serves. */
  isServed: boolean;
  openFolder(session: Session): Folder | null;
  createBar(host: HTMLElement, store: Store, session: Session, folder: Folder | null): void;
  createSide(host: HTMLElement, store: Store, session: Session): void;
  readonly viewParts: ViewParts;
  /** Shows what comes first. */
  begin(session: Session, folder: Folder | null): Promise<void>;
}

/** As the system has it, until a person chooses. */
function followTheme(store: Store): void {
  if (matchMedia("(prefers-color-scheme: dark)").matches) store.set("theme", "dark");
  store.watch(["theme"], () => {
    document.documentElement.dataset.theme = store.get("theme");
  });
}

export async function start(kind: PageKind): Promise<void> {
  const store = new Store(initialState());
  const documents = new Documents(await embedded.samples(), kind.isServed);
  const makeEngine = await kind.engineMaker();
  const session = new Session(store, documents, makeEngine(), makeEngine());
  const folder = kind.openFolder(session);
  const host = (id: string) => document.getElementById(id)!;
  const frames = new Frames();
  followTheme(store);
  fetchShown(store);
  kind.createBar(host("bar"), store, session, folder);
  const view = createView(host("view"), store, session, frames, kind.viewParts);
  createTime(host("time"), store, session, frames);
  createCode(host("code"), store, session);
  kind.createSide(host("side"), store, session);
  await kind.begin(session, folder);
  // For tests and for the curious: what the page knows.
  Object.assign(window, { studio: { store, session, documents, folder, view } });
}
