// Block of the shown run, by the chosen line: modal state and machine position there, and a variant with
// times from there on.

import { Vector3 } from "three";
import { choice, element } from "../../core/dom";
import { goToBlock } from "../../core/navigation";
import type { ActiveSettings } from "../../core/active_modals";
import { shortName } from "../../core/file_kinds";
import type { Session } from "../../core/session";
import { shownRobot } from "../../core/display_state";
import type { State, Store } from "../../core/store";
import { axisText, lengthText, programmedFeedText, timeText } from "../../core/units";
import { toolInWork } from "../../run/path/tool_direction";
import type { Robot } from "../../run/run";
import { texts } from "../../texts";
import type { StartBlock } from "./data/variants_file";

const words = texts.variants.here;

/** Limit on offered passes; of lines with more passes, those near the chosen one are offered. */
const MAX_PASSES = 500;

/** Returns the TCP in use, in the work frame, mm. */
function tcpInWork(robot: Robot, t_s: number): Vector3 {
  const tip = new Vector3(...(robot.scene.tcps_mm[robot.tcp_at(t_s)!] ?? [0, 0, 0]));
  return tip.applyMatrix4(toolInWork(robot.chain, robot.joints_at(t_s)!, t_s));
}

/** Returns names and values for the user; for a run that is completely loaded. */
function blockSummaryRows(robot: Robot, block: number, units: State["units"]): [string, string][] {
  const { start_s, first } = robot.blocks.get(block);
  const info = robot.segments.info(first)!;
  const axes = robot.axes_at(start_s)!.map((value, i) => `${robot.letters[i]} ${axisText(value, robot.scene.axes[i].rotary, units)}`);
  const tip = tcpInWork(robot, start_s).toArray();
  const feed = info.feed_per_min > 0 ? programmedFeedText(info.feed_per_min, info.length_mm, units) : texts.run.kinds[info.kind];
  return [
    [words.time, timeText(start_s)],
    [words.axes, axes.join(", ")],
    [words.tip, tip.map((value, i) => `${"XYZ"[i]} ${lengthText(value, units)}`).join(", ")],
    [words.feed, feed],
    [words.process, info.processOn ? words.on : words.off],
  ];
}

export class BlockPanel {
  readonly element: HTMLElement;
  private readonly place = element("p", { class: "place" });
  private readonly passes = element("div", { class: "passes" });
  private readonly facts = element("dl", { class: "figures" });
  private readonly modal = element("p", { class: "modal", role: "status" });
  private readonly make: HTMLButtonElement;
  private asked = 0;

  constructor(
    private readonly store: Store,
    private readonly session: Session,
    makeVariant: (from: StartBlock) => void,
  ) {
    const attributes = { type: "button", title: words.makeHint, onclick: () => this.from && makeVariant(this.from) };
    this.make = element("button", attributes, words.make);
    const title = element("h3", { class: "heading" }, words.title);
    this.element = element("section", { class: "variant-here" }, title, this.place, this.passes, this.facts, this.modal, this.make);
  }

  /** Returns the chosen block, or for a chosen line its block at the shown instant; -1: none. */
  private get block(): number {
    const selection = this.store.get("selection");
    const robot = shownRobot(this.store);
    if (!selection || !robot) return -1;
    if (selection.block >= 0) return selection.block;
    return robot.blocks.nearest(robot.files.indexOf(selection.file), selection.line, this.store.get("time_s"));
  }

  private get from(): StartBlock | null {
    const { block } = this;
    const robot = shownRobot(this.store);
    if (block < 0 || !robot || robot.segments.isLong) return null;
    const { file, line } = robot.blocks.get(block);
    return { file: robot.files[file], line, pass: robot.blocks.blocksOfLine(file, line).indexOf(block) + 1 };
  }

  show(): void {
    const { store, block } = this;
    const selection = store.get("selection");
    const robot = shownRobot(store);
    const isLong = robot?.segments.isLong ?? false;
    const hasBlock = block >= 0 && robot !== undefined && !isLong;
    this.make.hidden = this.passes.hidden = this.facts.hidden = !hasBlock;
    this.modal.textContent = "";
    ++this.asked;
    if (!selection) return void (this.place.textContent = words.choose);
    const at = words.at(shortName(selection.file), selection.line);
    this.place.textContent = hasBlock ? at : `${at}. ${isLong ? words.tooLong : words.never}`;
    void this.showModal(selection.file, selection.line);
    if (!hasBlock) return;
    this.showPasses(robot, block);
    const rows = blockSummaryRows(robot, block, store.get("units"));
    this.facts.replaceChildren(
      ...rows.map(([name, text]) => element("div", { class: "figure" }, element("dt", {}, name), element("dd", {}, text))),
    );
  }

  /** Scrolls the form into view, with its actions. */
  reveal(): void {
    this.show();
    this.element.scrollIntoView({ block: "nearest" });
    if (!this.make.hidden) this.make.focus();
  }

  private showPasses(robot: Robot, block: number): void {
    const { file, line } = robot.blocks.get(block);
    const all = robot.blocks.blocksOfLine(file, line);
    this.passes.hidden = all.length < 2;
    if (all.length < 2) return this.passes.replaceChildren();
    const begin = Math.max(0, Math.min(all.indexOf(block) - MAX_PASSES / 2, all.length - MAX_PASSES));
    const options = Array.from(all.slice(begin, begin + MAX_PASSES), (each, i): [string, string] => {
      return [String(each), words.passAt(begin + i + 1, all.length, timeText(robot.blocks.start_s(each)))];
    });
    const hadFocus = this.passes.contains(document.activeElement);
    const select = choice(words.pass, options, String(block), (value) => goToBlock(this.store, Number(value)));
    this.passes.replaceChildren(select);
    if (hadFocus) select.focus();
  }

  private async showModal(file: string, line: number): Promise<void> {
    const { asked } = this;
    const found = await this.session.activeSettingsAt(file, line);
    if (asked === this.asked) this.modal.replaceChildren(...modalText(found));
  }
}

function modalText(found: ActiveSettings | null): (HTMLElement | string)[] {
  const title = element("b", {}, `${words.modal}: `);
  if (!found) return [title, words.noModal];
  const codes = found.codes.flatMap(({ name, group, meaning }) => [element("span", { title: `${group}: ${meaning}` }, name), " "]);
  return [title, ...codes, found.words.join(" "), ...(found.jumps ? [element("small", {}, ` (${words.byText})`)] : [])];
}
