// Properties of a geometric point. Values that a point takes over from those before it are shown in its
// fields in grey.

import { element } from "../../core/dom";
import { editPath } from "../../core/path_editing";
import type { DisplayedPath } from "../../core/displayed_path";
import type { Session } from "../../core/session";
import { shownRobot } from "../../core/display_state";
import type { Store } from "../../core/store";
import { movePoint, setTarget, type PointChange } from "../../run/path/path_edit";
import { isRecorded, pointMotion, motionTypes, type MotionType, type TargetId, type Point } from "../../run/path/path_file";
import { upDirection } from "../../run/path/leads";
import { motionChange } from "../../run/path/path_motion";
import type { State } from "../../run/path/path_traversal";
import { targetError } from "../../run/path/target_checks";
import type { Vector } from "../../run/path/vector";
import type { JsonValue } from "../../core/json_text";
import { texts } from "../../texts";
import { ActionList } from "./action_list";
import { ArcFields } from "./arc_fields";
import { ErrorLine } from "./error_line";
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
export interface PointState {
  displayed: DisplayedPath;
  place: TargetId;
  point: Point;
  before: State;
}

export class PointForm {
  readonly element: HTMLElement;
  private at: PointState | null = null;
  private readonly error = new ErrorLine();
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
      () => shownRobot(store)?.chain ?? null,
      (change) => this.change(change),
    );
    const commonRows = this.numbers.filter((_, i) => !numbers[i].rare).map((row) => row.element);
    const rare = this.numbers.filter((_, i) => numbers[i].rare).map((row) => row.element);
    this.element = element(
      "div",
      { class: "form" },
      this.error.element,
      this.name.element,
      this.motion.element,
      this.position.element,
      this.arc.element,
      this.orientation.element,
      ...commonRows,
      this.actions.element,
      element("details", {}, element("summary", {}, words.more), ...rare, this.offset.element),
    );
  }

  show(at: PointState): void {
    this.at = at;
    const { displayed, place, point, before } = at;
    const units = this.store.get("units");
    this.error.show(displayed, place);
    this.name.show(point.name ?? "");
    this.motion.show(pointMotion(point));
    this.position.show(point.position_mm, units);
    this.arc.show(point, before.position_mm ?? null, units);
    this.orientation.show(point, before);
    numbers.forEach((each, i) => {
      const inherited = each.key in before ? before[each.key as keyof State] : undefined;
      this.numbers[i].show({ value: point[each.key], inherited: inherited as number | undefined }, units);
    });
    // Other paths set the work offset themselves.
    this.offset.element.hidden = !isRecorded(displayed.file) && point.work_offset === undefined;
    this.offset.show(point.work_offset ?? "", before.work_offset ?? "");
    this.actions.show(point.actions ?? []);
  }

  /** Sets members of the point; a change that makes it invalid is refused with a message. */
  private change(change: PointChange): void {
    if (!this.at) return;
    const { displayed, place, point } = this.at;
    const requested = { ...point, ...change } as unknown as JsonValue;
    const error = targetError(requested);
    this.say(error ? words.refused(error) : "");
    if (error) return this.show(this.at);
    editPath(this.store, this.session, texts.paths.labels.change, setTarget(displayed.text, place, change));
  }

  private setMotion(motion: MotionType): void {
    if (!this.at) return;
    const { point, before } = this.at;
    this.change(motionChange(point, motion, before.position_mm ?? null, upDirection({ ...before, ...point })));
  }

  private setPosition(values: (number | undefined)[]): void {
    if (!this.at) return;
    const { displayed, place, point } = this.at;
    const position_mm = point.position_mm.map((before, i) => values[i] ?? before) as Vector;
    const error = targetError({ ...point, position_mm } as unknown as JsonValue);
    this.say(error ? words.refused(error) : "");
    if (error || values.includes(undefined)) return this.show(this.at);
    const text = movePoint(displayed.text, displayed.file, displayed.walk, place, position_mm);
    editPath(this.store, this.session, texts.paths.labels.move, text);
  }
}
