// Short texts at positions in the world, on top of the picture.

import type { Vector3 } from "three";
import { element } from "../../core/dom";
import type { CameraRig } from "../camera";

export interface Label {
  at: Vector3;
  text: string;
  kind: string;
}

export class Labels {
  readonly element = element("div", { class: "labels", "aria-hidden": "true" });
  private readonly known: HTMLElement[] = [];

  show(labels: Label[], rig: CameraRig): void {
    while (this.known.length < labels.length) {
      const span = element("span");
      this.known.push(span);
      this.element.append(span);
    }
    this.known.forEach((span, i) => {
      const label = labels[i];
      const place = label ? rig.project(label.at) : null;
      span.hidden = place === null;
      if (!place) return;
      span.className = label.kind;
      if (span.textContent !== label.text) span.textContent = label.text;
      span.style.transform = `translate(${place.x.toFixed(1)}px, ${place.y.toFixed(1)}px) translate(-50%, -50%)`;
    });
  }
}
