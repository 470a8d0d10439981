// Page for work on programs.

import { createBar } from "./bar";
import { samples, sampleSetup } from "./bar/gallery";
import { noEngine } from "./core/engine";
import { Folder } from "./core/folder";
import { RemoteEngine } from "./core/remote_engine";
import { Server } from "./core/server";
import { WorkerEngine } from "./core/worker_engine";
import { embedded } from "./embedded";
import { start } from "./page";
import { createPanels } from "./panels";
import { openServedFolder } from "./served";
import { createComparisonView } from "./view/comparison_view";
import { createHandleDraggables } from "./view/create_draggables";
import { createHeadset } from "./view/xr";

const served = embedded.served();
const server = served && new Server(new URL(".", document.baseURI));

void start({
  createEngineFactory: async () => {
    if (server) return () => new RemoteEngine(server);
    if (!embedded.has("engine")) return () => noEngine;
    const module = embedded.module();
    const url = await embedded.workerUrl();
    return () => new WorkerEngine(() => new Worker(url), module);
  },
  isServed: server !== null,
  openFolder: (session) => server && new Folder(server, session),
  createBar,
  createPanels,
  viewParts: { createDraggables: createHandleDraggables, createHeadset, createComparisonView },
  begin: async (session, folder) => {
    if (folder && served) return openServedFolder(session, folder, served);
    if (!session.canRun) return;
    session.change(sampleSetup(samples[0]));
    void session.run();
  },
});
