// Code pane: the program and its Lua, synchronised with the run.

import "./code.css";
import { Debounced } from "../core/debounced";
import { element } from "../core/dom";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import type { SourceLocation } from "../run/report";
import { texts } from "../texts";
import { AutoRun, CHECK_PAUSE_MS } from "./auto_run";
import { TextChecker } from "./text_checker";
import { needsDialectSetting } from "./dialect";
import { programmaticEdit } from "./editor";
import { LineFollower } from "./line_follower";
import { Header, type Tab } from "./header";
import { setHeat } from "./heat";
import { runHeat, hasMissingTimes } from "./run_heat";
import { EditedTranslations } from "./edited_translations";
import { synchroniseScrolling } from "./scroll_sync";
import { SourcePane } from "./source_pane";
import { Status } from "./status";
import { TranslationPane } from "./translation_pane";

const words = texts.code;

/** Longer programs are translated if the user opens the Lua, not during typing. */
const MAX_LIVE_TRANSLATION_LINES = 200_000;
const TRANSLATION_PAUSE_MS = 500;
/** Min width for G-code and Lua side by side. */
const MIN_SPLIT_WIDTH_PX = 560;

class CodePanel {
  private tab: Tab = "source";
  private readonly panes = {
    source: element("div", { class: "code-pane code-body" }),
    lua: element("div", { class: "code-pane" }),
  };
  private readonly header: Header;
  private readonly status: Status;
  private readonly source: SourcePane;
  private readonly translation: TranslationPane;
  private readonly following: LineFollower;
  private readonly textChecker: TextChecker;
  private readonly autoRun: AutoRun;
  private readonly own: EditedTranslations;
  private readonly translationTimer = new Debounced(() => void this.translation.refresh());
  private readonly align: () => void;
  private program = "";

  constructor(
    host: HTMLElement,
    private readonly store: Store,
    private readonly session: Session,
  ) {
    const run = () => this.run();
    const leave = () => this.header.focus();
    this.own = new EditedTranslations(session.documents);
    this.header = new Header({
      run,
      stop: () => session.cancel(),
      file: (name) => this.source.show(name),
      tab: (tab) => this.showTab(tab),
      autoRun: (isEnabled) => this.setAutoRun(isEnabled),
      toGcode: () => this.toGcode(),
    });
    this.status = new Status(
      () => this.source.editor.view,
      () => this.setDialect(this.source.dialect.name),
    );
    host.append(this.header.dom, element("div", { class: "code-panes" }, this.panes.source, this.panes.lua), this.status.dom);
    this.source = new SourcePane(this.panes.source, store, session, {
      onDisplayed: () => this.onDisplayed(),
      onEdit: () => this.onEdit(),
      onLineSelected: (line) => this.following.choose(line),
      moved: () => this.showLocation(),
      onDialectChange: () => this.showDialect(),
      run,
      onRunFrom: (line) => this.runFrom(line),
      leave,
    });
    this.translation = new TranslationPane(this.panes.lua, store, session, this.source, {
      onLineSelected: (line) => this.onLuaLineSelected(line),
      run,
      leave,
      edit: () => this.editLua(),
      onDisplayed: () => this.onTranslated(),
    });
    this.following = new LineFollower(store, this.source, this.translation, {
      isEnabled: () => this.tab === "both" && this.showsLua,
      align: () => this.align(),
    });
    this.autoRun = new AutoRun(store, session, () => this.source.flush());
    this.textChecker = new TextChecker(
      store,
      session,
      this.source,
      (problems) => this.status.showProblems(problems),
      (hasErrors) => this.autoRun.checked(hasErrors),
    );
    this.align = synchroniseScrolling(this.source.editor, this.translation.editor, () => this.tab === "both");
    this.listen(host);
    this.showTab("source");
    this.open(session.setup.program);
  }

  private listen(host: HTMLElement): void {
    const { store, session } = this;
    session.setActiveSettingsQuery((file, line) => this.source.activeSettingsAt(file, line));
    session.on(() => this.setupChanged());
    store.on("running", (running, before) => {
      if (running && !before) this.source.beginRun();
      this.updateHeader();
    });
    store.on("run", () => this.onRunChanged());
    store.on("requestedLocation", (place) => {
      if (place) this.showRequestedLocation(place);
    });
    store.watch(["robot"], () => this.updateHeat());
    new ResizeObserver(() => host.classList.toggle("code-wide", host.clientWidth >= MIN_SPLIT_WIDTH_PX)).observe(host);
    host.addEventListener("keydown", (event) => {
      // The text to be saved must be passed on first.
      if (event.key.toLowerCase() === "s" && (event.ctrlKey || event.metaKey)) this.source.flush();
      if (event.key !== "Enter" || !(event.ctrlKey || event.metaKey) || event.defaultPrevented) return;
      event.preventDefault();
      this.run();
    });
  }

  private open(program: string): void {
    this.program = program;
    this.source.show(program);
  }

  private showRequestedLocation({ file, line }: SourceLocation): void {
    this.store.set("requestedLocation", null);
    if (!this.source.has(file)) return;
    this.source.show(file);
    this.showTab("source");
    this.source.editor.select(line);
    this.source.editor.view.focus();
    requestAnimationFrame(() => this.source.editor.reveal(line));
  }

