// Properties of a fixed or reference point: its number or name, and the actions there.

import { element } from "../../core/dom";
import type { JsonValue } from "../../core/json_text";
import { shortName } from "../../core/kinds";
import { editPath } from "../../core/path_desk";
import type { PathShown } from "../../core/path_shown";
import type { Session } from "../../core/session";
import type { Store } from "../../core/store";
import {
  identFrom,
  identOf,
  kindOfMachinePoint,
  machinePointKinds,
  meantPoint,
  noPoints,
  offeredPoints,
  pointOfKind,
  type MachinePointKind,
  type OfferedPoint,
} from "../../run/path/machine_points";
import { setTarget, type MachinePointChange } from "../../run/path/path_edit";
import type { MachinePoint, Place } from "../../run/path/path_file";
import { faultOfTarget } from "../../run/path/target_faults";
import { texts } from "../../texts";
import { ActionList } from "./action_list";
import { FaultLine } from "./fault_line";
import { ChoiceRow, NumberRow, TextRow } from "./fields";
import type { KnownPointsOfSetup } from "./known_points";

const words = texts.paths.form;
const own = texts.paths.machinePoint;

const textOf = ({ value, number, isHome }: OfferedPoint): string => {
  if (isHome) return own.home(number);
  return typeof value === "string" ? own.named(value, number) : String(number);
};

export class MachinePointForm {
  readonly element: HTMLElement;
  private at: { shown: PathShown; place: Place; target: MachinePoint } | null = null;
  private readonly fault = new FaultLine();
  private readonly name = new TextRow(words.name, (name) => this.change({ name: name || undefined }));
  private readonly kind = new ChoiceRow<MachinePointKind>(
    own.kind,
    machinePointKinds.map((kind) => [kind, own.kinds[kind]] as const),
    (kind) => this.change(pointOfKind(kind, this.known.points ?? noPoints)),
  );
  private readonly which = new ChoiceRow<string>(own.which, [], (value) => this.choose(value));
  private readonly ident = new TextRow(own.ident, (text) => this.setIdent(identFrom(text.trim())));
  private readonly note = element("p", { class: "note", role: "status" });
  private readonly dwell = new NumberRow(words.numbers.dwell_s, "time", (dwell_s) => this.change({ dwell_s }));
  private readonly actions = new ActionList((actions) => this.change({ actions: actions.length > 0 ? actions : undefined }));

  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private readonly known: KnownPointsOfSetup,
    private readonly say: (sentence: string) => void,
  ) {
    const { fault, name, kind, which, ident, note, dwell, actions } = this;
    const rows = [name, kind, which, ident].map((row) => row.element);
    this.element = element("div", { class: "form" }, fault.element, ...rows, note, dwell.element, actions.element);
  }

  show(shown: PathShown, place: Place, target: MachinePoint): void {
    this.at = { shown, place, target };
    this.fault.show(shown, place);
    this.name.show(target.name ?? "");
    const [kind, ident] = [kindOfMachinePoint(target), identOf(target)];
    this.kind.show(kind);
    const offered = offeredPoints(kind, this.known.points ?? noPoints);
    const meant = meantPoint(ident, offered, kind);
    const options = offered.map((each) => [String(each.value), textOf(each)] as const);
    this.which.offer([...options, ["", own.another] as const], meant ? String(meant.value) : "");
    this.ident.show(String(ident));
    this.note.textContent = meant ? "" : this.noteOf(kind, ident);
    this.note.hidden = this.note.textContent === "";
    this.dwell.show({ value: target.dwell_s }, "mm");
    this.actions.show(target.actions ?? []);
  }

  /** Returns why a point is missing that machine data should have. */
  private noteOf(kind: MachinePointKind, ident: string | number): string {
    const { file, points } = this.known;
    if (file === "") return own.noData;
    return points ? own.notThere(shortName(file), own.kinds[kind], ident) : own.unreadable(shortName(file));
  }

  /** Sets a point; one that is not in the list is typed in. */
  private choose(value: string): void {
    if (value === "") this.ident.input.select();
    else this.setIdent(identFrom(value));
  }

  private setIdent(ident: string | number): void {
    if (this.at) this.change({ [kindOfMachinePoint(this.at.target)]: ident });
  }

  private change(change: MachinePointChange): void {
    if (!this.at) return;
    const { shown, place, target } = this.at;
    const fault = faultOfTarget(withoutGone({ ...target, ...change }));
    this.say(fault ? words.refused(fault) : "");
    if (fault) return this.show(shown, place, target);
    editPath(this.store, this.session, texts.paths.labels.changeMachinePoint, setTarget(shown.text, place, change));
  }
}

/** Removes undefined keys: keys define the kind of a target, so a removed one must not be present. */
const withoutGone = (target: MachinePointChange): JsonValue =>
  Object.fromEntries(Object.entries(target).filter(([, value]) => value !== undefined)) as JsonValue;
