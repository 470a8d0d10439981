// Manual path editor: a path file as a tree of paths, sub-paths and points, the properties of the selection,
// and the program that is written from it.

import "./paths.css";
import { choice, element } from "../../core/dom";
import { namesOfKind, shortName } from "../../core/file_kinds";
import { watchPath } from "../../core/path_editing";
import type { DisplayedPath } from "../../core/displayed_path";
import type { Session } from "../../core/session";
import type { Store } from "../../core/store";
import { isMachinePoint, isPoint, isSubPath, targetKey, targetAt } from "../../run/path/path_file";
import { texts } from "../../texts";
import type { PanelForm } from "../form";
import { PathActions } from "./actions";
import { TargetSelection } from "./target_selection";
import { DrawingDialog, drawingFiles, defaultDrawingChoice } from "./drawing_dialog";
import type { GeneratedPath } from "./engine_requests";
import { SetupPoints } from "./known_points";
import { LeadsForm } from "./leads_form";
import { MachinePointForm } from "./machine_point_form";
import { createFile, freeFileName, insertFile } from "./path_files";
import { PathForm, SubPathForm } from "./path_form";
import { PointForm } from "./point_form";
import { currentPoint } from "./point_of_run";
import { PathToolbar } from "./toolbar";
import { PathTree } from "./tree";
import { WriteForm } from "./write_form";

const words = texts.paths;

class PathsPanel {
  readonly element: HTMLElement;
  private readonly choice: TargetSelection;
  private readonly actions: PathActions;
  private readonly files = element("div", { class: "files" });
  private readonly said = element("div", { class: "said", role: "status" });
  private readonly error = element("p", { class: "fault", role: "alert" });
  private readonly toolbar: PathToolbar;
  private readonly tree: PathTree;
  private readonly known: SetupPoints;
  private readonly forms: { point: PointForm; machinePoint: MachinePointForm; subPath: SubPathForm; path: PathForm };
  private readonly heading = element("h3", { class: "heading" });
  private readonly leads: LeadsForm;
  private readonly write: WriteForm;
  private readonly body: HTMLElement;
  private drawingChoice = defaultDrawingChoice;

  constructor(
    private readonly store: Store,
    private readonly session: Session,
  ) {
    const say = (sentence: string) => this.say(sentence);
    this.choice = new TargetSelection(store);
    this.known = new SetupPoints(session, () => this.showProperties(store.get("path")));
    this.actions = new PathActions(store, session, this.choice, say);
    this.toolbar = new PathToolbar(this.actions, this.choice, this.known);
    this.tree = new PathTree(store, this.choice, this.actions);
    this.forms = {
      point: new PointForm(store, session, say),
      machinePoint: new MachinePointForm(store, session, this.known, say),
      subPath: new SubPathForm(store, session, say),
      path: new PathForm(store, session, say),
    };
    this.leads = new LeadsForm((requested) => this.actions.addLeads(requested));
    this.write = new WriteForm(store, session);
    const forms = Object.values(this.forms).map((form) => form.element);
    const parts = [this.toolbar.element, this.tree.element, this.heading, ...forms, this.leads.element, this.write.element];
    this.body = element("div", {}, ...parts);
    this.element = element("div", { class: "paths" }, this.files, this.said, this.error, this.body);
    this.listen();
  }

  private listen(): void {
    const { store, session } = this;
    this.choice.on(() => this.show());
    store.watch(["path", "units"], () => this.show());
    store.watch(["pathFile"], () => this.showFiles());
    session.documents.on((name) => {
      // A new name must be in the list; other changes in a file do not affect it.
      if (!this.files.querySelector(`option[value="${CSS.escape(name)}"]`)) this.showFiles();
    });
    store.on("drawing", (name) => {
      if (name) this.openDrawingDialog(name);
    });
  }

  onDisplayed(): void {
    this.store.set("showPath", true);
    void this.write.begin();
    this.known.onDisplayed();
    this.show();
  }

