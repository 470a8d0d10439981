// Properties of a geometric point. Values that a point takes over from those before it are shown in its
// fields in grey.

import { element } from "../../core/dom";
import { editPath } from "../../core/path_desk";
import type { PathShown } from "../../core/path_shown";
import type { Session } from "../../core/session";
import { robotOf } from "../../core/shown";
import type { Store } from "../../core/store";
import { movePoint, setTarget, type PointChange } from "../../run/path/path_edit";
import { isRecorded, motionOf, motionTypes, type MotionType, type Place, type Point } from "../../run/path/path_file";
import { upOf } from "../../run/path/leads";
import { motionChange } from "../../run/path/path_motion";
import type { State } from "../../run/path/path_walk";
import { faultOfTarget } from "../../run/path/target_faults";
import type { Vector } from "../../run/path/vector";
import type { JsonValue } from "../../core/json_text";
import { texts } from "../../texts";
import { ActionList } from "./action_list";
import { ArcFields } from "./arc_fields";
import { FaultLine } from "./fault_line";
import { ChoiceRow, NumberRow, NumbersRow, TextRow, type Quantity } from "./fields";
import { OrientationFields } from "./orientation_fields";

const words = texts.paths.form;

type NumberKey = "feed_mm_min" | "acceleration_mm_s2" | "dwell_s" | "feed_deg_min" | "duration_s" | "feed_mm_rev" | "lead_mm";
const numbers: { key: NumberKey; quantity: Quantity; rare?: true }[] = [
  { key: "feed_mm_min", quantity: "feed" },
  { key: "acceleration_mm_s2", quantity: "acceleration" },
  { key: "dwell_s", quantity: "time" },
  { key: "feed_deg_min", quantity: "turning", rare: true },
  { key: "duration_s", quantity: "time", rare: true },
  { key: "feed_mm_rev", quantity: "per_turn", rare: true },
  { key: "lead_mm", quantity: "per_turn", rare: true },
];

/** Point as used by forms: its data, its position, and the state before it. */
export interface PointShown {
  shown: PathShown;
  place: Place;
  point: Point;
  before: State;
}

export class PointForm {
  readonly element: HTMLElement;
  private at: PointShown | null = null;
  private readonly fault = new FaultLine();
  private readonly name = new TextRow(words.name, (name) => this.change({ name: name || undefined }));
  private readonly motion = new ChoiceRow<MotionType>(
    words.motion,
    motionTypes.map((type) => [type, words.motions[type]] as const),
    (motion) => this.setMotion(motion),
  );
  private readonly position = new NumbersRow(words.position, ["X", "Y", "Z"], "length", (values) => this.setPosition(values));
  private readonly arc = new ArcFields((change) => this.change(change));
  private readonly orientation: OrientationFields;
  private readonly numbers = numbers.map(
    ({ key, quantity }) => new NumberRow(words.numbers[key], quantity, (value) => this.change({ [key]: value })),
  );
  private readonly offset = new TextRow(words.workOffset, (name) => this.change({ work_offset: name || undefined }));
  private readonly actions = new ActionList((actions) => this.change({ actions: actions.length > 0 ? actions : undefined }));

  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private readonly say: (sentence: string) => void,
  ) {
    this.orientation = new OrientationFields(
      () => robotOf(store)?.chain ?? null,
      (change) => this.change(change),
    );
    const usual = this.numbers.filter((_, i) => !numbers[i].rare).map((row) => row.element);
    const rare = this.numbers.filter((_, i) => numbers[i].rare).map((row) => row.element);
    this.element = element(
      "div",
      { class: "form" },
      this.fault.element,
      this.name.element,
      this.motion.element,
      this.position.element,
      this.arc.element,
      this.orientation.element,
      ...usual,
      this.actions.element,
      element("details", {}, element("summary", {}, words.more), ...rare, this.offset.element),
    );
  }

  show(at: PointShown): void {
    this.at = at;
    const { shown, place, point, before } = at;
    const units = this.store.get("units");
    this.fault.show(shown, place);
    this.name.show(point.name ?? "");
    this.motion.show(motionOf(point));
    this.position.show(point.position_mm, units);
    this.arc.show(point, before.position_mm ?? null, units);
    this.orientation.show(point, before);
    numbers.forEach((each, i) => {
      const inherited = each.key in before ? before[each.key as keyof State] : undefined;
      this.numbers[i].show({ value: point[each.key], inherited: inherited as number | undefined }, units);
    });
    // Other paths set the work offset themselves.
    this.offset.element.hidden = !isRecorded(shown.file) && point.work_offset === undefined;
    this.offset.show(point.work_offset ?? "", before.work_offset ?? "");
    this.actions.show(point.actions ?? []);
  }

  /** Sets members of the point; a change that makes it invalid is refused with a message. */
  private change(change: PointChange): void {
    if (!this.at) return;
    const { shown, place, point } = this.at;
    const wanted = { ...point, ...change } as unknown as JsonValue;
    const fault = faultOfTarget(wanted);
    this.say(fault ? words.refused(fault) : "");
    if (fault) return this.show(this.at);
    editPath(this.store, this.session, texts.paths.labels.change, setTarget(shown.text, place, change));
  }

  private setMotion(motion: MotionType): void {
    if (!this.at) return;
    const { point, before } = this.at;
    this.change(motionChange(point, motion, before.position_mm ?? null, upOf({ ...before, ...point })));
  }

  private setPosition(values: (number | undefined)[]): void {
    if (!this.at) return;
    const { shown, place, point } = this.at;
    const position_mm = point.position_mm.map((before, i) => values[i] ?? before) as Vector;
    const fault = faultOfTarget({ ...point, position_mm } as unknown as JsonValue);
    this.say(fault ? words.refused(fault) : "");
    if (fault || values.includes(undefined)) return this.show(this.at);
    const text = movePoint(shown.text, shown.file, shown.walk, place, position_mm);
    editPath(this.store, this.session, texts.paths.labels.move, text);
  }
}
