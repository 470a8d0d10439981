// Definition of an arc: through a via point, or about a centre.

import { element } from "../../core/dom";
import type { Units } from "../../core/store";
import type { PointChange } from "../../run/path/path_edit";
import { pointMotion, type Point } from "../../run/path/path_file";
import { convertArc } from "../../run/path/path_motion";
import type { Vector } from "../../run/path/vector";
import { texts } from "../../texts";
import { ChoiceRow, NumberRow, NumbersRow } from "./fields";

const words = texts.paths.form;
const XYZ = ["X", "Y", "Z"];
type Kind = "via" | "center";

export class ArcFields {
  readonly element: HTMLElement;
  private point: Point | null = null;
  private from_mm: Vector | null = null;
  private readonly kind = new ChoiceRow<Kind>(
    words.arc,
    [
      ["via", words.byVia],
      ["center", words.byCenter],
    ],
    (kind) => this.say(kind),
  );
  private readonly via = this.vector(words.via, "via_mm", "length");
  private readonly center = this.vector(words.center, "center_mm", "length");
  private readonly normal = this.vector(words.normal, "normal", "none");
  private readonly turn = new NumberRow(words.turn, "angle", (turn_deg) => this.change({ turn_deg }));

  constructor(private readonly change: (change: PointChange) => void) {
    const rows = [this.kind, this.via, this.center, this.normal, this.turn];
    this.element = element("div", { class: "group" }, ...rows.map((row) => row.element));
  }

  private vector(label: string, key: "via_mm" | "center_mm" | "normal", quantity: "length" | "none"): NumbersRow {
    return new NumbersRow(label, XYZ, quantity, (values) => {
      const known = this.point?.[key] ?? [0, 0, 1];
      this.change({ [key]: known.map((before, i) => values[i] ?? before) as Vector });
    });
  }

  show(point: Point, from_mm: Vector | null, units: Units): void {
    this.point = point;
    this.from_mm = from_mm;
    this.element.hidden = pointMotion(point) !== "circular";
    const byVia = point.via_mm !== undefined;
    this.kind.show(byVia ? "via" : "center");
    this.via.element.hidden = !byVia;
    for (const { element: each } of [this.center, this.normal, this.turn]) each.hidden = byVia;
    this.via.show(point.via_mm ?? [], units);
    this.center.show(point.center_mm ?? [], units);
    this.normal.show(point.normal ?? [], units, [0, 0, 1]);
    this.turn.show({ value: point.turn_deg }, units);
  }

  private say(kind: Kind): void {
    if (!this.point) return;
    const said = convertArc(this.point, this.from_mm, kind);
    if (said) this.change(said);
    else this.kind.show(this.point.via_mm ? "via" : "center");
  }
}
