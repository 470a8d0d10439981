// The properties of a path, and of a place where one is used.

import { element } from "../../core/dom";
import type { JsonValue } from "../../core/json_text";
import { editPath, type PathShown } from "../../core/path_desk";
import type { Session } from "../../core/session";
import type { Store } from "../../core/store";
import { renamePath, setRoot, setTarget } from "../../run/path/path_edit";
import { indexOfPath, keyOfPlace, rootOf, type Place, type SubPath } from "../../run/path/path_file";
import { faultOfTarget } from "../../run/path/target_faults";
import { texts } from "../../texts";
import { ChoiceRow, NumberRow, TextRow } from "./fields";

const words = texts.paths.form;
const { labels } = texts.paths;
const LONGEST_NAME = 256;

export class PathForm {
  readonly element: HTMLElement;
  private at: { shown: PathShown; path: number } | null = null;
  private readonly name = new TextRow(words.pathName, (name) => this.rename(name));
  private readonly root = element("button", { type: "button", onclick: () => this.makeRoot() }, words.makeRoot);

  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private readonly say: (sentence: string) => void,
  ) {
    this.element = element("div", { class: "form" }, this.name.element, this.root);
  }

  show(shown: PathShown, path: number): void {
    this.at = { shown, path };
    this.name.show(shown.file.paths[path].name);
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

  private makeRoot(): void {
    if (!this.at) return;
    const { shown, path } = this.at;
    editPath(this.store, this.session, labels.root, setRoot(shown.text, shown.file.paths[path].name));
  }
}

export class SubPathForm {
  readonly element: HTMLElement;
  private at: { shown: PathShown; place: Place; target: SubPath } | null = null;
  private readonly fault = element("p", { class: "fault", role: "alert" });
  private readonly path = new ChoiceRow<string>(words.subPath, [], (path) => this.change({ path }));
  private readonly repeats = new NumberRow(words.repeats, "none", (repeats) => this.change({ repeats }));

  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private readonly say: (sentence: string) => void,
  ) {
    this.element = element("div", { class: "form" }, this.fault, this.path.element, this.repeats.element);
  }

  show(shown: PathShown, place: Place, target: SubPath): void {
    this.at = { shown, place, target };
    this.fault.textContent = shown.walk.faults.find((fault) => fault.place && keyOfPlace(fault.place) === keyOfPlace(place))?.text ?? "";
    this.fault.hidden = this.fault.textContent === "";
    this.path.offer(shown.file.paths.map(({ name }) => [name, name] as const), target.path);
    this.repeats.show({ value: target.repeats, inherited: 1 }, "mm");
  }

  private change(change: Partial<SubPath>): void {
    if (!this.at) return;
    const { shown, place, target } = this.at;
    const fault = faultOfTarget({ ...target, ...change } as unknown as JsonValue);
    this.say(fault ? words.refused(fault) : "");
    if (fault) return this.show(shown, place, target);
    editPath(this.store, this.session, labels.change, setTarget(shown.text, place, change));
  }
}
