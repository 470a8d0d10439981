// Manual path in the view: drawn over all else; a click on a point selects it, its handle moves it and
// rotates the tool.

import { Box3, Matrix4, Scene, Vector2, Vector3, type WebGLRenderer } from "three";
import { editPath, toDisplayedPath } from "../../core/path_editing";
import type { DisplayedPath } from "../../core/displayed_path";
import { shownRobot } from "../../core/display_state";
import { movePoint, setTarget } from "../../run/path/path_edit";
import { isSameTarget, targetKey, pointAt, type TargetId, type Point } from "../../run/path/path_file";
import { stateAfter } from "../../run/path/path_traversal";
import { toolDirection, type Orientation } from "../../run/path/tool_direction";
import { rotateOrientation } from "../../run/path/rotate_orientation";
import { texts } from "../../texts";
import type { ActiveGrab } from "../gestures";
import type { Draggable, DraggableContext, Size } from "../draggables";
import type { Palette } from "../theme";
import { Handle } from "./handle";
import { gripAt, HandleDrag, type HandleGrip, type HandleContext } from "./handle_grips";
import { PathMarks } from "./path_marks";

const HIT_DISTANCE_PX = 9;
const words = texts.paths.labels;

export class PathEditor implements Draggable {
  private readonly scene = new Scene();
  private readonly marks = new PathMarks();
  private readonly handle = new Handle();
  private held: HandleGrip | null = null;
  private work = new Matrix4();
  private activeDrag: { cancel(): void } | null = null;
  /** File that was last brought into view. */
  private lastName = "";

  constructor(private readonly on: DraggableContext) {
    const { store } = on;
    this.scene.add(this.marks.group, this.handle.group);
    store.watch(["path", "showPath"], () => this.setContent());
    store.on("pathPoint", () => this.bringToSight());
  }

  private setContent(): void {
    const { displayed } = this;
    this.marks.setContent(displayed);
    this.on.moved();
    if (!displayed || displayed.name === this.lastName) return;
    this.lastName = displayed.name;
    if (!this.marks.dots.every(({ at }) => this.isOnScreen(at))) this.on.onOutOfView();
  }

  private isOnScreen(at: Vector3): boolean {
    const lastName = this.on.rig.project(at.clone().applyMatrix4(this.work));
    const { width_px, height_px } = this.on.size;
    return lastName !== null && lastName.x > 0 && lastName.y > 0 && lastName.x < width_px && lastName.y < height_px;
  }

  /** Centres a chosen point that is outside the screen. */
  private bringToSight(): void {
    const { chosen } = this;
    const at = chosen && new Vector3(...chosen.point.position_mm);
    if (!at || this.isOnScreen(at)) return this.on.changed();
    this.on.rig.target.copy(at.applyMatrix4(this.work));
    this.on.moved();
  }

  box(work: Matrix4): Box3 {
    return new Box3().setFromPoints(this.marks.dots.map(({ at }) => at)).applyMatrix4(work);
  }

  get displayed(): DisplayedPath | null {
    return this.on.store.get("showPath") ? this.on.store.get("path") : null;
  }

  recolour(colours: Palette): void {
    this.marks.recolour(colours);
    this.handle.recolour(colours);
  }

  /** Chosen point, as in the file. */
  private get chosen(): { place: TargetId; point: Point; displayed: DisplayedPath } | null {
    const { displayed } = this;
    const place = this.on.store.get("pathPoint");
    const point = displayed && place ? pointAt(displayed.file, place) : undefined;
    return displayed && place && point ? { place, point, displayed } : null;
  }

  /** Returns the orientation at the chosen point: its own, or the one before it. */
  private orientation(): Orientation {
    const { chosen } = this;
    return chosen ? stateAfter(chosen.displayed.walk.before.get(targetKey(chosen.place)) ?? {}, chosen.point) : {};
  }

  private direction(): Vector3 | null {
    return toolDirection(this.orientation(), shownRobot(this.on.store)?.chain ?? null);
  }

  private handleContext(): HandleContext | null {
    const { chosen, work } = this;
    const { rig } = this.on;
    return chosen && { work, at: new Vector3(...chosen.point.position_mm), rig, ...this.sizeNow };
  }

  private get sizeNow(): Size {
    const { width_px, height_px } = this.on.size;
    return { width_px, height_px };
  }