  onHidden(): void {
    this.store.set("showPath", false);
    this.known.onHidden();
  }

  /** `table` is text in columns, which may be wider than the side panel. */
  private say(sentence: string, table = ""): void {
    this.said.replaceChildren(sentence, ...(table ? [element("pre", {}, table)] : []));
    this.said.hidden = sentence === "";
  }

  private showFiles(): void {
    const { store, session } = this;
    const names = namesOfKind("path", session.documents);
    const options = [["", words.file.none] as const, ...names.map((name) => [name, shortName(name)] as const)];
    const name = store.get("pathFile");
    const select = choice(words.file.label, options, name, (to) => store.set("pathFile", to));
    const button = (text: string, title: string, act: () => void, disabled = false) =>
      element("button", { type: "button", title, disabled, onclick: act }, text);
    const focused = this.files.contains(document.activeElement) ? document.activeElement?.textContent : null;
    this.files.replaceChildren(
      select,
      button(words.file.new, words.file.newTitle, () => this.begin()),
      button(words.file.drawing, words.file.drawingTitle, () => this.openDrawingDialog(drawingFiles(session)[0] ?? "")),
      button(words.file.save, words.file.saveTitle, () => void session.save(name), name === ""),
    );
    const again = [...this.files.children].find((child) => child.textContent === focused);
    (again as HTMLElement | undefined)?.focus();
  }

  private show(): void {
    const displayed = this.store.get("path");
    this.say("");
    this.body.hidden = displayed === null;
    this.error.hidden = !displayed?.error;
    this.error.textContent = displayed?.error ?? "";
    this.toolbar.show(displayed);
    this.tree.show(displayed);
    this.showProperties(displayed);
    const units = this.store.get("units");
    this.leads.show(units);
    this.write.show(displayed, units);
  }

  private showProperties(displayed: DisplayedPath | null): void {
    const { range } = this.choice;
    const place = this.choice.point;
    const target = displayed && place ? targetAt(displayed.file, place) : undefined;
    const { point, machinePoint, subPath, path } = this.forms;
    point.element.hidden = !target || !isPoint(target);
    machinePoint.element.hidden = !target || !isMachinePoint(target);
    subPath.element.hidden = !target || !isSubPath(target);
    path.element.hidden = !displayed || place === null || place.target >= 0;
    this.heading.hidden = place === null;
    if (!displayed || !place) return;
    const { name } = displayed.file.paths[place.path];
    if (place.target < 0) {
      this.heading.textContent = words.form.ofPath(name);
      path.show(displayed, place.path);
    } else if (target) {
      this.heading.textContent = words.form.ofTarget(name, place.target + 1, range?.count ?? 1);
      if (isSubPath(target)) subPath.show(displayed, place, target);
      else if (isMachinePoint(target)) machinePoint.show(displayed, place, target);
      else point.show({ displayed, place, point: target, before: displayed.walk.before.get(targetKey(place)) ?? {} });
    }
  }

  /** Creates a new file that begins at the tool. */
  private begin(): void {
    const point = currentPoint(this.store);
    if (point) createFile(this.store, this.session, { motion: "rapid", ...point });
    else this.store.set("notice", texts.run.notHere);
  }

  private openDrawingDialog(name: string): void {
    new DrawingDialog(this.store, this.session, name, this.drawingChoice, {
      chosen: (chosen) => (this.drawingChoice = chosen),
      made: (path, drawing) => this.drawn(path, drawing),
    });
  }

  private drawn({ text, summary, warnings, job }: GeneratedPath, drawing: string): void {
    const stem = shortName(drawing).replace(/\.[^.]*$/, "");
    const { store, session } = this;
    insertFile(store, session, words.labels.drawing(shortName(drawing)), freeFileName(session.documents, stem), text);
    this.say([summary, ...warnings].filter((each) => each !== "").join("\n"), job);
  }
}

export function createPaths(store: Store, session: Session): PanelForm {
  watchPath(store, session);
  return new PathsPanel(store, session);
}
