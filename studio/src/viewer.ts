// Page that shows a finished run; it changes nothing.

import { createViewerBar } from "./bar/viewer_bar";
import { noEngine } from "./core/engine";
import { splitFrames, readMessage } from "./core/message";
import { embedded } from "./embedded";
import { start } from "./page";
import { createResults } from "./panels/results";
import { Run } from "./run/run";
import { noComparisonView } from "./view/comparison_view_context";
import { noHeadset } from "./view/headset_context";
import { noDraggables } from "./view/draggables";

/** Returns the run that is stored in the page. */
async function loadFinishedRun(): Promise<Run> {
  const run = new Run();
  for (const frame of splitFrames(await embedded.run())) {
    const message = readMessage(frame.slice());
    if (message.is === "source") {
      run.sources.set(message.header.name as string, new TextDecoder().decode(message.columns.get("text") as Uint8Array));
    }
    else run.addMessage(message);
  }
  return run;
}

void start({
  createEngineFactory: () => Promise.resolve(() => noEngine),
  isServed: false,
  openFolder: () => null,
  createBar: createViewerBar,
  createPanels: createResults,
  viewParts: { createDraggables: noDraggables, createHeadset: noHeadset, createComparisonView: noComparisonView },
  begin: async ({ store }) => {
    if (embedded.has("run")) store.set("run", await loadFinishedRun());
  },
});
