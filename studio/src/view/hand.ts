// Actions of the pointer on the picture: it rotates the camera, selects blocks, measures.

import { Debounced } from "../core/debounced";
import type { Store } from "../core/store";
import { moveKinds } from "../run/kinds";
import { kindCodeOf } from "../run/segments";
import { texts } from "../texts";
import type { Gestures, Grabbed } from "./gestures";
import type { Hold } from "./holds";
import { bodyAt, placeAt, timeOf } from "./picking";
import { Tooltip } from "./tooltip";
import type { View } from "./view";

const REACH_PX = 4;
const HOVER_MS = 40;

/** Returns the first result that is defined. */
function firstOf<A>(holds: Hold[], ask: (hold: Hold) => A): A | undefined {
  for (const hold of holds) {
    const answer = ask(hold);
    if (answer) return answer;
  }
  return undefined;
}

export class Hand implements Gestures {
  readonly tooltip = new Tooltip();
  private readonly hovering = new Debounced(() => this.tell());
  private at = { x_px: 0, y_px: 0 };
  private measured = 0;

  constructor(
    private readonly view: View,
    private readonly store: Store,
    private readonly hint: HTMLElement,
  ) {
    store.watch(["measuring", "run"], () => this.begin());
  }

  grab(x_px: number, y_px: number): Grabbed | null {
    const grabbed = this.store.get("measuring") ? null : firstOf(this.view.holds, (hold) => hold.grab(x_px, y_px)) ?? null;
    if (grabbed) this.leave();
    return grabbed;
  }

  orbit(dx_px: number, dy_px: number): void {
    this.view.rig.orbit(dx_px, dy_px);
    this.moved();
  }

  pan(dx_px: number, dy_px: number): void {
    this.view.rig.pan(dx_px, dy_px);
    this.moved();
  }

  zoom(factor: number, x_px: number, y_px: number): void {
    this.view.rig.zoom(factor, x_px, y_px);
    this.moved();
  }

  private moved(): void {
    this.leave();
    this.view.turned();
  }

  leave(): void {
    this.hovering.cancel();
    this.tooltip.hide();
  }

  hover(x_px: number, y_px: number): void {
    this.at = { x_px, y_px };
    this.hovering.after(HOVER_MS);
  }

  private tell(): void {
    const { x_px, y_px } = this.at;
    const cursor = firstOf(this.view.holds, (hold) => hold.hover(x_px, y_px)) ?? "";
    this.view.canvas.element.style.cursor = cursor;
    if (cursor) return this.tooltip.hide();
    const hit = this.view.hit(x_px, y_px, REACH_PX);
    if (!hit) return this.tooltip.hide();
    const { robot } = this.view.stage.machines[hit.robot];
    const path = this.view.stage.paths[hit.robot];
    const kind = moveKinds[kindCodeOf(path.flagsOf(hit.vertex))];
    this.tooltip.show(robot, path.segmentOf(hit.vertex), kind, this.store.get("units"), x_px, y_px);
  }

  click(x_px: number, y_px: number): void {
    if (this.store.get("measuring")) this.measure(x_px, y_px);
    else if (!firstOf(this.view.holds, (hold) => hold.click?.(x_px, y_px))) this.choose(x_px, y_px);
  }

  private choose(x_px: number, y_px: number): void {
    const hit = this.view.hit(x_px, y_px, REACH_PX);
    if (!hit) {
      this.store.set("selection", null);
      return this.store.set("body", bodyAt(x_px, y_px, this.view.canvas, this.view.stage, this.view.rig));
    }
    const { stage } = this.view;
    const machine = stage.machines[hit.robot];
    const { robot } = machine;
    const path = stage.paths[hit.robot];
    const segment = path.segmentOf(hit.vertex);
    const { file, line } = robot.segments.lineOf(segment);
    const selection = { file: robot.files[file] ?? "", line, block: robot.blocks.of(segment) };
    this.store.set("playing", false);
    this.store.set("robot", hit.robot);
    const t_s = timeOf(path, hit, machine);
    this.store.set("time_s", t_s);
    this.store.set("selection", selection);
    if (robot.segments.locate(segment)) return;
    void robot.segments.need(segment).then((isHere) => {
      const isSame = this.store.get("selection") === selection && this.store.get("time_s") === t_s;
      if (isHere && isSame) this.store.set("time_s", timeOf(path, hit, machine));
    });
  }

  private measure(x_px: number, y_px: number): void {
    const { view } = this;
    const frame = view.shown;
    if (!frame) return;
    const hit = view.hit(x_px, y_px, REACH_PX);
    const works = frame.instants.map(({ places }) => places.work);
    const place = placeAt(x_px, y_px, view.canvas, hit, view.stage, view.rig, works, frame.work);
    if (!place) return;
    view.stage.measure.pick(place);
    this.measured = (this.measured % 2) + 1;
    this.say();
    view.invalidate();
  }

  private begin(): void {
    this.measured = 0;
    this.view.stage.measure.clear();
    this.say();
    this.view.invalidate();
  }

  private say(): void {
    if (this.store.get("measuring")) {
      const done = this.view.stage.measure.text(this.store.get("units"), texts.view.distance);
      this.hint.textContent = this.measured === 1 ? texts.view.measureSecond : done || texts.view.measureFirst;
    } else this.hint.textContent = this.store.get("run") ? "" : texts.view.empty;
  }
}
