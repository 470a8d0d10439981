// Variants: setups of the same work, run and compared with each other.

import "./variants.css";
import { element, setOptions, choice } from "../../core/dom";
import { Debounced } from "../../core/debounced";
import { goTo } from "../../core/navigation";
import { shortName } from "../../core/file_kinds";
import type { Session } from "../../core/session";
import { isSameSetup, type Setup } from "../../core/setup";
import type { Store } from "../../core/store";
import { countText } from "../../core/units";
import { runMarks } from "../../run/marks";
import { texts } from "../../texts";
import type { PanelForm } from "../form";
import { itemList, markItem } from "../results/mark_list";
import { Compare } from "./compare";
import { ListFile } from "./data/list_file";
import { Results, isCurrent } from "./data/results";
import { Runner } from "./data/runner";
import type { StartBlock, Variant } from "./data/variants_file";
import { Fields } from "./fields";
import { BlockPanel } from "./block_panel";
import { VariantList, type ListedVariant } from "./list";

const words = texts.variants;
const INITIAL_MARKS = 8;

/** Errors only, without other marks. */
const ERROR_KINDS: readonly string[] = ["alarm", "collision", "violation", "zone"];

const button = (text: string, title: string, act: () => void): HTMLButtonElement =>
  element("button", { type: "button", title, onclick: act }, text);

class VariantsPanel implements PanelForm {
  readonly element: HTMLElement;
  private readonly file: ListFile;
  private readonly results: Results;
  private readonly runner: Runner;
  private readonly files = choice(words.files, [], "", (name) => this.file.choose(name));
  private readonly saveButton = button(words.save, "", () => this.save());
  private readonly runAll = button(words.runAll, words.runAllHint, () => this.runStale());
  private readonly cancelButton = button(words.cancel, "", () => this.runner.cancel());
  private readonly progress = element("div", { class: "running", role: "status" });
  private readonly error = element("p", { class: "fault", role: "alert" });
  private readonly about = element("p", { class: "note" }, words.about);
  private readonly list = new VariantList({ choose: (row) => this.choose(row), remove: (row) => this.remove(row) });
  private readonly fields: Fields;
  private readonly detailRow: HTMLElement;
  private readonly detailArea = element("div", {});
  private readonly marks = element("div", { class: "places" });
  private readonly compare: Compare;
  private readonly blockPanel: BlockPanel;
  private readonly redrawTimer = new Debounced(() => this.draw());
  private listed: ListedVariant[] = [];
  private chosen = 0;
  private isVisible = false;

  constructor(
    private readonly store: Store,
    private readonly session: Session,
  ) {
    this.file = new ListFile(store, session);
    this.results = new Results(session);
    this.runner = new Runner(session, this.results, () => this.showRunning());
    this.fields = new Fields(session, {
      rename: (name) => this.rename(name),
      change: (what, setup) => this.change(what, (variant) => ({ ...variant, setup: { ...variant.setup, ...setup } })),
      fromStart: () => this.change(words.fromRow, (variant) => ({ ...variant, from: null })),
    });
    this.compare = new Compare(store, session);
    this.blockPanel = new BlockPanel(store, session, (from) => this.setStartBlock(from));
    const head = element("div", { class: "buttons" }, this.files, this.saveButton);
    const actionButtons = [button(words.add, words.addHint, () => this.add()), button(words.keep, words.keepHint, () => this.keep())];
    const add = element("div", { class: "buttons" }, ...actionButtons, this.runAll);
    const actionBar = element(
      "div",
      { class: "buttons" },
      button(words.run, "", () => this.runChosen()),
      button(words.applySetup, words.applySetupHint, () => this.applySetup()),
      button(words.copy, "", () => this.copy()),
      button(words.remove, "", () => this.remove(this.chosen)),
    );
    this.detailRow = element("div", { class: "chosen" }, actionBar, this.fields.element, this.marks);
    const parts = [head, add, this.progress, this.error, this.about, element("div", { class: "wide" }, this.list.element), this.detailArea];
    this.element = element("div", { class: "variants" }, ...parts, this.compare.element, this.blockPanel.element);
    this.listen();
    this.showRunning();
  }

