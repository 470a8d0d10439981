// Short texts at places in the world, on top of the picture.

import type { Vector3 } from "three";
import { make } from "../../core/element";
import type { CameraRig } from "../camera";

export interface Label {
  at: Vector3;
  text: string;
  kind: string;
}

export class Labels {
  readonly element = make("div", { class: "labels", "aria-hidden": "true" });
  private readonly known: HTMLElement[] = [];

  show(labels: Label[], rig: CameraRig): void {
    while (this.known.length < labels.length) {
      const element = make("span");
      this.known.push(element);
      this.element.append(element);
    }
    this.known.forEach((element, i) => {
      const label = labels[i];
      const place = label ? rig.project(label.at) : null;
      element.hidden = place === null;
      if (!place) return;
      element.className = label.kind;
      if (element.textContent !== label.text) element.textContent = label.text;
      element.style.transform = `translate(${place.x.toFixed(1)}px, ${place.y.toFixed(1)}px) translate(-50%, -50%)`;
    });
  }
}
