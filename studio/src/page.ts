// Builds a page, either for work or to view a run.

import "./style.css";
import { AnimationFrames } from "./core/animation_frames";
import { loadVisiblePart } from "./core/chunk_loading";
import { Documents } from "./core/documents";
import type { Engine } from "./core/engine";
import type { Folder } from "./core/folder";
import { Session } from "./core/session";
import { Store, initialState } from "./core/store";
import { createCode } from "./code";
import { embedded } from "./embedded";
import { createTimePanel } from "./time";
import { createView, type ViewParts } from "./view";

/** Differences between the two pages. */
export interface PageKind {
  /** Makes engines of one kind. */
  createEngineFactory(): Promise<() => Engine>;
  /** True if files are in a folder that gsim-studio serves. */
  isServed: boolean;
  openFolder(session: Session): Folder | null;
  createBar(host: HTMLElement, store: Store, session: Session, folder: Folder | null): void;
  createPanels(host: HTMLElement, store: Store, session: Session): void;
  readonly viewParts: ViewParts;
  /** Shows what comes first. */
  begin(session: Session, folder: Folder | null): Promise<void>;
}

/** Uses the theme of the system until the user sets one. */
function followTheme(store: Store): void {
  if (matchMedia("(prefers-color-scheme: dark)").matches) store.set("theme", "dark");
  store.watch(["theme"], () => {
    document.documentElement.dataset.theme = store.get("theme");
  });
}

export async function start(kind: PageKind): Promise<void> {
  const store = new Store(initialState());
  const documents = new Documents(await embedded.samples(), kind.isServed);
  const createEngine = await kind.createEngineFactory();
  const session = new Session(store, documents, createEngine(), createEngine());
  const folder = kind.openFolder(session);
  const host = (id: string) => document.getElementById(id)!;
  const frames = new AnimationFrames();
  followTheme(store);
  loadVisiblePart(store);
  kind.createBar(host("bar"), store, session, folder);
  const view = createView(host("view"), store, session, frames, kind.viewParts);
  createTimePanel(host("time"), store, session, frames);
  createCode(host("code"), store, session);
  kind.createPanels(host("side"), store, session);
  await kind.begin(session, folder);
  // For tests and for curious users: the objects of the page.
  Object.assign(window, { studio: { store, session, documents, folder, view } });
}