  private listen(): void {
    const { store, session, redrawTimer } = this;
    const refresh = () => redrawTimer.after(0);
    session.documents.on(refresh);
    session.on(refresh);
    for (const key of ["variantsFile", "robot", "units"] as const) store.on(key, refresh);
    store.on("run", (run) => {
      // The page's own run counts for a variant with the same setup.
      const setup = run && session.origin(run)?.setup;
      if (setup && this.variants.some((variant) => isSameSetup(variant.setup, setup))) this.results.accept(run);
      refresh();
    });
    store.on("isBlockPanelRequested", (isAsked) => {
      if (!isAsked) return;
      store.set("isBlockPanelRequested", false);
      this.blockPanel.reveal();
    });
    for (const key of ["selection", "run"] as const) store.on(key, () => this.isVisible && this.blockPanel.show());
  }

  onDisplayed(): void {
    this.isVisible = true;
    this.draw();
  }

  onHidden(): void {
    this.isVisible = false;
  }

  private get variants(): readonly Variant[] {
    return this.file.read().variants ?? [];
  }

  private get variant(): Variant | undefined {
    return this.listed[this.chosen]?.variant;
  }

  /** Redraws only visible parts, and the data that the view shows. */
  private draw(): void {
    if (!this.isVisible && this.store.get("comparisonRun") === null) return;
    const read = this.file.read();
    this.error.textContent = read.variants ? "" : words.unreadable(shortName(this.file.name), read.error);
    this.listed = (read.variants ?? []).map((variant) => ({ variant, standing: this.results.standing(variant.setup) }));
    this.chosen = Math.max(0, Math.min(this.chosen, this.listed.length - 1));
    this.about.hidden = this.listed.length > 0 || read.variants === null;
    this.showFiles();
    this.list.show(this.listed, this.chosen, this.store.get("robot"));
    this.showChosen();
    this.compare.show(this.listed);
    this.blockPanel.show();
  }

  private showFiles(): void {
    const { file } = this;
    const isNew = file.isNew;
    const names = file.names.map((name): [string, string] => [name, shortName(name)]);
    setOptions(
      this.files,
      [...(isNew || names.length === 0 ? [["", words.newFile(file.newName)] as const] : []), ...names],
      isNew ? "" : file.name,
    );
    this.saveButton.setAttribute("aria-disabled", String(isNew));
    this.saveButton.title = isNew ? words.nothingToSave : words.saveHint(shortName(file.name));
    this.runAll.disabled = this.stale.length === 0;
    this.runAll.title = this.listed.length > 0 && this.stale.length === 0 ? words.allAreCurrent : words.runAllHint;
  }

  private showChosen(): void {
    const { variant } = this;
    if (!variant) return this.detailRow.remove();
    if (!this.detailRow.isConnected) this.detailArea.append(this.detailRow);
    this.fields.show(variant);
    this.showMarks();
  }

  private showMarks(): void {
    const { standing } = this.listed[this.chosen];
    const robot = this.store.get("robot");
    const run = isCurrent(standing) ? standing.run : null;
    const marks = run ? runMarks(run, robot).filter(({ kind }) => ERROR_KINDS.includes(kind)) : [];
    const items = marks.map((mark) => ({
      ...markItem(mark, this.store),
      choose: () => {
        this.applySetup();
        goTo(this.store, mark, mark.t_s);
      },
    }));
    this.marks.replaceChildren(...(items.length > 0 ? [itemList(words.marks, items, INITIAL_MARKS)] : []));
  }

