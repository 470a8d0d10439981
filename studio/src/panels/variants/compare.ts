// Comparison of two variants: which one is faster, and at which lines; both machines on one clock.

import { check, choice, element, setOptions } from "../../core/dom";
import { Debounced } from "../../core/debounced";
import { goTo, goToBlock } from "../../core/navigation";
import type { Session } from "../../core/session";
import type { Store } from "../../core/store";
import { countText } from "../../core/units";
import type { Run } from "../../run/run";
import { texts } from "../../texts";
import { Differences } from "./data/differences";
import { isCurrent, type VariantStatus } from "./data/results";
import type { Variant } from "./data/variants_file";
import { DifferenceRows } from "./difference_rows";
import type { ListedVariant } from "./list";
import { comparisonNotes, comparisonMessages } from "./comparison_messages";
import { statusText } from "./variant_texts";

const words = texts.variants;
const INITIAL_ROWS = 200;
const TYPING_PAUSE_MS = 150;

/** Variant with current results. */
interface CurrentVariant {
  variant: Variant;
  standing: VariantStatus;
  run: Run;
}

export class Compare {
  readonly element: HTMLElement;
  private readonly choices = [words.first, words.second].map((label, i) =>
    choice(label, [], "", (name) => {
      this.chosen[i] = name;
      this.draw();
    }),
  );
  private readonly both: { row: HTMLLabelElement; box: HTMLInputElement };
  private readonly said = element("div", { class: "said", role: "status" });
  private readonly search: HTMLInputElement;
  private readonly count = element("p", { class: "note", role: "status" });
  private readonly rows: DifferenceRows;
  private readonly more = element("button", { class: "more", type: "button", onclick: () => this.showMore() });
  private readonly results: HTMLElement;
  private readonly filterTimer = new Debounced(() => this.showRows(INITIAL_ROWS));
  private chosen: [string, string] = ["", ""];
  private listed: readonly ListedVariant[] = [];
  private pair: [CurrentVariant, CurrentVariant] | null = null;
  /** Inputs of the differences, as a text. */
  private comparedKey = "";
  private differences: Differences | null = null;
  private most = INITIAL_ROWS;
  private shows = false;

  constructor(
    private readonly store: Store,
    private readonly session: Session,
  ) {
    this.both = check(words.beside, (on) => this.toggleComparisonView(on));
    this.search = element("input", {
      ...{ type: "search", placeholder: words.filter, "aria-label": words.filter, title: words.filterHint },
      oninput: () => this.filterTimer.after(TYPING_PAUSE_MS),
    });
    this.rows = new DifferenceRows((a, b) => this.goToRow(a, b));
    this.results = element("div", {}, this.search, this.count, element("div", { class: "wide" }, this.rows.element), this.more);
    this.element = element(
      "section",
      { class: "variant-compare" },
      element("h3", { class: "heading" }, words.compare),
      element("div", { class: "pair" }, ...this.choices.map((each, i) => element("label", {}, [words.first, words.second][i], each))),
      this.both.row,
      this.said,
      this.results,
    );
    store.on("run", () => this.updateComparisonView());
    store.watch(["comparisonRun"], () => (this.both.box.checked = store.get("comparisonRun") !== null));
  }

  /** Called when the list of variants has changed. */
  show(listed: readonly ListedVariant[]): void {
    this.listed = listed;
    this.draw();
  }

  private draw(): void {
    const names = this.listed.map(({ variant }) => variant.name);
    this.element.hidden = names.length < 2;
    this.chosen = [0, 1].map((i) => (names.includes(this.chosen[i]) ? this.chosen[i] : (names[i] ?? ""))) as [string, string];
    this.choices.forEach((each, i) => setOptions(each, names.map((name) => [name, name]), this.chosen[i]));
    const [one, other] = this.chosen.map((name) => this.currentVariant(name));
    const before = this.pair;
    this.pair = one && other && one.run !== other.run ? [one, other] : null;
    this.both.box.disabled = !this.pair;
    this.updateComparisonView();
    const comparedKey = JSON.stringify([this.store.get("robot"), ...(this.pair?.map(({ variant }) => [variant.name, variant.from]) ?? [])]);
    const isSame = comparedKey === this.comparedKey && before && this.pair?.every(({ run }, i) => run === before[i].run);
    this.comparedKey = comparedKey;
    if (!isSame || !this.differences) this.compare();
  }

