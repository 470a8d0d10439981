// TCP: its position in the work frame, the orientation of the tool, and buttons that move and turn it.

import { Quaternion, type Matrix4 } from "three";
import { element } from "../../core/dom";
import type { Units } from "../../core/store";
import { lengthNumber, lengthUnit } from "../../core/units";
import { toRpy } from "../../run/path/tool_direction";
import { texts } from "../../texts";
import { holdButton } from "./hold_button";

const words = texts.teach;
const XYZ = ["X", "Y", "Z"] as const;

/** Formats a number, without a sign before zero. */
const fixed = (value: number, digits: number): string => value.toFixed(digits).replace(/^-(0\.?0*)$/, "$1");

export interface TcpPadEvents {
  /** Moves along an axis of the work by a step. */
  move(axis: number, sense: 1 | -1): Promise<void>;
  /** Turns about an axis of the work, through the TCP. */
  turn(axis: number, sense: 1 | -1): Promise<void>;
}

export class TcpPad {
  readonly element: HTMLElement;
  private readonly tcpOutputs = XYZ.map(() => element("output", {}));
  private readonly axis = XYZ.map(() => element("output", {}));
  private readonly angles = XYZ.map(() => element("output", {}));
  private readonly unit = element("span", {});
  private readonly buttons: HTMLButtonElement[] = [];
  private readonly turning: HTMLButtonElement[] = [];

  constructor(on: TcpPadEvents) {
    const pair = (into: HTMLButtonElement[], name: string, act: (sense: 1 | -1) => Promise<void>) => {
      const made = [holdButton("−", `${name} −`, () => act(-1)), holdButton("+", `${name} +`, () => act(1))];
      into.push(...made);
      return element("td", {}, ...made);
    };
    const heads = ["", words.tip, "", words.toolAxis, words.turn].map((head) => element("th", { scope: "col" }, head));
    heads[1].append(" ", this.unit);
    const rows = XYZ.map((name, i) =>
      element(
        "tr",
        {},
        element("th", { scope: "row" }, name),
        element("td", {}, this.tcpOutputs[i]),
        pair(this.buttons, words.moveTcpAlong(name), (sense) => on.move(i, sense)),
        element("td", {}, this.axis[i]),
        pair(this.turning, words.turnAbout(name), (sense) => on.turn(i, sense)),
      ),
    );
    const angles = element("p", { class: "angles" }, `${words.angles} `, ...this.angles.flatMap((each) => [each, " "]));
    this.element = element("div", { class: "tip-pad" }, element("table", {}, element("thead", {}, element("tr", {}, ...heads)), element("tbody", {}, ...rows)), angles);
  }

  /** `isAble`: the engine can move the TCP; `turns`: the machine can turn the tool. */
  show(frame: Matrix4, units: Units, isAble: boolean, turns: boolean): void {
    const [, , , , , , , , zx, zy, zz, , x, y, z] = frame.elements;
    const rpy = toRpy(new Quaternion().setFromRotationMatrix(frame));
    this.unit.textContent = lengthUnit(units);
    XYZ.forEach((_, i) => {
      this.tcpOutputs[i].textContent = lengthNumber([x, y, z][i], units);
      this.axis[i].textContent = fixed([zx, zy, zz][i], 4);
      this.angles[i].textContent = `${fixed(rpy[i], 3)}°`;
    });
    for (const button of this.buttons) button.disabled = !isAble;
    for (const button of this.turning) button.disabled = !isAble || !turns;
  }
}
