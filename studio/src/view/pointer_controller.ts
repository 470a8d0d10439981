// Actions of the pointer on the picture: it rotates the camera, selects blocks, measures.

import { Debounced } from "../core/debounced";
import type { Store } from "../core/store";
import { moveKinds } from "../run/kinds";
import { decodeKind } from "../run/segments";
import { texts } from "../texts";
import type { Gestures, ActiveGrab } from "./gestures";
import type { Draggable } from "./draggables";
import { bodyAt, positionAt, hitTime } from "./picking";
import { Tooltip } from "./tooltip";
import type { View } from "./view";

const HIT_DISTANCE_PX = 4;
const HOVER_MS = 40;

/** Returns the first result that is defined. */
function firstResult<A>(holds: Draggable[], ask: (hold: Draggable) => A): A | undefined {
  for (const hold of holds) {
    const result = ask(hold);
    if (result) return result;
  }
  return undefined;
}

export class PointerController implements Gestures {
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

  grab(x_px: number, y_px: number): ActiveGrab | null {
    const activeGrab = this.store.get("measuring") ? null : firstResult(this.view.draggables, (hold) => hold.grab(x_px, y_px)) ?? null;
    if (activeGrab) this.leave();
    return activeGrab;
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
    const cursor = firstResult(this.view.draggables, (hold) => hold.hover(x_px, y_px)) ?? "";
    this.view.canvas.element.style.cursor = cursor;
    if (cursor) return this.tooltip.hide();
    const hit = this.view.hit(x_px, y_px, HIT_DISTANCE_PX);
    if (!hit) return this.tooltip.hide();
    const { robot } = this.view.runScene.machines[hit.robot];
    const path = this.view.runScene.paths[hit.robot];
    const kind = moveKinds[decodeKind(path.vertexFlags(hit.vertex))];
    this.tooltip.show(robot, path.vertexSegment(hit.vertex), kind, this.store.get("units"), x_px, y_px);
  }

  click(x_px: number, y_px: number): void {
    if (this.store.get("measuring")) this.measure(x_px, y_px);
    else if (!firstResult(this.view.draggables, (hold) => hold.click?.(x_px, y_px))) this.choose(x_px, y_px);
  }

  private choose(x_px: number, y_px: number): void {
    const hit = this.view.hit(x_px, y_px, HIT_DISTANCE_PX);
    if (!hit) {
      this.store.set("selection", null);
      return this.store.set("body", bodyAt(x_px, y_px, this.view.canvas, this.view.runScene, this.view.rig));
    }
    const { runScene } = this.view;
    const machine = runScene.machines[hit.robot];
    const { robot } = machine;
    const path = runScene.paths[hit.robot];
    const segment = path.vertexSegment(hit.vertex);
    const { file, line } = robot.segments.lineOf(segment);
    const selection = { file: robot.files[file] ?? "", line, block: robot.blocks.of(segment) };
    this.store.set("playing", false);
    this.store.set("robot", hit.robot);
    const t_s = hitTime(path, hit, machine);
    this.store.set("time_s", t_s);
    this.store.set("selection", selection);
    if (robot.segments.locate(segment)) return;
    void robot.segments.fetchNow(segment).then((isHere) => {
      const isSame = this.store.get("selection") === selection && this.store.get("time_s") === t_s;
      if (isHere && isSame) this.store.set("time_s", hitTime(path, hit, machine));
    });
  }

  private measure(x_px: number, y_px: number): void {
    const { view } = this;
    const frame = view.displayed;
    if (!frame) return;
    const hit = view.hit(x_px, y_px, HIT_DISTANCE_PX);
    const works = frame.instants.map(({ linkPoses }) => linkPoses.work);
    const place = positionAt(x_px, y_px, view.canvas, hit, view.runScene, view.rig, works, frame.work);
    if (!place) return;
    view.runScene.measure.pick(place);
    this.measured = (this.measured % 2) + 1;
    this.say();
    view.invalidate();
  }

  private begin(): void {
    this.measured = 0;
    this.view.runScene.measure.clear();
    this.say();
    this.view.invalidate();
  }

  private say(): void {
    if (this.store.get("measuring")) {
      const done = this.view.runScene.measure.text(this.store.get("units"), texts.view.distance);
      this.hint.textContent = this.measured === 1 ? texts.view.measureSecond : done || texts.view.measureFirst;
    } else this.hint.textContent = this.store.get("run") ? "" : texts.view.empty;
  }
}
