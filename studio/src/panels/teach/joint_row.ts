// One joint: a slider over its range, its value, and two buttons that move it by a step.

import { element } from "../../core/dom";
import type { Units } from "../../core/store";
import { lengthText } from "../../core/units";
import type { Axis } from "../../run/scene";
import { texts } from "../../texts";
import { NumberInput, numberText } from "../paths/fields";
import { holdButton } from "./hold_button";
import { axisRange } from "./jog_state";

const words = texts.teach;
/** Range of the slider on both sides of the current value, for an axis without ends. */
const SLIDER_RANGE = { mm: 1000, deg: 360 };
/** Share of the range; a value closer to an end than this counts as near. */
const NEAR_LIMIT_SHARE = 0.05;

export interface JointEvents {
  set(value: number): void;
  step(sense: 1 | -1): void;
}

export class JointRow {
  readonly element: HTMLElement;
  private readonly slider: HTMLInputElement;
  private readonly input: NumberInput;
  private readonly ends = [element("span", {}), element("span", {})];
  private readonly near = element("span", { class: "near" });
  private middle = NaN;

  constructor(
    readonly axis: Axis,
    on: JointEvents,
  ) {
    const { letter, rotary } = axis;
    this.slider = element("input", {
      type: "range",
      step: "any",
      "aria-label": words.slider(letter),
      oninput: () => on.set(Number(this.slider.value)),
    });
    this.input = new NumberInput(words.axis(letter), rotary ? "angle" : "length", (value) => value !== undefined && on.set(value));
    const less = holdButton("−", words.stepDown(letter), () => on.step(-1));
    const more = holdButton("+", words.more(letter), () => on.step(1));
    this.element = element(
      "div",
      { class: "joint" },
      element("b", {}, letter),
      less,
      this.slider,
      more,
      this.input.element,
      element("div", { class: "ends" }, this.ends[0], this.near, this.ends[1]),
    );
  }

  show(value: number, units: Units): void {
    const { axis, slider } = this;
    const quantity = axis.rotary ? "angle" : "length";
    const [low, high] = axisRange(axis);
    this.setSlider(value, low, high);
    this.input.show({ value }, units);
    this.ends[0].textContent = Number.isFinite(low) ? numberText(low, quantity, units) : words.noEnd;
    this.ends[1].textContent = Number.isFinite(high) ? numberText(high, quantity, units) : words.noEnd;
    const left = Math.min(value - low, high - value);
    const distance = axis.rotary ? `${left.toFixed(2)}°` : lengthText(left, units);
    const isNear = left <= NEAR_LIMIT_SHARE * (high - low) && Number.isFinite(high - low);
    this.near.textContent = left <= 0 ? words.atEnd : isNear ? words.toEnd(distance) : "";
    this.element.classList.toggle("is-near", isNear || left <= 0);
    slider.setAttribute("aria-valuetext", axis.rotary ? `${value.toFixed(2)}°` : lengthText(value, units));
  }

  private setSlider(value: number, low: number, high: number): void {
    const { slider, axis } = this;
    const far = axis.rotary ? SLIDER_RANGE.deg : SLIDER_RANGE.mm;
    // For an axis without ends, the slider is centred again after the value has left its range.
    if (!(Math.abs(value - this.middle) < far)) this.middle = value;
    slider.min = String(Number.isFinite(low) ? low : this.middle - far);
    slider.max = String(Number.isFinite(high) ? high : this.middle + far);
    slider.value = String(value);
  }
}