  private currentVariant(name: string): CurrentVariant | null {
    const found = this.listed.find(({ variant }) => variant.name === name);
    return found && isCurrent(found.standing) ? { ...found, run: found.standing.run } : null;
  }

  private compare(): void {
    const { pair } = this;
    this.differences = null;
    this.results.hidden = true;
    if (!pair) return this.said.replaceChildren(...this.missingResultReasons().map(note));
    const robot = this.store.get("robot");
    const [a, b] = pair.map(({ run }) => ({ run, robot: run.robots[robot] }));
    const missingRun = pair.find(({ run }) => !run.robots[robot]);
    if (missingRun) return this.said.replaceChildren(note(words.noRobot(missingRun.variant.name, robot + 1)));
    const from = pair[1].variant.from ?? pair[0].variant.from;
    const differences = new Differences(a, b, from);
    const namedComparison = { differences, names: this.chosen };
    const sentences = comparisonMessages(namedComparison).map((text, i) => element("p", { class: i === 0 ? "great" : "" }, text));
    this.said.replaceChildren(...sentences, ...comparisonNotes(namedComparison).map(note));
    this.differences = differences;
    this.results.hidden = !differences.reachesStart;
    this.showRows(INITIAL_ROWS);
  }

  private missingResultReasons(): string[] {
    if (this.chosen[0] === this.chosen[1]) return [words.selectTwo];
    const found = this.chosen.flatMap((name) => {
      const listed = this.listed.find(({ variant }) => variant.name === name);
      return listed && !isCurrent(listed.standing) ? [words.notCurrent(name, statusText(listed.standing)[0])] : [];
    });
    return [words.selectTwo, ...found];
  }

  private showMore(): void {
    this.showRows(2 * this.most);
  }

  private showRows(most: number): void {
    if (!this.differences) return;
    this.most = most;
    const { rows, count } = this.differences.rows(most, this.search.value);
    this.rows.show(rows, this.differences, this.chosen);
    const nothing = this.search.value.trim() ? words.noMatch : words.noRows;
    this.count.textContent = count > 0 ? words.rowCount(countText(rows.length), countText(count)) : nothing;
    this.more.hidden = rows.length >= count;
    this.more.textContent = texts.panels.more(Math.min(most, count - rows.length));
  }

  /**
   * Selects the row in the page, which shows the first of both. If only the second has the block, selects
   * that one, unless both are on one clock.
   */
  private goToRow(a: number, b: number): void {
    const { pair, store } = this;
    if (!pair) return;
    const [one, other] = pair;
    if (a >= 0) {
      this.displayed(one);
      return goToBlock(store, a);
    }
    const comparisonRun = store.get("comparisonRun");
    if (!comparisonRun) {
      this.displayed(other);
      return goToBlock(store, b);
    }
    const robot = other.run.robots[store.get("robot")];
    const { file, line, start_s } = robot.blocks.get(b);
    goTo(store, { file: robot.files[file], line }, start_s);
  }

  private displayed({ run, variant }: CurrentVariant): void {
    this.session.showRun(run, words.steps.applySetup(variant.name));
  }

  private toggleComparisonView(on: boolean): void {
    const { pair, store } = this;
    if (!on || !pair) return store.set("comparisonRun", null);
    // The run of the first variant is shown, which would otherwise end the comparison view.
    this.shows = true;
    this.displayed(pair[0]);
    this.shows = false;
    store.set("comparisonRun", { run: pair[1].run, names: [this.chosen[0], this.chosen[1]] });
    const { from } = pair[1].variant.from ? pair[1].variant : pair[0].variant;
    const { starts_s } = this.differences ?? {};
    if (from && starts_s) store.set("time_s", Math.min(...starts_s));
  }

  /** Keeps both in the view while they are the chosen ones and current. */
  private updateComparisonView(): void {
    const { store, pair } = this;
    const comparisonRun = store.get("comparisonRun");
    if (!comparisonRun || this.shows) return;
    const isShownPair = pair !== null && store.get("run") === pair[0].run && comparisonRun.run === pair[1].run;
    if (!isShownPair) store.set("comparisonRun", null);
  }
}

const note = (text: string): HTMLElement => element("p", { class: "note" }, text);
