// Points of the path by the machine: the current pose is recorded after the chosen point, and the machine
// moves to points.

import { element } from "../../core/dom";
import { baseName } from "../../core/file_kinds";
import type { Session } from "../../core/session";
import type { Store } from "../../core/store";
import { isPoint, targetKey, targetAt, type MotionType, type TargetId, type Point } from "../../run/path/path_file";
import { stateAfter, type State } from "../../run/path/path_traversal";
import { rounded } from "../../run/path/vector";
import type { Axis } from "../../run/scene";
import { texts } from "../../texts";
import { PathActions } from "../paths/actions";
import { TargetSelection } from "../paths/target_selection";
import { ChoiceRow, NumberRow } from "../paths/fields";
import { createFile } from "../paths/path_files";
import { currentPoint } from "../paths/point_of_run";

const words = texts.teach;
type Kind = "tool_axis" | "rotary_deg" | "inherited";
/** Default if neither the user nor the path sets a feed. */
const FEED_MM_MIN = 1000;

export interface RecordEvents {
  /** Moves the machine to a point, with the state there. */
  goTo(point: Point, state: State): void;
  say(sentence: string): void;
}

export class PointRecorder {
  readonly element: HTMLElement;
  private motion: MotionType = "linear";
  private requested: Kind = "tool_axis";
  private feed_mm_min: number | undefined;
  private readonly choice: TargetSelection;
  private readonly actions: PathActions;
  private readonly positionNote = element("p", { class: "note" });
  private readonly motions = new ChoiceRow<MotionType>(
    texts.paths.form.motion,
    [
      ["linear", texts.paths.form.motions.linear],
      ["rapid", texts.paths.form.motions.rapid],
    ],
    (motion) => {
      this.motion = motion;
      this.show();
    },
  );
  private readonly kinds = new ChoiceRow<Kind>(texts.paths.form.orientation, [], (kind) => (this.requested = kind));
  private readonly feed = new NumberRow(texts.paths.form.numbers.feed_mm_min, "feed", (value) => {
    this.feed_mm_min = value !== undefined && value > 0 ? value : undefined;
    this.show();
  });
  private readonly button = element("button", { type: "button", class: "primary", onclick: () => this.record() }, words.record);
  private readonly steps: Record<"previous" | "chosen" | "next", HTMLButtonElement>;

  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private readonly machine: { axes: Axis[]; values: number[] },
    private readonly on: RecordEvents,
  ) {
    this.choice = new TargetSelection(store);
    this.actions = new PathActions(store, session, this.choice, (sentence) => on.say(sentence));
    const step = (text: string, by: number) => element("button", { type: "button", onclick: () => this.goTo(by) }, text);
    this.steps = { previous: step(words.previous, -1), chosen: step(words.goTo, 0), next: step(words.next, 1) };
    this.element = element(
      "div",
      { class: "recording" },
      element("h3", { class: "heading" }, words.points),
      this.positionNote,
      this.motions.element,
      this.kinds.element,
      this.feed.element,
      element("div", { class: "buttons" }, this.button),
      element("div", { class: "buttons" }, ...Object.values(this.steps)),
    );
    store.watch(["path", "pathPoint", "units", "run"], () => this.show());
  }

  private get turns(): boolean {
    return this.machine.axes.some(({ rotary }) => rotary);
  }

  private get kind(): Kind {
    return this.turns ? this.requested : "inherited";
  }

  /** Returns the state at a point of the path; an empty state without a chosen one. */
  private stateAt(place: TargetId | null): State {
    const displayed = this.store.get("path");
    const target = displayed && place ? targetAt(displayed.file, place) : undefined;
    if (!displayed || !place || !target || !isPoint(target)) return {};
    return stateAfter(displayed.walk.before.get(targetKey(place)) ?? {}, target);
  }

  private show(): void {
    const { store } = this;
    const [displayed, place] = [store.get("path"), store.get("pathPoint")];
    const kinds: (readonly [Kind, string])[] = [["inherited", words.unchangedOrientation]];
    if (this.turns) kinds.unshift(["tool_axis", texts.paths.form.orientations.tool_axis], ["rotary_deg", texts.paths.form.orientations.rotary_deg]);
    this.kinds.setOptions(kinds, this.kind);
    this.motions.show(this.motion);
    this.feed.element.hidden = this.motion === "rapid";
    this.feed.show({ value: this.feed_mm_min, inherited: this.stateAt(place).feed_mm_min ?? FEED_MM_MIN }, store.get("units"));
    this.positionNote.textContent = this.positionText(place);
    this.button.disabled = this.machine.axes.length === 0 || Boolean(displayed?.error);
    for (const [name, by] of [["previous", -1], ["chosen", 0], ["next", 1]] as const) {
      this.steps[name].disabled = this.machine.axes.length === 0 || !this.neighbourPoint(by);
    }
  }

  private positionText(place: TargetId | null): string {
    const displayed = this.store.get("path");
    if (!displayed) return words.newFileNote;
    const path = place && displayed.file.paths[place.path];
    if (!path) return words.atEndOf(baseName(displayed.name));
    return words.behind(path.name, place.target + 1, baseName(displayed.name));
  }

  private neighbourPoint(by: number): { place: TargetId; point: Point } | null {
    const [displayed, place] = [this.store.get("path"), this.store.get("pathPoint")];
    if (!displayed || !place) return null;
    const requested = { path: place.path, target: place.target + by };
    const target = targetAt(displayed.file, requested);
    return target && isPoint(target) ? { place: requested, point: target } : null;
  }

  private goTo(by: number): void {
    const found = this.neighbourPoint(by);
    if (!found) return;
    this.store.set("pathPoint", found.place);
    this.on.goTo(found.point, this.stateAt(found.place));
  }

  /** Returns the orientation as it is to be recorded. */
  private orientation(tool_axis: Point["tool_axis"]): Pick<Point, "tool_axis" | "rotary_deg"> {
    if (this.kind === "tool_axis") return { tool_axis };
    if (this.kind === "inherited") return {};
    const { axes, values } = this.machine;
    return { rotary_deg: Object.fromEntries(axes.flatMap(({ letter, rotary }, i) => (rotary ? [[letter, rounded(values[i])]] : []))) };
  }

  private record(): void {
    const here = currentPoint(this.store);
    if (!here) return this.on.say(texts.run.notHere);
    const { position_mm, tool_axis } = here;
    const { motion } = this;
    const before = this.stateAt(this.store.get("pathPoint"));
    // A feed is written if it differs from the previous one.
    const feed_mm_min = motion === "rapid" ? undefined : (this.feed_mm_min ?? (before.feed_mm_min === undefined ? FEED_MM_MIN : undefined));
    const point = { motion, position_mm, ...this.orientation(tool_axis), feed_mm_min: feed_mm_min === before.feed_mm_min ? undefined : feed_mm_min };
    if (this.store.get("path")) this.actions.addPoint(point, words.labels.record);
    else createFile(this.store, this.session, point);
    this.on.say(words.recorded);
  }
}
