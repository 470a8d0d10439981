// Samples for newcomers.

import { element } from "../core/dom";
import type { Session } from "../core/session";
import { emptySetup, type Setup } from "../core/setup";
import { texts } from "../texts";

interface Sample {
  title: string;
  about: string;
  setup: Partial<Setup>;
}

const { gallery } = texts.bar;

export const samples: Sample[] = [
  {
    ...gallery.wheel,
    setup: { program: "samples/wheel.nc", machine: "samples/machines/af5-measured.toml" },
  },
  {
    ...gallery.rosette,
    setup: {
      program: "samples/rosette.ngc",
      machine: "samples/machines/linuxcnc-router.toml",
      dialect: "rs274ngc",
    },
  },
  {
    ...gallery.forces,
    setup: {
      program: "samples/rosette.ngc",
      machine: "samples/machines/gantry-dynamics.toml",
      dialect: "rs274ngc",
    },
  },
  {
    ...gallery.collision,
    setup: { program: "samples/cell/clamp.nc", cell: "samples/cell/table.toml" },
  },
  {
    ...gallery.robots,
    setup: { program: "samples/cell/cell.lua", robots: "samples/cell/robots.toml" },
  },
  {
    ...gallery.mill,
    setup: { program: "samples/mill/dome.nc", machine: "samples/machines/mill-head-table.toml" },
  },
];

/** Returns the unchanged setup of a sample, regardless of earlier choices. */
export const sampleSetup = (sample: Sample): Setup => ({ ...emptySetup(), ...sample.setup });

export function showGallery(session: Session): void {
  const close = () => dialog.close();
  const cards = samples.map((sample) =>
    element(
      "button",
      {
        class: "card",
        onclick: () => {
          close();
          session.history.edit(gallery.opened(sample.title), { setup: sampleSetup(sample) });
          void session.run();
        },
      },
      element("strong", {}, sample.title),
      element("span", {}, sample.about),
    ),
  );
  const dialog = element(
    "dialog",
    { "aria-label": gallery.title, onclose: () => dialog.remove() },
    element("h2", {}, gallery.title),
    element("div", { class: "cards" }, ...cards),
    element("button", { onclick: close }, texts.bar.close),
  );
  document.body.append(dialog);
  dialog.showModal();
}
