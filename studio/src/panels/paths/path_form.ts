// Properties of a path, and of a place that uses one.

import { element } from "../../core/dom";
import type { JsonValue } from "../../core/json_text";
import { editPath } from "../../core/path_editing";
import type { DisplayedPath } from "../../core/displayed_path";
import type { Session } from "../../core/session";
import type { Store } from "../../core/store";
import { renamePath, setPath, setRoot, setTarget, type SetUpChange, type SubPathChange } from "../../run/path/path_edit";
import { findPathIndex, rootIndex, type TargetId, type SubPath } from "../../run/path/path_file";
import { setupValuesError, targetError } from "../../run/path/target_checks";
import { texts } from "../../texts";
import { ErrorLine } from "./error_line";
import { ChoiceRow, NumberRow, TextRow } from "./fields";
import { FrameFields } from "./frame_fields";
import { SetUpFields, acceptsSetup } from "./set_up_fields";

const words = texts.paths.form;
const { labels } = texts.paths;
const MAX_NAME_LENGTH = 256;

export class PathForm {
  readonly element: HTMLElement;
  private at: { displayed: DisplayedPath; path: number } | null = null;
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

  show(displayed: DisplayedPath, path: number): void {
    this.at = { displayed, path };
    this.name.show(displayed.file.paths[path].name);
    this.setUp.show(displayed.file, path, this.store.get("units"));
    this.root.hidden = rootIndex(displayed.file) === path;
  }

  private rename(name: string): void {
    if (!this.at) return;
    const { displayed, path } = this.at;
    const isFree = findPathIndex(displayed.file, name) < 0;
    const error =
      name === "" || new TextEncoder().encode(name).length > MAX_NAME_LENGTH ? words.badName : isFree ? "" : texts.paths.errors.twice(name);
    this.say(error);
    if (error) return this.show(displayed, path);
    editPath(this.store, this.session, labels.rename, renamePath(displayed.text, displayed.file, path, name));
  }

  private change(change: SetUpChange): void {
    if (!this.at) return;
    const { displayed, path } = this.at;
    const error = setupValuesError({ ...displayed.file.paths[path], ...change } as unknown as { [key: string]: JsonValue });
    this.say(error ? words.refused(error) : "");
    if (error) return this.show(displayed, path);
    editPath(this.store, this.session, labels.setUp, setPath(displayed.text, path, change));
  }

  private makeRoot(): void {
    if (!this.at) return;
    const { displayed, path } = this.at;
    editPath(this.store, this.session, labels.root, setRoot(displayed.text, displayed.file.paths[path].name));
  }
}

export class SubPathForm {
  readonly element: HTMLElement;
  private at: { displayed: DisplayedPath; place: TargetId; target: SubPath } | null = null;
  private readonly error = new ErrorLine();
  private readonly path = new ChoiceRow<string>(words.subPath, [], (path) => this.change({ path }));
  private readonly repeats = new NumberRow(words.repeats, "none", (repeats) => this.change({ repeats }));

  private readonly frame = new FrameFields((change) => this.change(change));

  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private readonly say: (sentence: string) => void,
  ) {
    this.element = element("div", { class: "form" }, this.error.element, this.path.element, this.repeats.element, this.frame.element);
  }

  show(displayed: DisplayedPath, place: TargetId, target: SubPath): void {
    this.at = { displayed, place, target };
    this.error.show(displayed, place);
    this.path.setOptions(displayed.file.paths.map(({ name }) => [name, name] as const), target.path);
    this.repeats.show({ value: target.repeats, inherited: 1 }, "mm");
    this.frame.element.hidden = !acceptsSetup(displayed.file, target);
    this.frame.show({ frame: target, inherited: texts.paths.frame.ofPath, units: this.store.get("units") });
  }

  private change(change: SubPathChange): void {
    if (!this.at) return;
    const { displayed, place, target } = this.at;
    const error = targetError({ ...target, ...change } as unknown as JsonValue);
    this.say(error ? words.refused(error) : "");
    if (error) return this.show(displayed, place, target);
    editPath(this.store, this.session, labels.change, setTarget(displayed.text, place, change));
  }
}