  private showRunning(): void {
    const { runProgress } = this.runner;
    const wasHidden = this.progress.hidden;
    this.progress.hidden = runProgress === null;
    if (wasHidden !== this.progress.hidden || this.progress.dataset.name !== runProgress?.name) this.redrawTimer.after(0);
    if (!runProgress) return;
    const { name, done, total } = runProgress;
    this.progress.dataset.name = name;
    const blocks = done > 0 ? `, ${words.runningBlocks(countText(done), total > 0 ? countText(total) : "")}` : "";
    const text = `${words.running(name)}${blocks} `;
    if (this.progress.contains(this.cancelButton)) this.progress.firstChild!.textContent = text;
    else this.progress.replaceChildren(text, this.cancelButton);
  }

  private choose(row: number): void {
    this.chosen = row;
    this.list.show(this.listed, row, this.store.get("robot"));
    this.showChosen();
  }

  /** Adds a variant at the end and selects it. */
  private append(label: (name: string) => string, variant: Variant): void {
    const { error } = this.file.read();
    if (error) return this.store.set("notice", words.unreadable(shortName(this.file.name), error));
    const renamedVariant = { ...variant, name: this.file.free(variant.name) };
    this.file.change(label(renamedVariant.name), (variants) => [...variants, renamedVariant]);
    this.chosen = this.variants.length - 1;
    this.draw();
  }

  private add(): void {
    this.append(words.steps.added, { name: words.names.variant, setup: { ...this.session.setup }, from: null });
  }

  private keep(): void {
    const run = this.store.get("run");
    const origin = run && this.session.origin(run);
    if (!origin) return this.store.set("notice", words.noRuns);
    this.results.accept(run);
    this.append(words.steps.kept, { name: words.names.kept, setup: { ...origin.setup }, from: null });
  }

  private copy(): void {
    if (this.variant) this.append(words.steps.added, { ...this.variant, name: words.names.copy(this.variant.name) });
  }

  private setStartBlock(from: StartBlock): void {
    const run = this.store.get("run")!;
    const setup: Readonly<Setup> = this.session.origin(run)?.setup ?? this.session.setup;
    // Lines of an earlier text may have moved.
    const changed = this.session.changedSince(run);
    if (changed.length > 0) return this.store.set("notice", words.here.changed(changed.map(shortName)));
    this.results.accept(run);
    this.append(words.steps.added, { name: words.here.name(from.line), setup: { ...setup }, from });
  }

  private remove(row: number): void {
    const { variant } = this.listed[row] ?? {};
    if (!variant) return;
    this.file.change(words.steps.removed(variant.name), (variants) => variants.filter(({ name }) => name !== variant.name));
  }

  private rename(name: string): boolean {
    const { variant } = this;
    if (!variant || name === variant.name) return true;
    const isTaken = this.variants.some((each) => each.name === name);
    if (isTaken || !name) {
      this.store.set("notice", isTaken ? words.nameTaken(name) : words.nameEmpty);
      return false;
    }
    this.change(words.of.name, (each) => ({ ...each, name }));
    return true;
  }

  private change(what: string, change: (variant: Variant) => Variant): void {
    const { variant } = this;
    if (!variant) return;
    this.file.change(words.steps.changed(variant.name, what), (variants) =>
      variants.map((each) => (each.name === variant.name ? change(each) : each)),
    );
    this.draw();
  }

  private save(): void {
    if (!this.file.isNew) void this.session.save(this.file.name);
  }

  /** Returns the variants with results that are not current. */
  private get stale(): Variant[] {
    return this.listed.filter(({ standing }) => !isCurrent(standing) && standing.is !== "failed").map(({ variant }) => variant);
  }

  private runStale(): void {
    void this.runner.run(this.stale);
  }

  private runChosen(): void {
    if (this.variant) void this.runner.run([this.variant]);
  }

  private applySetup(): void {
    const { variant, standing } = this.listed[this.chosen] ?? {};
    if (!variant || !standing) return;
    const label = words.steps.applySetup(variant.name);
    if (isCurrent(standing)) this.session.showRun(standing.run, label);
    else this.session.history.edit(label, { setup: variant.setup });
  }
}

export const createVariants = (store: Store, session: Session): PanelForm => new VariantsPanel(store, session);
