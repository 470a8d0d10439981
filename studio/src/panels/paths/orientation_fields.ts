// Orientation of the tool at a point: as before, or by a direction, by angles, by the machine's rotary axes.

import { element } from "../../core/dom";
import type { Chain } from "../../run/chain";
import type { PointChange } from "../../run/path/path_edit";
import type { Point } from "../../run/path/path_file";
import type { State } from "../../run/path/path_traversal";
import { solveRotaryAxes } from "../../run/path/rotary_solver";
import { orientationKind, orientationKinds, toRpy, toolDirection, type OrientationKind } from "../../run/path/tool_direction";
import { rounded, roundedVector, type Vector } from "../../run/path/vector";
import { Quaternion, Vector3 } from "three";
import { texts } from "../../texts";
import { ChoiceRow, NumbersRow } from "./fields";

const words = texts.paths.form;
type Kind = OrientationKind | "inherited";

const noOrientation: PointChange = { tool_axis: undefined, rpy_deg: undefined, rotary_deg: undefined };

export class OrientationFields {
  readonly element: HTMLElement;
  private point: Point | null = null;
  private before: State = {};
  private readonly kind = new ChoiceRow<Kind>(words.orientation, [], (kind) => this.say(kind));
  private readonly axis = this.vector(words.toolAxis, "tool_axis", ["X", "Y", "Z"]);
  private readonly angles = this.vector(words.angles, "rpy_deg", words.rpy);
  private readonly host = element("div", {});
  private rotary: { letters: string; row: NumbersRow } | null = null;

  constructor(
    private readonly chain: () => Chain | null,
    private readonly change: (change: PointChange) => void,
  ) {
    this.element = element("div", { class: "group" }, this.kind.element, this.axis.element, this.angles.element, this.host);
  }

  private vector(label: string, key: "tool_axis" | "rpy_deg", names: readonly string[]): NumbersRow {
    return new NumbersRow(label, names, key === "rpy_deg" ? "angle" : "none", (values) => {
      const known = this.point?.[key] ?? this.before[key] ?? [0, 0, 0];
      this.change({ ...noOrientation, [key]: known.map((before, i) => values[i] ?? before) as Vector });
    });
  }

  /** Returns the letters of the axes that the point or those before it set, else those of the machine. */
  private letters(): string[] {
    const given = this.point?.rotary_deg ?? this.before.rotary_deg;
    if (given) return Object.keys(given);
    return this.chain()?.scene.axes.flatMap(({ letter, rotary }) => (rotary ? [letter] : [])) ?? [];
  }

  show(point: Point, before: State): void {
    this.point = point;
    this.before = before;
    const own = orientationKind(point);
    const inherited = orientationKind(before);
    const listedOptions = orientationKinds.filter((kind) => kind !== "rotary_deg" || this.letters().length > 0);
    const unchangedOrientation = inherited ? words.unchangedOrientation(words.orientations[inherited]) : words.noOrientation;
    const options = [
      ["inherited", unchangedOrientation] as const,
      ...listedOptions.map((kind) => [kind, words.orientations[kind]] as const),
    ];
    this.kind.setOptions(options, own ?? "inherited");
    const kind = own ?? inherited;
    this.axis.element.hidden = kind !== "tool_axis";
    this.angles.element.hidden = kind !== "rpy_deg";
    this.host.hidden = kind !== "rotary_deg";
    this.axis.show(point.tool_axis ?? [], "mm", before.tool_axis);
    this.angles.show(point.rpy_deg ?? [], "mm", before.rpy_deg);
    this.showRotary(point, before);
  }

  private showRotary(point: Point, before: State): void {
    const letters = this.letters();
    const key = letters.join();
    if (this.rotary?.letters !== key) {
      const row = new NumbersRow(words.rotary, letters, "angle", (values) => this.setRotary(letters, values));
      this.rotary = { letters: key, row };
      this.host.replaceChildren(row.element);
    }
    const axisValues = (values: Record<string, number> | undefined) => letters.map((letter) => values?.[letter]);
    this.rotary.row.show(axisValues(point.rotary_deg), "mm", axisValues(before.rotary_deg));
  }

  private setRotary(letters: string[], values: (number | undefined)[]): void {
    const known = this.point?.rotary_deg ?? this.before.rotary_deg ?? {};
    const all = letters.map((letter, i) => [letter, values[i] ?? known[letter] ?? 0] as const);
    this.change({ ...noOrientation, rotary_deg: Object.fromEntries(all) });
  }

  /** Expresses the current orientation in another form. */
  private say(kind: Kind): void {
    const { point, before } = this;
    if (!point) return;
    if (kind === "inherited") return this.change(noOrientation);
    const chain = this.chain();
    const now = orientationKind(point) ? point : before;
    const direction = toolDirection(now, chain) ?? new Vector3(0, 0, 1);
    this.change({ ...noOrientation, [kind]: now[kind] ?? this.said(kind, direction, chain) });
  }

  private said(kind: OrientationKind, direction: Vector3, chain: Chain | null): Vector | Record<string, number> {
    if (kind === "tool_axis") return roundedVector(direction.toArray() as Vector);
    if (kind === "rpy_deg") return roundedVector(toRpy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), direction)));
    const home = Object.fromEntries(
      chain?.scene.axes.flatMap(({ letter, rotary, home: value }) => (rotary ? [[letter, value] as const] : [])) ?? [],
    );
    const found = (chain && solveRotaryAxes(direction, home, chain)) ?? home;
    return Object.fromEntries(Object.entries(found).map(([letter, value]) => [letter, rounded(value)]));
  }
}
