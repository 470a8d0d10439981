// Button for entering the cell, if the browser has a headset.

import { element } from "../../core/dom";
import { texts } from "../../texts";
import type { CreateHeadset } from "../headset_context";
import { icon } from "../icons";
import { Headset } from "./headset";

const words = texts.view.headset;

export const createHeadset: CreateHeadset = async ({ view, store, frames, toolbar }) => {
  const system = navigator.xr;
  const isSupported = await system?.isSessionSupported("immersive-vr").catch(() => false);
  if (!system || !isSupported) return;
  const button = element("button", { type: "button" }, icon("headset"));
  const worn = element("p", { class: "worn", role: "status" }, words.worn);
  const show = () => {
    const label = headset.isActive ? words.leave : words.enter;
    if (headset.isActive) view.canvas.element.after(worn);
    else worn.remove();
    Object.assign(button, { title: label, ariaLabel: label, ariaPressed: String(headset.isActive) });
  };
  const headset = new Headset(view, store, frames, system, show);
  const enter = async () => {
    store.set("notice", "");
    button.disabled = true;
    await headset.enter().catch((error: Error) => store.set("notice", words.refused(error.message)));
    button.disabled = false;
  };
  button.onclick = () => void (headset.isActive ? headset.leave() : enter());
  show();
  toolbar.append(button);
};
