// Code pane: the program and its Lua, synchronised with the run.

import "./code.css";
import { Debounced } from "../core/debounced";
import { element } from "../core/dom";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import type { Place } from "../run/report";
import { texts } from "../texts";
import { AutoRun, CHECK_PAUSE_MS } from "./auto_run";
import { Checking } from "./checking";
import { isMisread } from "./dialect";
import { byPage } from "./editor";
import { Following } from "./following";
import { Header, type Tab } from "./header";
import { setHeat } from "./heat";
import { heatOfRun, lacksTimes } from "./heat_of_run";
import { LuaOfOwn } from "./lua_of_own";
import { scrollTogether } from "./scroll_together";
import { SourcePane } from "./source_pane";
import { Status } from "./status";
import { TranslationPane } from "./translation_pane";

const words = texts.code;

/** Longer programs are translated if the user opens the Lua, not during typing. */
const LONG_LINES = 200_000;
const TRANSLATION_PAUSE_MS = 500;
/** Min width for G-code and Lua side by side. */
const WIDE_PX = 560;

class CodePart {
  private tab: Tab = "source";
  private readonly panes = {
    source: element("div", { class: "code-pane code-body" }),
    lua: element("div", { class: "code-pane" }),
  };
  private readonly header: Header;
  private readonly status: Status;
  private readonly source: SourcePane;
  private readonly translation: TranslationPane;
  private readonly following: Following;
  private readonly checking: Checking;
  private readonly autoRun: AutoRun;
  private readonly own: LuaOfOwn;
  private readonly translating = new Debounced(() => void this.translation.renew());
  private readonly align: () => void;
  private program = "";

  constructor(
    host: HTMLElement,
    private readonly store: Store,
    private readonly session: Session,
  ) {
    const run = () => this.run();
    const leave = () => this.header.focus();
    this.own = new LuaOfOwn(session.documents);
    this.header = new Header({
      run,
      stop: () => session.cancel(),
      file: (name) => this.source.show(name),
      tab: (tab) => this.showTab(tab),
      autoRun: (isOn) => this.setAutoRun(isOn),
      toGcode: () => this.toGcode(),
    });
    this.status = new Status(
      () => this.source.editor.view,
      () => this.readAs(this.source.dialect.name),
    );
    host.append(this.header.dom, element("div", { class: "code-panes" }, this.panes.source, this.panes.lua), this.status.dom);
    this.source = new SourcePane(this.panes.source, store, session, {
      shown: () => this.shown(),
      edited: () => this.edited(),
      chosen: (line) => this.following.choose(line),
      moved: () => this.showPlace(),
      renewed: () => this.showDialect(),
      run,
      fromHere: (line) => this.fromHere(line),
      leave,
    });
    this.translation = new TranslationPane(this.panes.lua, store, session, this.source, {
      chosen: (line) => this.chosenInLua(line),
      run,
      leave,
      edit: () => this.editLua(),
      shown: () => this.translated(),
    });
    this.following = new Following(store, this.source, this.translation, {
      isOn: () => this.tab === "both" && this.showsLua,
      align: () => this.align(),
    });
    this.autoRun = new AutoRun(store, session, () => this.source.flush());
    this.checking = new Checking(
      store,
      session,
      this.source,
      (problems) => this.status.showProblems(problems),
      (hasErrors) => this.autoRun.checked(hasErrors),
    );
    this.align = scrollTogether(this.source.editor, this.translation.editor, () => this.tab === "both");
    this.listen(host);
    this.showTab("source");
    this.open(session.setup.program);
  }