  draw(renderer: WebGLRenderer, work: Matrix4): void {
    this.work = work;
    if (!this.displayed) return;
    this.marks.place(work, this.on.rig);
    const handleContext = this.handleContext();
    this.handle.group.visible = handleContext !== null;
    if (handleContext) this.handle.place(handleContext, this.direction(), this.held);
    renderer.resetState();
    renderer.render(this.scene, this.on.rig.camera);
  }

  layOut(): void {
    if (this.displayed) this.marks.layOut(this.work, this.on.rig);
  }

  /** Chooses the point at a position of the screen; among several there, the one after the chosen one. */
  click(x_px: number, y_px: number): boolean {
    if (!this.displayed) return false;
    const near = this.marks.near(x_px, y_px, HIT_DISTANCE_PX, this.work, this.on.rig);
    if (near.length === 0) return false;
    const at = near.findIndex(({ place }) => isSameTarget(place, this.on.store.get("pathPoint")));
    const together = near.filter(({ at: each }) => each.distanceTo(near[Math.max(at, 0)].at) < 1e-6);
    const behind = together[(together.findIndex(({ place }) => isSameTarget(place, this.on.store.get("pathPoint"))) + 1) % together.length];
    this.on.store.set("pathPoint", at < 0 ? near[0].place : behind.place);
    return true;
  }

  hover(x_px: number, y_px: number): "grab" | "pointer" | "" {
    if (!this.displayed) return "";
    const grip = this.gripAt(x_px, y_px);
    if (grip?.kind !== this.held?.kind || grip?.axis !== this.held?.axis) {
      this.held = grip;
      this.on.changed();
    }
    if (grip) return "grab";
    return this.marks.near(x_px, y_px, HIT_DISTANCE_PX, this.work, this.on.rig).length > 0 ? "pointer" : "";
  }

  private gripAt(x_px: number, y_px: number): HandleGrip | null {
    const handleContext = this.handleContext();
    return handleContext && gripAt(handleContext, x_px, y_px, this.direction() !== null);
  }

  /** Grabs the handle if it is under the pointer. A drag is shown at once, and stored on release. */
  grab(x_px: number, y_px: number): ActiveGrab | null {
    const { chosen } = this;
    const { store } = this.on;
    const [handleContext, grip] = [this.handleContext(), this.gripAt(x_px, y_px)];
    if (!chosen || !handleContext || !grip) return null;
    const handleDrag = new HandleDrag(handleContext, grip, new Vector2(x_px, y_px));
    const orientation = this.orientation();
    let text = chosen.displayed.text;
    this.held = grip;
    const end = () => {
      this.activeDrag = null;
      this.held = null;
      this.on.changed();
    };
    const cancel = () => {
      store.set("path", chosen.displayed);
      end();
    };
    this.activeDrag = { cancel };
    return {
      drag: (x, y) => {
        if (!this.activeDrag) return;
        text = grip.kind === "turn" ? this.turned(chosen, orientation, handleDrag, x, y) : moved(chosen, handleDrag, x, y);
        store.set("path", toDisplayedPath(chosen.displayed.name, text));
      },
      drop: () => {
        if (!this.activeDrag) return;
        end();
        const label = grip.kind === "turn" ? words.turn : words.move;
        // States shown during the drag are not states of the file.
        store.set("path", chosen.displayed);
        if (text !== chosen.displayed.text) editPath(store, this.on.session, label, text);
      },
      cancel,
    };
  }

  cancelDrag(): boolean {
    const { activeDrag } = this;
    activeDrag?.cancel();
    return activeDrag !== null;
  }

  private turned({ place, displayed }: { place: TargetId; displayed: DisplayedPath }, orientation: Orientation, handleDrag: HandleDrag, x: number, y: number): string {
    const change = rotateOrientation(orientation, handleDrag.turn(x, y), shownRobot(this.on.store)?.chain ?? null);
    return change ? setTarget(displayed.text, place, change) : displayed.text;
  }
}

function moved({ place, point, displayed }: { place: TargetId; point: Point; displayed: DisplayedPath }, handleDrag: HandleDrag, x: number, y: number): string {
  const [dx, dy, dz] = handleDrag.shift(x, y).toArray();
  const [px, py, pz] = point.position_mm;
  if (dx === 0 && dy === 0 && dz === 0) return displayed.text;
  return movePoint(displayed.text, displayed.file, displayed.walk, place, [px + dx, py + dy, pz + dz]);
}
