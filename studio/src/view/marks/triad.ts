// Axes of the world in a corner, as seen by the camera.

import type { Vector3 } from "three";
import { blue, green, vermilion } from "../../core/colours";
import { svgElement } from "../../core/dom";

const AXIS_LENGTH = 24;
const axes = [
  { name: "X", colour: vermilion },
  { name: "Y", colour: green },
  { name: "Z", colour: blue },
];

export class Triad {
  readonly element = svgElement("svg", { class: "triad", viewBox: "-36 -36 72 72", "aria-hidden": "true" });
  private readonly parts = axes.map(({ name, colour }) => {
    const group = svgElement("g");
    const line = svgElement("line", { stroke: colour, "stroke-width": "2.5", "stroke-linecap": "round" });
    const letter = svgElement("text", { fill: colour });
    letter.textContent = name;
    group.append(line, letter);
    this.element.append(group);
    return { group, line, letter };
  });

  turn({ back, right, up }: { back: Vector3; right: Vector3; up: Vector3 }): void {
    const depths = this.parts.map(({ group, line, letter }, i) => {
      const [x, y] = [right.getComponent(i), -up.getComponent(i)];
      line.setAttribute("x2", String(AXIS_LENGTH * x));
      line.setAttribute("y2", String(AXIS_LENGTH * y));
      letter.setAttribute("x", String((AXIS_LENGTH + 7) * x));
      letter.setAttribute("y", String((AXIS_LENGTH + 7) * y));
      return { group, depth: back.getComponent(i) };
    });
    depths.sort((a, b) => a.depth - b.depth);
    for (const { group } of depths) this.element.append(group);
  }
}
