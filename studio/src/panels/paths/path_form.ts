// Properties of a path, and of a place that uses one.

import { element } from "../../core/dom";
import type { JsonValue } from "../../core/json_text";
import { editPath } from "../../core/path_desk";
import type { PathShown } from "../../core/path_shown";
import type { Session } from "../../core/session";
import type { Store } from "../../core/store";
import { renamePath, setPath, setRoot, setTarget, type SetUpChange, type SubPathChange } from "../../run/path/path_edit";
import { indexOfPath, rootOf, type Place, type SubPath } from "../../run/path/path_file";
import { faultOfSetUp, faultOfTarget } from "../../run/path/target_faults";
import { texts } from "../../texts";
import { FaultLine } from "./fault_line";
import { ChoiceRow, NumberRow, TextRow } from "./fields";
import { FrameFields } from "./frame_fields";
import { SetUpFields, takesSetUp } from "./set_up_fields";

const words = texts.paths.form;
const { labels } = texts.paths;
const LONGEST_NAME = 256;

export class PathForm {
  readonly element: HTMLElement;
  private at: { shown: PathShown; path: number } | null = null;
  private readonly name = new TextRow(words.pathName, (name) => this.rename(name));
  private readonly setUp = new SetUpFields((change) => this.change(change));
  private readonly root = element("button", { type: "button", onclick: () => this.makeRoot() }, words.makeRoot);

  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private readonly say: (sentence: string) => void,
  ) {
    this.element = element("div", { class: "form" }, this.name.element, this.setUp.element, this.root);
  }

  show(shown: PathShown, path: number): void {
    this.at = { shown, path };
    this.name.show(shown.file.paths[path].name);
    this.setUp.show(shown.file, path, this.store.get("units"));
    this.root.hidden = rootOf(shown.file) === path;
  }

  private rename(name: string): void {
    if (!this.at) return;
    const { shown, path } = this.at;
    const isFree = indexOfPath(shown.file, name) < 0;
    const fault = name === "" || new TextEncoder().encode(name).length > LONGEST_NAME ? words.badName : isFree ? "" : texts.paths.faults.twice(name);
    this.say(fault);
    if (fault) return this.show(shown, path);
    editPath(this.store, this.session, labels.rename, renamePath(shown.text, shown.file, path, name));
  }

  private change(change: SetUpChange): void {
    if (!this.at) return;
    const { shown, path } = this.at;
    const fault = faultOfSetUp({ ...shown.file.paths[path], ...change } as unknown as { [key: string]: JsonValue });
    this.say(fault ? words.refused(fault) : "");
    if (fault) return this.show(shown, path);
    editPath(this.store, this.session, labels.setUp, setPath(shown.text, path, change));
  }

  private makeRoot(): void {
    if (!this.at) return;
    const { shown, path } = this.at;
    editPath(this.store, this.session, labels.root, setRoot(shown.text, shown.file.paths[path].name));
  }
}

export class SubPathForm {
  readonly element: HTMLElement;
  private at: { shown: PathShown; place: Place; target: SubPath } | null = null;
  private readonly fault = new FaultLine();
  private readonly path = new ChoiceRow<string>(words.subPath, [], (path) => this.change({ path }));
  private readonly repeats = new NumberRow(words.repeats, "none", (repeats) => this.change({ repeats }));

  private readonly frame = new FrameFields((change) => this.change(change));

  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private readonly say: (sentence: string) => void,
  ) {
    this.element = element("div", { class: "form" }, this.fault.element, this.path.element, this.repeats.element, this.frame.element);
  }

  show(shown: PathShown, place: Place, target: SubPath): void {
    this.at = { shown, place, target };
    this.fault.show(shown, place);
    this.path.offer(shown.file.paths.map(({ name }) => [name, name] as const), target.path);
    this.repeats.show({ value: target.repeats, inherited: 1 }, "mm");
    this.frame.element.hidden = !takesSetUp(shown.file, target);
    this.frame.show({ frame: target, inherited: texts.paths.frame.ofPath, units: this.store.get("units") });
  }

  private change(change: SubPathChange): void {
    if (!this.at) return;
    const { shown, place, target } = this.at;
    const fault = faultOfTarget({ ...target, ...change } as unknown as JsonValue);
    this.say(fault ? words.refused(fault) : "");
    if (fault) return this.show(shown, place, target);
    editPath(this.store, this.session, labels.change, setTarget(shown.text, place, change));
  }
}
