// Properties of a fixed or reference point: its number or name, and the actions there.

import { element } from "../../core/dom";
import type { JsonValue } from "../../core/json_text";
import { shortName } from "../../core/file_kinds";
import { editPath } from "../../core/path_editing";
import type { DisplayedPath } from "../../core/displayed_path";
import type { Session } from "../../core/session";
import type { Store } from "../../core/store";
import {
  parsePointId,
  machinePointId,
  machinePointKind,
  machinePointKinds,
  findPoint,
  noPoints,
  availablePoints,
  firstPointOfKind,
  type MachinePointKind,
  type AvailablePoint,
} from "../../run/path/machine_points";
import { setTarget, type MachinePointChange } from "../../run/path/path_edit";
import type { MachinePoint, TargetId } from "../../run/path/path_file";
import { targetError } from "../../run/path/target_checks";
import { texts } from "../../texts";
import { ActionList } from "./action_list";
import { ErrorLine } from "./error_line";
import { ChoiceRow, NumberRow, TextRow } from "./fields";
import type { SetupPoints } from "./known_points";

const words = texts.paths.form;
const own = texts.paths.machinePoint;

const textOf = ({ value, number, isHome }: AvailablePoint): string => {
  if (isHome) return own.home(number);
  return typeof value === "string" ? own.named(value, number) : String(number);
};

export class MachinePointForm {
  readonly element: HTMLElement;
  private at: { displayed: DisplayedPath; place: TargetId; target: MachinePoint } | null = null;
  private readonly error = new ErrorLine();
  private readonly name = new TextRow(words.name, (name) => this.change({ name: name || undefined }));
  private readonly kind = new ChoiceRow<MachinePointKind>(
    own.kind,
    machinePointKinds.map((kind) => [kind, own.kinds[kind]] as const),
    (kind) => this.change(firstPointOfKind(kind, this.known.points ?? noPoints)),
  );
  private readonly pointRow = new ChoiceRow<string>(own.which, [], (value) => this.choose(value));
  private readonly pointId = new TextRow(own.ident, (text) => this.setPointId(parsePointId(text.trim())));
  private readonly note = element("p", { class: "note", role: "status" });
  private readonly dwell = new NumberRow(words.numbers.dwell_s, "time", (dwell_s) => this.change({ dwell_s }));
  private readonly actions = new ActionList((actions) => this.change({ actions: actions.length > 0 ? actions : undefined }));

  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private readonly known: SetupPoints,
    private readonly say: (sentence: string) => void,
  ) {
    const { error, name, kind, pointRow, pointId, note, dwell, actions } = this;
    const rows = [name, kind, pointRow, pointId].map((row) => row.element);
    this.element = element("div", { class: "form" }, error.element, ...rows, note, dwell.element, actions.element);
  }

  show(displayed: DisplayedPath, place: TargetId, target: MachinePoint): void {
    this.at = { displayed, place, target };
    this.error.show(displayed, place);
    this.name.show(target.name ?? "");
    const [kind, pointId] = [machinePointKind(target), machinePointId(target)];
    this.kind.show(kind);
    const listedOptions = availablePoints(kind, this.known.points ?? noPoints);
    const match = findPoint(pointId, listedOptions, kind);
    const options = listedOptions.map((each) => [String(each.value), textOf(each)] as const);
    this.pointRow.setOptions([...options, ["", own.another] as const], match ? String(match.value) : "");
    this.pointId.show(String(pointId));
    this.note.textContent = match ? "" : this.missingPointNote(kind, pointId);
    this.note.hidden = this.note.textContent === "";
    this.dwell.show({ value: target.dwell_s }, "mm");
    this.actions.show(target.actions ?? []);
  }

  /** Returns why a point is missing that machine data should have. */
  private missingPointNote(kind: MachinePointKind, pointId: string | number): string {
    const { file, points } = this.known;
    if (file === "") return own.noData;
    return points ? own.noSuchPoint(shortName(file), own.kinds[kind], pointId) : own.unreadable(shortName(file));
  }

  /** Sets a point; one that is not in the list is typed in. */
  private choose(value: string): void {
    if (value === "") this.pointId.input.select();
    else this.setPointId(parsePointId(value));
  }

  private setPointId(pointId: string | number): void {
    if (this.at) this.change({ [machinePointKind(this.at.target)]: pointId });
  }

  private change(change: MachinePointChange): void {
    if (!this.at) return;
    const { displayed, place, target } = this.at;
    const error = targetError(removeUndefined({ ...target, ...change }));
    this.say(error ? words.refused(error) : "");
    if (error) return this.show(displayed, place, target);
    editPath(this.store, this.session, texts.paths.labels.changeMachinePoint, setTarget(displayed.text, place, change));
  }
}

/** Removes undefined keys: keys define the kind of a target, so a removed one must not be present. */
const removeUndefined = (target: MachinePointChange): JsonValue =>
  Object.fromEntries(Object.entries(target).filter(([, value]) => value !== undefined)) as JsonValue;
