// Writes the path as a part program for a controller, and shows its round trip: the distance between the path
// of the run and the given path.

import { check, element } from "../../core/dom";
import { dialectProperties } from "../../core/dialects";
import type { DisplayedPath } from "../../core/displayed_path";
import { baseName, shortName } from "../../core/file_kinds";
import type { Session } from "../../core/session";
import type { Store, Units } from "../../core/store";
import { texts } from "../../texts";
import { ChoiceRow, NumberRow, TextRow } from "./fields";
import { posts, writeProgram, type WriteChoice, type WrittenProgram } from "./engine_requests";
import { RoundTripNote, type Origin } from "./round_trip_note";

const words = texts.paths.write;
const offsets = ["as_path", "keep", "none", "machine"] as const;
const first: WriteChoice = {
  post: "ab9",
  program_name: "",
  inch: false,
  offsets: "as_path",
  rotary_as_given: false,
  verbose_words: false,
  separate_files: false,
  go_on: false,
  tolerance_mm: undefined,
  decimals_mm: undefined,
};
type Switch = "inch" | "rotary_as_given" | "verbose_words" | "separate_files" | "go_on";
const commonSwitches: Switch[] = ["inch", "rotary_as_given"];
const rare: Switch[] = ["verbose_words", "separate_files", "go_on"];

const isPost = (text: string): boolean => /^\s*reads_as\s*=/m.test(text);

/** "wheel" of "parts/wheel.path.json" */
const pathStem = (name: string): string => name.replace(/(\.path)?\.json$/i, "").replace(/^samples\//, "");

/** Returns the name of a file in the same folder. */
const beside = (name: string, file: string): string => name.slice(0, name.lastIndexOf("/") + 1) + file;

export class WriteForm {
  readonly element: HTMLDetailsElement;
  private choice = first;
  private units: Units = "mm";
  private path = "";
  /** Name of the program; empty: derived from the path's name. */
  private name = "";
  private names: string[] = [];
  /** Programs that were written here, with the names and texts of their paths. */
  private readonly written = new Map<string, Origin>();
  private readonly post = new ChoiceRow<string>(words.post, [], (post) => this.set({ post }));
  private readonly program = new TextRow(words.program, (name) => {
    this.name = name.trim();
    this.show(this.store.get("path"), this.units);
  });
  private readonly offsets = new ChoiceRow<(typeof offsets)[number]>(
    words.offsets,
    offsets.map((each) => [each, words.offsetsOf[each]] as const),
    (value) => this.set({ offsets: value }),
  );
  private readonly switches = new Map([...commonSwitches, ...rare].map((key) => [key, check(words.switches[key], (on) => this.set({ [key]: on }))] as const));
  private readonly tolerance = new NumberRow(words.tolerance, "length", (tolerance_mm) => this.set({ tolerance_mm }));
  private readonly decimals = new NumberRow(words.decimals, "none", (decimals_mm) => this.set({ decimals_mm }));
  private readonly button = element("button", { type: "button", class: "primary", onclick: () => void this.write() }, words.write);
  private readonly refused = element("p", { class: "fault", role: "alert", hidden: true });
  private readonly notes = element("ul", { class: "notes" });
  private readonly roundTrip: RoundTripNote;

  constructor(
    private readonly store: Store,
    private readonly session: Session,
  ) {
    this.roundTrip = new RoundTripNote(store, (program) => this.written.get(program) ?? null);
    const rows = (keys: Switch[]) => element("div", { class: "checks" }, ...keys.map((key) => this.switches.get(key)!.row));
    this.element = element(
      "details",
      { class: "write", open: true },
      element("summary", {}, words.title),
      this.post.element,
      this.program.element,
      this.offsets.element,
      rows(commonSwitches),
      element("details", {}, element("summary", {}, texts.paths.form.more), rows(rare), this.tolerance.element, this.decimals.element),
      this.button,
      this.refused,
      this.notes,
      this.roundTrip.element,
    );
  }

  private set(change: Partial<WriteChoice>): void {
    this.choice = { ...this.choice, ...change };
    this.show(this.store.get("path"), this.units);
  }

  /** Requests the list of posts, once. */
  async begin(): Promise<void> {
    if (this.names.length > 0) return;
    this.names = await posts(this.session);
    this.show(this.store.get("path"), this.units);
  }

  /** Returns the built-in posts, and files that are posts. */
  private listedOptions(): [string, string][] {
    const { documents } = this.session;
    const own = documents.userFileNames().filter((name) => /\.toml$/i.test(name) && isPost(documents.text(name)));
    return [...this.names, ...own].map((name) => [name, shortName(name)]);
  }

  /** Returns the language for reading programs of a post. */
  private dialectOf(post: string): string {
    const { documents } = this.session;
    const text = documents.text(post.endsWith(".toml") ? post : `samples/posts/${post}.toml`);
    return text.match(/^\s*reads_as\s*=\s*"([^"]*)"/m)?.[1] ?? "";
  }

  private get programName(): string {
    const { extension } = dialectProperties(this.dialectOf(this.choice.post));
    return this.name || `${pathStem(this.path)}${extension}`;
  }

  /** True if writing would replace a file that was not written from this path. */
  private get replaces(): boolean {
    const name = this.programName;
    return this.session.documents.get(name) !== undefined && this.written.get(name)?.path !== this.path;
  }

  show(displayed: DisplayedPath | null, units: Units): void {
    this.units = units;
    if (displayed && displayed.name !== this.path) [this.path, this.name] = [displayed.name, ""];
    const { choice } = this;
    this.post.setOptions(this.listedOptions(), choice.post);
    this.program.show(this.name, this.programName);
    this.offsets.show(choice.offsets as (typeof offsets)[number]);
    for (const [key, { box }] of this.switches) box.checked = choice[key];
    this.tolerance.show({ value: choice.tolerance_mm, inherited: 0.01 }, units);
    this.decimals.show({ value: choice.decimals_mm }, "mm");
    this.button.textContent = this.replaces ? words.replace(this.programName) : words.write;
    this.button.disabled = !displayed || displayed.error !== "";
    this.roundTrip.show();
  }

  private async write(): Promise<void> {
    const displayed = this.store.get("path");
    if (!displayed) return;
    const name = this.programName;
    const { choice } = this;
    this.button.disabled = true;
    const made = await writeProgram(this.session, displayed.name, { ...choice, program_name: baseName(name).replace(/\.[^.]*$/, "") });
    this.button.disabled = false;
    this.refused.hidden = !("refused" in made);
    this.refused.textContent = "refused" in made ? made.refused : "";
    this.notes.replaceChildren();
    if ("refused" in made) return;
    this.notes.append(...made.notes.map((note) => element("li", {}, note)));
    this.written.set(name, { path: displayed.name, text: displayed.text });
    this.keep(name, this.dialectOf(choice.post), made);
    this.show(this.store.get("path"), this.units);
  }

  /** Stores the program as the one to run, and runs it. */
  private keep(name: string, dialect: string, { text, files }: WrittenProgram): void {
    const others = Object.entries(files).map(([file, content]) => [beside(name, file), content]);
    const documents = Object.fromEntries([[name, text], ...others]) as Record<string, string>;
    const setup = { program: name, dialect, robots: "" };
    this.session.history.edit(texts.paths.labels.write(name), { documents, setup });
  }
}
