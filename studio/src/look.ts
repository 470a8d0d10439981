// Page that shows a finished run; it changes nothing.

import { createLookBar } from "./bar/look";
import { noEngine } from "./core/engine";
import { framesOf, readMessage } from "./core/message";
import { embedded } from "./embedded";
import { start } from "./page";
import { createResults } from "./panels/results";
import { Run } from "./run/run";
import { noBeside } from "./view/beside_place";
import { noHeadset } from "./view/headset_place";
import { noHolds } from "./view/holds";

/** Returns the run that is stored in the page. */
async function finishedRun(): Promise<Run> {
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

void start({
  engineMaker: () => Promise.resolve(() => noEngine),
  isServed: false,
  openFolder: () => null,
  createBar: createLookBar,
  createSide: createResults,
  viewParts: { createHolds: noHolds, createHeadset: noHeadset, createBeside: noBeside },
  begin: async ({ store }) => {
    if (embedded.has("run")) store.set("run", await finishedRun());
  },
});
