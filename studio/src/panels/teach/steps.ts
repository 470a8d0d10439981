// Step of one press of a button: a length and an angle.

import { element, choice, setOptions } from "../../core/dom";
import type { Units } from "../../core/store";
import { lengthUnit, toMm } from "../../core/units";
import { texts } from "../../texts";

const words = texts.teach;
const lengths: Record<Units, readonly number[]> = { mm: [0.01, 0.1, 1, 10, 100], inch: [0.001, 0.01, 0.1, 1, 4] };
const angles_deg = [0.01, 0.1, 1, 10, 90];

export class StepSizes {
  readonly element: HTMLElement;
  private place = 3;
  private angle_deg = 10;
  private units: Units = "mm";
  private readonly length = choice(words.stepLength, [], "", (value) => (this.place = Number(value)));
  private readonly angle = choice(
    words.stepAngle,
    angles_deg.map((each) => [String(each), `${each}°`] as const),
    String(this.angle_deg),
    (value) => (this.angle_deg = Number(value)),
  );

  constructor() {
    this.element = element("div", { class: "steps" }, element("span", {}, words.step), this.length, this.angle);
  }

  show(units: Units): void {
    this.units = units;
    const options = lengths[units].map((each, i) => [String(i), `${each} ${lengthUnit(units)}`] as const);
    setOptions(this.length, options, String(this.place));
  }

  get step_mm(): number {
    return toMm(lengths[this.units][this.place], this.units);
  }

  get step_deg(): number {
    return this.angle_deg;
  }
}
