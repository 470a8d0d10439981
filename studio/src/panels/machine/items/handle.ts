// Handle in the view that moves the chosen object, frame or body.

import { Matrix4 } from "three";
import { shownRobot } from "../../../core/display_state";
import { texts } from "../../../texts";
import { tableAt, tablesAt, textAt, type TomlTable } from "../file/toml";
import type { Context } from "../form/context";
import type { ItemSelection, Item } from "./item_selection";
import { poseChanges, poseMatrix, toPose } from "./pose";
import { attachKey } from "./tree";

/** Decimals of mm and degrees: manual motion is not finer. */
const DIGITS = 2;

export class Handle {
  constructor(
    private readonly context: Context,
    private readonly chosen: ItemSelection,
  ) {
    chosen.on(() => this.draw());
    for (const key of ["run", "time_s", "robot"] as const) context.store.on(key, () => this.draw());
  }

  /** Moves the handle to the chosen item, or removes it. */
  draw(): void {
    const { item } = this.chosen;
    const place = item && this.handlePose(item);
    const displayed = this.context.store.get("handle");
    if (!item || !place) {
      if (displayed?.owner === this) this.context.store.set("handle", null);
      return;
    }
    this.context.store.set("handle", {
      owner: this,
      parent: place.parent.toArray(),
      pose: place.pose.toArray(),
      frame: place.frame,
      moved: (pose) => void this.moved(item, new Matrix4().fromArray(pose)),
    });
  }

  /** Returns the pose from the current file; null if the parent does not exist. */
  private handlePose(item: Item): { parent: Matrix4; pose: Matrix4; frame: number } | null {
    const { store } = this.context;
    const robot = shownRobot(store);
    const table = this.tables(item)[this.indexOf(item)];
    if (!robot?.scene.frames || !table) return null;
    const parseNumber = (name: string) => robot.scene.frames!.findIndex((frame) => frame.name === name);
    const on = textAt(table, [attachKey(item.kind)]) || "world";
    const t_s = store.get("time_s");
    const joints = robot.joints_at(t_s);
    const parent = joints && robot.chain.linkPoses(joints, t_s).frames[parseNumber(on === "jet" ? "tool" : on)];
    if (!parent) return null;
    return { parent, pose: poseMatrix(tableAt(table, ["frame"])), frame: parseNumber(item.name) };
  }

  private tables({ part, kind }: Item): TomlTable[] {
    return tablesAt(this.context.model.value(part), [kind]);
  }

  private indexOf(item: Item): number {
    return this.tables(item).findIndex((table) => textAt(table, ["name"]) === item.name);
  }

  private async moved(item: Item, pose: Matrix4): Promise<void> {
    const { edits, model } = this.context;
    const { part, kind, name } = item;
    const index = this.indexOf(item);
    if (index < 0) return;
    const at = [kind, index, "frame"];
    const changes = poseChanges(at, tableAt(model.value(part), at), toPose(pose, DIGITS));
    if (changes.length > 0) await edits.change(part, texts.machine.changed(name, texts.machine.items.moved), changes);
    this.draw();
  }
}