  private listen(host: HTMLElement): void {
    const { store, session } = this;
    session.tellInForceBy((file, line) => this.source.inForce(file, line));
    session.on(() => this.setupChanged());
    store.on("running", (running, before) => {
      if (running && !before) this.source.runBegins();
      this.renewHeader();
    });
    store.on("run", () => this.ranAnew());
    store.on("textAsked", (place) => {
      if (place) this.showPlaceAsked(place);
    });
    store.watch(["robot"], () => this.renewHeat());
    new ResizeObserver(() => host.classList.toggle("code-wide", host.clientWidth >= WIDE_PX)).observe(host);
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

  private showPlaceAsked({ file, line }: Place): void {
    this.store.set("textAsked", null);
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
    const isAnother = program !== this.program && program !== this.source.name;
    if (isAnother) return this.open(program);
    this.program = program;
    this.source.renew();
    this.textChanged();
  }

  /** Handles another text, or the same in another dialect. */
  private textChanged(): void {
    this.translation.clear();
    this.checking.shown();
    this.showTab(this.tab);
  }

  private shown(): void {
    this.textChanged();
    this.renewHeat();
    this.following.renew();
    this.showPlace();
  }

  private edited(): void {
    this.autoRun.edited(this.source.isScript);
    this.checking.edited(this.autoRun.isActive ? CHECK_PAUSE_MS : undefined);
    this.translation.outdate();
    const isLong = this.source.sheet.doc.lines > LONG_LINES;
    if (this.showsLua && !isLong) this.translating.after(TRANSLATION_PAUSE_MS);
    this.renewHeader();
  }

  private ranAnew(): void {
    // A run that existed when the page was opened contains its sources.
    const { program } = this.session.setup;
    const ran = this.store.get("run")?.report?.program ?? "";
    if (!program && ran && this.source.has(ran) && this.source.name !== ran) this.source.show(ran);
    this.source.runEnds(this.store.get("running") !== null);
    this.checking.ranAnew();
    this.renewHeat();
    this.following.renew();
    this.renewHeader();
  }

  private run(): void {
    this.source.flush();
    if (this.session.canRun && this.session.setup.program) void this.session.run();
  }

  private fromHere(line: number): void {
    if (!this.session.canRun) return;
    this.following.choose(line);
    this.store.set("form", "variants");
    this.store.set("hereAsked", true);
  }

  private readAs(dialect: string): void {
    this.session.history.edit(words.readingAs(this.source.dialect.title), { setup: { dialect } });
    this.run();
  }

  private setAutoRun(isOn: boolean): void {
    this.autoRun.isOn = isOn;
    if (isOn && this.source.sheet.changedSinceRun) this.run();
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
    if (this.showsLua) void this.translation.renew();
    this.renewHeader();
    requestAnimationFrame(() => {
      this.following.reveal();
      this.align();
    });
  }

  private chosenInLua(line: number): void {
    this.source.editor.select(line);
    this.following.choose(line);
  }

  // The editor must measure its new text first.
  private translated(): void {
    this.following.renew();
    requestAnimationFrame(() => (this.tab === "lua" ? this.following.reveal() : this.align()));
  }

  private editLua(): void {
    const { name, script } = this.own.make(this.source.name, this.translation.script);
    this.session.history.edit(words.editLua, { documents: { [name]: script }, setup: { program: name } });
  }

  private toGcode(): void {
    const origin = this.own.originOf(this.source.name);
    if (origin) this.session.history.edit(words.toGcode, { setup: { program: origin } });
  }

  private renewHeat(): void {
    const heat = heatOfRun(this.store, this.source);
    this.source.editor.view.dispatch({ effects: setHeat.of(heat), annotations: byPage.of(true) });
    this.status.showTimes(lacksTimes(this.store, this.source));
  }

  private showDialect(): void {
    const { isScript, dialect, name } = this.source;
    if (!this.source.isProgram) return this.status.showDialect(/\.toml$/i.test(name) ? "TOML" : "", false);
    const isOffered = !isScript && this.session.canRun && isMisread(this.session, name);
    this.status.showDialect(isScript ? "Lua" : dialect.title, isOffered);
  }

  private showPlace(): void {
    const { state } = this.source.editor.view;
    const { head } = state.selection.main;
    const line = state.doc.lineAt(head);
    this.status.showPlace(line.number, head - line.from + 1);
  }

  private files(): string[] {
    const { program, machine, cell, machine_data, robots: file } = this.session.setup;
    const robots = this.store.get("run")?.robots ?? [];
    const all = new Set([program, ...robots.flatMap(({ files }) => files), machine, cell, machine_data, file, this.source.name]);
    return [...all].filter((name) => name === this.source.name || (name !== "" && this.source.has(name)));
  }

  private renewHeader(): void {
    const { source, session } = this;
    const running = this.store.get("running");
    this.header.show({
      name: source.name,
      files: this.files(),
      isModified: source.sheet.isModified,
      changedSinceRun: source.sheet.changedSinceRun,
      readOnly: source.readOnly,
      canRun: session.canRun,
      running: running && (running.total > 0 ? running.done / running.total : NaN),
      tab: this.tab,
      hasTabs: this.hasTranslation && session.canRun,
      autoRun: this.autoRun.isOn,
      autoRunTooSlow: this.autoRun.isTooSlow,
      origin: this.own.originOf(source.name) ?? "",
    });
  }
}

/** Fills the host with the editor of the program. */
export function createCode(host: HTMLElement, store: Store, session: Session): void {
  new CodePart(host, store, session);
}