  private setupChanged(): void {
    const { program } = this.session.setup;
    // A new typed program gets its name here.
    const isNewProgram = program !== this.program && program !== this.source.name;
    if (isNewProgram) return this.open(program);
    this.program = program;
    this.source.refresh();
    this.textChanged();
  }

  /** Handles another text, or the same in another dialect. */
  private textChanged(): void {
    this.translation.clear();
    this.textChecker.onDisplayed();
    this.showTab(this.tab);
  }

  private onDisplayed(): void {
    this.textChanged();
    this.updateHeat();
    this.following.refresh();
    this.showLocation();
  }

  private onEdit(): void {
    this.autoRun.onEdit(this.source.isScript);
    this.textChecker.onEdit(this.autoRun.isActive ? CHECK_PAUSE_MS : undefined);
    this.translation.markStale();
    const isLong = this.source.editorFile.doc.lines > MAX_LIVE_TRANSLATION_LINES;
    if (this.showsLua && !isLong) this.translationTimer.after(TRANSLATION_PAUSE_MS);
    this.updateHeader();
  }

  private onRunChanged(): void {
    // A run that existed when the page was opened contains its sources.
    const { program } = this.session.setup;
    const ran = this.store.get("run")?.report?.program ?? "";
    if (!program && ran && this.source.has(ran) && this.source.name !== ran) this.source.show(ran);
    this.source.endRun(this.store.get("running") !== null);
    this.textChecker.onRunChanged();
    this.updateHeat();
    this.following.refresh();
    this.updateHeader();
  }

  private run(): void {
    this.source.flush();
    if (this.session.canRun && this.session.setup.program) void this.session.run();
  }

  private runFrom(line: number): void {
    if (!this.session.canRun) return;
    this.following.choose(line);
    this.store.set("form", "variants");
    this.store.set("isBlockPanelRequested", true);
  }

  private setDialect(dialect: string): void {
    this.session.history.edit(words.readingAs(this.source.dialect.title), { setup: { dialect } });
    this.run();
  }

  private setAutoRun(isEnabled: boolean): void {
    this.autoRun.isEnabled = isEnabled;
    if (isEnabled && this.source.editorFile.isChangedSinceRun) this.run();
  }

  private get hasTranslation(): boolean {
    return this.source.isProgram && !this.source.isScript;
  }

  private get showsLua(): boolean {
    return this.tab !== "source" && this.hasTranslation;
  }

  private showTab(tab: Tab): void {
    this.tab = tab;
    this.panes.source.hidden = tab === "lua" && this.hasTranslation;
    this.panes.lua.hidden = !this.showsLua;
    if (this.showsLua) void this.translation.refresh();
    this.updateHeader();
    requestAnimationFrame(() => {
      this.following.reveal();
      this.align();
    });
  }

  private onLuaLineSelected(line: number): void {
    this.source.editor.select(line);
    this.following.choose(line);
  }

  // The editor must measure its new text first.
  private onTranslated(): void {
    this.following.refresh();
    requestAnimationFrame(() => (this.tab === "lua" ? this.following.reveal() : this.align()));
  }

  private editLua(): void {
    const { name, script } = this.own.make(this.source.name, this.translation.script);
    this.session.history.edit(words.editLua, { documents: { [name]: script }, setup: { program: name } });
  }

  private toGcode(): void {
    const origin = this.own.sourceProgram(this.source.name);
    if (origin) this.session.history.edit(words.toGcode, { setup: { program: origin } });
  }

  private updateHeat(): void {
    const heat = runHeat(this.store, this.source);
    this.source.editor.view.dispatch({ effects: setHeat.of(heat), annotations: programmaticEdit.of(true) });
    this.status.showTimes(hasMissingTimes(this.store, this.source));
  }

  private showDialect(): void {
    const { isScript, dialect, name } = this.source;
    if (!this.source.isProgram) return this.status.showDialect(/\.toml$/i.test(name) ? "TOML" : "", false);
    const isOffered = !isScript && this.session.canRun && needsDialectSetting(this.session, name);
    this.status.showDialect(isScript ? "Lua" : dialect.title, isOffered);
  }

  private showLocation(): void {
    const { state } = this.source.editor.view;
    const { head } = state.selection.main;
    const line = state.doc.lineAt(head);
    this.status.showLocation(line.number, head - line.from + 1);
  }

  private files(): string[] {
    const { program, machine, cell, machine_data, robots: file } = this.session.setup;
    const robots = this.store.get("run")?.robots ?? [];
    const all = new Set([program, ...robots.flatMap(({ files }) => files), machine, cell, machine_data, file, this.source.name]);
    return [...all].filter((name) => name === this.source.name || (name !== "" && this.source.has(name)));
  }

  private updateHeader(): void {
    const { source, session } = this;
    const running = this.store.get("running");
    this.header.show({
      name: source.name,
      files: this.files(),
      isModified: source.editorFile.isModified,
      isChangedSinceRun: source.editorFile.isChangedSinceRun,
      readOnly: source.readOnly,
      canRun: session.canRun,
      running: running && (running.total > 0 ? running.done / running.total : NaN),
      tab: this.tab,
      hasTabs: this.hasTranslation && session.canRun,
      autoRun: this.autoRun.isEnabled,
      isAutoRunTooSlow: this.autoRun.isTooSlow,
      origin: this.own.sourceProgram(source.name) ?? "",
    });
  }
}

/** Fills the host with the editor of the program. */
export function createCode(host: HTMLElement, store: Store, session: Session): void {
  new CodePanel(host, store, session);
}
