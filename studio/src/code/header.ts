// Header above the editor: the file, its change mark, the shown part, and Run.

import { check, element } from "../core/dom";
import { baseName } from "../core/file_kinds";
import { texts } from "../texts";

export type Tab = "source" | "lua" | "both";

export interface HeaderState {
  name: string;
  /** Files that can be shown; the program first. */
  files: string[];
  isModified: boolean;
  isChangedSinceRun: boolean;
  readOnly: boolean;
  canRun: boolean;
  /** Completed share of the current run; null: no run in progress; NaN: unknown. */
  running: number | null;
  tab: Tab;
  hasTabs: boolean;
  autoRun: boolean;
  isAutoRunTooSlow: boolean;
  /** G-code from which the shown Lua was made; "": none. */
  origin: string;
}

export interface HeaderEvents {
  run(): void;
  stop(): void;
  file(name: string): void;
  tab(tab: Tab): void;
  autoRun(isEnabled: boolean): void;
  toGcode(): void;
}

const words = texts.code;

const button = (text: string, title: string, action: () => void): HTMLButtonElement =>
  element("button", { type: "button", title, onclick: action }, text);

export class Header {
  readonly dom: HTMLElement;
  private readonly files = element("select", { class: "code-files", "aria-label": words.file, title: words.file });
  private readonly mark = element("span", { class: "code-mark" });
  private readonly runButton: HTMLButtonElement;
  private readonly tabs: [Tab, HTMLButtonElement][];
  private readonly tabRow: HTMLElement;
  private readonly auto: ReturnType<typeof check>;
  private readonly origin = element("span", { class: "code-grow" });
  private readonly originRow: HTMLElement;
  private isRunning = false;
  private listed = "";

  constructor(events: HeaderEvents) {
    this.runButton = button(words.run, words.runTitle, () => (this.isRunning ? events.stop() : events.run()));
    this.runButton.classList.add("code-run");
    this.tabs = (["source", "lua", "both"] as const).map((tab) => [
      tab,
      button(words.tabs[tab], words.tabTitles[tab], () => events.tab(tab)),
    ]);
    const tabButtons = this.tabs.map(([, one]) => one);
    this.tabRow = element("div", { class: "code-tabs", role: "group", "aria-label": words.tabsLabel }, ...tabButtons);
    this.auto = check(words.autoRun, (isEnabled) => events.autoRun(isEnabled), { class: "code-auto" });
    const back = button(words.toGcode, words.toGcodeTitle, () => events.toGcode());
    this.originRow = element("div", { class: "code-strip" }, this.origin, back);
    this.files.addEventListener("change", () => events.file(this.files.value));
    this.dom = element(
      "header",
      { class: "code-header" },
      element("div", { class: "code-row" }, this.files, this.mark, this.runButton),
      element("div", { class: "code-row" }, this.tabRow, this.auto.row),
      this.originRow,
    );
  }

  /** Gives the focus to the element before the editor. */
  focus(): void {
    (this.runButton.hidden || this.runButton.disabled ? this.files : this.runButton).focus();
  }

  show(state: HeaderState): void {
    this.showFiles(state);
    this.showRun(state);
    this.mark.textContent = state.readOnly ? words.readOnly : state.isModified ? words.modified : "";
    this.tabRow.hidden = !state.hasTabs;
    for (const [tab, one] of this.tabs) one.setAttribute("aria-pressed", String(tab === state.tab));
    this.auto.row.hidden = !state.canRun;
    this.auto.box.checked = state.autoRun;
    this.auto.box.disabled = state.isAutoRunTooSlow;
    this.auto.row.title = state.isAutoRunTooSlow ? words.isAutoRunTooSlow : words.autoRunTitle;
    this.originRow.hidden = !state.origin;
    this.origin.textContent = state.origin ? words.luaOf(baseName(state.origin)) : "";
  }

  private showFiles({ files, name }: HeaderState): void {
    const listed = files.join("\n");
    if (listed !== this.listed) {
      this.files.replaceChildren(...files.map((file) => element("option", { value: file }, baseName(file))));
      this.listed = listed;
    }
    this.files.value = name;
    this.files.title = name;
  }

  private showRun({ canRun, running, isChangedSinceRun }: HeaderState): void {
    this.isRunning = running !== null;
    this.runButton.hidden = !canRun;
    this.runButton.textContent =
      running === null ? words.run : words.stop(Number.isNaN(running) ? "" : `${Math.floor(100 * running)} %`);
    this.runButton.title = running !== null ? words.stopTitle : isChangedSinceRun ? words.runChangedTitle : words.runTitle;
    this.runButton.classList.toggle("primary", running === null);
    this.runButton.classList.toggle("code-stale", isChangedSinceRun && running === null);
  }
}
