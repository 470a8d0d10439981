// Puts the page together.

import "./style.css";
import { createBar } from "./bar";
import { openSample, samples } from "./bar/gallery";
import { Documents } from "./core/documents";
import { Engine } from "./core/engine";
import { framesOf, readMessage } from "./core/message";
import { Session } from "./core/session";
import { Store, initialState } from "./core/store";
import { embedded } from "./embedded";
import { createCode } from "./code";
import { createSide } from "./panels";
import { Run } from "./run/run";
import { createTime } from "./time";
import { createView } from "./view";

async function engines(): Promise<[Engine, Engine]> {
  if (!embedded.has("engine")) return [new Engine(null, null), new Engine(null, null)];
  const module = embedded.module();
  const url = await embedded.workerUrl();
  const make = () => new Worker(url);
  return [new Engine(make, module), new Engine(make, module)];
}

/** The run that stands in the page, where one does. */
async function finishedRun(): Promise<Run | null> {
  if (!embedded.has("run")) return null;
  const run = new Run();
  for (const frame of framesOf(await embedded.run())) {
    const message = readMessage(frame.slice());
    if (message.is === "source") {
      run.sources.set(message.header.name as string, new TextDecoder().decode(message.columns.get("text") as Uint8Array));
    }
    else run.take(message);
  }
  return run;
}

/** As the system has it, until a person chooses. */
function followTheme(store: Store): void {
  if (matchMedia("(prefers-color-scheme: dark)").matches) store.set("theme", "dark");
  store.watch(["theme"], () => {
    document.documentElement.dataset.theme = store.get("theme");
  });
}

async function main(): Promise<void> {
  const store = new Store(initialState());
  const documents = new Documents(await embedded.samples());
  const [runner, checker] = await engines();
  const session = new Session(store, documents, runner, checker);
  const host = (id: string) => document.getElementById(id)!;
  followTheme(store);
  createBar(host("bar"), store, session);
  const view = createView(host("view"), store, session);
  createTime(host("time"), store, session);
  createCode(host("code"), store, session);
  createSide(host("side"), store, session);
  const finished = await finishedRun();
  if (finished) store.set("run", finished);
  else if (session.canRun) openSample(samples[0], session);
  // For tests and for the curious: what the page knows.
  Object.assign(window, { studio: { store, session, documents, view } });
}

void main();
