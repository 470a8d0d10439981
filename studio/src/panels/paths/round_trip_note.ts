// Round trip in words: the distance between the path of a run and the path that its program was written from.

import { element } from "../../core/dom";
import { shownRobot } from "../../core/display_state";
import type { Store } from "../../core/store";
import { lengthText } from "../../core/units";
import { roundTrip, type RoundTrip } from "../../run/path/round_trip";
import type { Run } from "../../run/run";
import { texts } from "../../texts";

const words = texts.paths.roundTrip;
/** Distance above the accuracy of drawn paths, and above the rounding of programs. */
const MAX_DEVIATION_MM = 0.05;

/** Path that a program was written from. */
export interface Origin {
  path: string;
  text: string;
}

export class RoundTripNote {
  readonly element: HTMLElement;
  private readonly title = element("h3", { class: "heading" }, words.title);
  private readonly said = element("p", { class: "round-trip", role: "status" });
  private readonly button = element("button", { type: "button", onclick: () => this.measure() }, words.compare);
  /** Run and path text of the values. */
  private of: { run: Run; text: string } | null = null;
  private deviations: RoundTrip | null = null;

  constructor(
    private readonly store: Store,
    private readonly snapshotOf: (program: string) => Origin | null,
  ) {
    this.element = element("div", {}, this.title, this.said, this.button);
    store.watch(["run", "running", "path"], () => this.show());
  }

  /** Shows the values. The path of a program is only known if it was written here. */
  show(): void {
    const { store } = this;
    const [run, displayed] = [store.get("run"), store.get("path")];
    const program = run?.report?.program ?? "";
    const origin = this.snapshotOf(program);
    const isOwn = origin !== null && origin.path === displayed?.name;
    const isKnown = this.of?.run === run && this.of?.text === displayed?.text;
    this.button.hidden = !run?.report || !displayed || displayed.error !== "" || isKnown || (isOwn && origin.text === displayed.text);
    if (!run?.report || !displayed) this.tell("");
    else if (store.get("running")) this.tell(words.running);
    else if (isKnown) this.showDeviations(program);
    else if (!isOwn) this.tell(words.other(program));
    else if (origin.text !== displayed.text) this.tell(words.changed(program));
    else if (this.isVisible) this.measure();
  }

  private get isVisible(): boolean {
    return this.element.checkVisibility?.() ?? true;
  }

  private tell(sentence: string, isFar = false): void {
    if (this.said.textContent !== sentence) this.said.textContent = sentence;
    this.said.classList.toggle("fault", isFar);
  }

  private measure(): void {
    const { store } = this;
    const [run, displayed, robot] = [store.get("run"), store.get("path"), shownRobot(store)];
    if (!run || !displayed) return;
    this.of = { run, text: displayed.text };
    this.deviations = robot ? roundTrip(displayed.walk, robot.segments) : null;
    this.show();
  }

  private showDeviations(program: string): void {
    const { deviations } = this;
    const units = this.store.get("units");
    if (!deviations) return this.tell(words.noWay(program));
    const { runDeviation_mm, pathDeviation_mm } = deviations;
    const text = words.figures(program, lengthText(runDeviation_mm, units), lengthText(pathDeviation_mm, units));
    this.tell(this.of?.run.report?.status === "completed" ? text : words.unfinished(text), Math.max(runDeviation_mm, pathDeviation_mm) > MAX_DEVIATION_MM);
  }
}
