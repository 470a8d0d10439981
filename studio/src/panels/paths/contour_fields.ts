// Contours of a part to cut, for parts that need not be flat, and the direction of the jet in them.

import { element } from "../../core/dom";
import type { Units } from "../../core/store";
import { texts } from "../../texts";
import { ChoiceRow, NumberRow, TextRow, type Quantity } from "./fields";

const words = texts.paths.contours;

/** Options as the engine takes them; it decides about undefined ones. */
export interface ContourChoice {
  kind: string;
  side?: string;
  faces?: string[];
  /** Only contours with one of these edges; undefined: all. */
  edges?: string[];
  axis?: string;
  tilt_angle_deg?: number;
  lead_angle_deg?: number;
  max_tilt_deg?: number;
  bridges?: number;
  bridge_mm?: number;
}

type NumberKey = keyof typeof words.numbers;

/** Numbers, and the defaults of the engine. */
const numbers: Record<NumberKey, [quantity: Quantity, without: number]> = {
  tilt_angle_deg: ["angle", 0],
  lead_angle_deg: ["angle", 0],
  max_tilt_deg: ["angle", 60],
  bridges: ["none", 0],
  bridge_mm: ["length", 0.5],
};

const VIEW_SIDES = ["z", "-z", "x", "-x", "y", "-y"];

export class ContourFields {
  readonly element: HTMLElement;
  private displayed: ContourChoice | undefined;
  private readonly kind = new ChoiceRow<string>(
    words.kind,
    [["", words.flat], ...Object.entries(words.kinds)],
    (kind) => this.change(kind === "" ? undefined : { ...this.displayed, kind }),
  );
  private readonly side = new ChoiceRow<string>(
    words.side,
    VIEW_SIDES.map((each) => [each, each] as const),
    (side) => this.set({ side }),
  );
  private readonly faces = new TextRow(words.faces, (text) => {
    const names = text.split(";").map((name) => name.trim());
    this.set({ faces: text.trim() ? names.filter((name) => name !== "") : undefined });
  });
  private readonly axis = new ChoiceRow<string>(words.axis, Object.entries(words.axes), (axis) => this.set({ axis, tilt_angle_deg: undefined }));
  private readonly rows = new Map<NumberKey, NumberRow>();
  private readonly more: HTMLElement;

  /** `change`: undefined if the part is flat. */
  constructor(private readonly change: (choice: ContourChoice | undefined) => void) {
    for (const key of Object.keys(numbers) as NumberKey[])
      this.rows.set(key, new NumberRow(words.numbers[key], numbers[key][0], (value) => this.set({ [key]: value })));
    const rows = [...this.rows.values()].map((row) => row.element);
    this.more = element("div", { class: "group" }, this.side.element, this.faces.element, this.axis.element, ...rows);
    this.element = element("div", { class: "group" }, this.kind.element, this.more);
  }

  private set(part: Partial<ContourChoice>): void {
    if (this.displayed) this.change({ ...this.displayed, ...part });
  }

  show(choice: ContourChoice | undefined, units: Units): void {
    this.displayed = choice;
    this.kind.show(choice?.kind ?? "");
    this.more.hidden = choice === undefined;
    this.side.show(choice?.side ?? "z");
    this.faces.show(choice?.faces?.join("; ") ?? "", words.allFaces);
    this.axis.show(choice?.axis ?? "wall");
    for (const [key, row] of this.rows) row.show({ value: choice?.[key], inherited: numbers[key][1] }, units);
    this.rows.get("tilt_angle_deg")!.element.hidden = choice?.axis !== "normal";
  }
}
