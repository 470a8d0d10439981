// Manual path in the view: drawn over all else; a click on a point selects it, its handle moves it and
// rotates the tool.

import { Box3, Matrix4, Scene, Vector2, Vector3, type WebGLRenderer } from "three";
import { editPath, pathShown } from "../../core/path_desk";
import type { PathShown } from "../../core/path_shown";
import { robotOf } from "../../core/shown";
import { movePoint, setTarget } from "../../run/path/path_edit";
import { isSamePlace, keyOfPlace, pointAt, type Place, type Point } from "../../run/path/path_file";
import { stateBehind } from "../../run/path/path_walk";
import { toolDirection, type Orientation } from "../../run/path/tool_direction";
import { turnedOrientation } from "../../run/path/turned";
import { texts } from "../../texts";
import type { Grabbed } from "../gestures";
import type { Hold, HoldPlace, Size } from "../holds";
import type { Palette } from "../theme";
import { gripAt, Pull, type Grip, type Stand } from "./grips";
import { Handle } from "./handle";
import { PathMarks } from "./marks";

const REACH_PX = 9;
const words = texts.paths.labels;

export class PathHand implements Hold {
  private readonly scene = new Scene();
  private readonly marks = new PathMarks();
  private readonly handle = new Handle();
  private held: Grip | null = null;
  private work = new Matrix4();
  private pulling: { cancel(): void } | null = null;
  /** File that was last brought into view. */
  private seen = "";

  constructor(private readonly on: HoldPlace) {
    const { store } = on;
    this.scene.add(this.marks.group, this.handle.group);
    store.watch(["path", "showPath"], () => this.take());
    store.on("pathPoint", () => this.bringToSight());
  }

  private take(): void {
    const { shown } = this;
    this.marks.take(shown);
    this.on.moved();
    if (!shown || shown.name === this.seen) return;
    this.seen = shown.name;
    if (!this.marks.dots.every(({ at }) => this.isSeen(at))) this.on.outOfSight();
  }

  private isSeen(at: Vector3): boolean {
    const seen = this.on.rig.project(at.clone().applyMatrix4(this.work));
    const { width_px, height_px } = this.on.size;
    return seen !== null && seen.x > 0 && seen.y > 0 && seen.x < width_px && seen.y < height_px;
  }

  /** Centres a chosen point that is outside the screen. */
  private bringToSight(): void {
    const { chosen } = this;
    const at = chosen && new Vector3(...chosen.point.position_mm);
    if (!at || this.isSeen(at)) return this.on.changed();
    this.on.rig.target.copy(at.applyMatrix4(this.work));
    this.on.moved();
  }

  box(work: Matrix4): Box3 {
    return new Box3().setFromPoints(this.marks.dots.map(({ at }) => at)).applyMatrix4(work);
  }

  get shown(): PathShown | null {
    return this.on.store.get("showPath") ? this.on.store.get("path") : null;
  }

  recolour(colours: Palette): void {
    this.marks.recolour(colours);
    this.handle.recolour(colours);
  }

  /** Chosen point, as in the file. */
  private get chosen(): { place: Place; point: Point; shown: PathShown } | null {
    const { shown } = this;
    const place = this.on.store.get("pathPoint");
    const point = shown && place ? pointAt(shown.file, place) : undefined;
    return shown && place && point ? { place, point, shown } : null;
  }

  /** Returns the orientation at the chosen point: its own, or the one before it. */
  private orientation(): Orientation {
    const { chosen } = this;
    return chosen ? stateBehind(chosen.shown.walk.before.get(keyOfPlace(chosen.place)) ?? {}, chosen.point) : {};
  }

  private direction(): Vector3 | null {
    return toolDirection(this.orientation(), robotOf(this.on.store)?.chain ?? null);
  }

  private stand(): Stand | null {
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
    if (!this.shown) return;
    this.marks.place(work, this.on.rig);
    const stand = this.stand();
    this.handle.group.visible = stand !== null;
    if (stand) this.handle.place(stand, this.direction(), this.held);
    renderer.resetState();
    renderer.render(this.scene, this.on.rig.camera);
  }

  lay(): void {
    if (this.shown) this.marks.lay(this.work, this.on.rig);
  }

  /** Chooses the point at a position of the screen; among several there, the one after the chosen one. */
  click(x_px: number, y_px: number): boolean {
    if (!this.shown) return false;
    const near = this.marks.near(x_px, y_px, REACH_PX, this.work, this.on.rig);
    if (near.length === 0) return false;
    const at = near.findIndex(({ place }) => isSamePlace(place, this.on.store.get("pathPoint")));
    const together = near.filter(({ at: each }) => each.distanceTo(near[Math.max(at, 0)].at) < 1e-6);
    const behind = together[(together.findIndex(({ place }) => isSamePlace(place, this.on.store.get("pathPoint"))) + 1) % together.length];
    this.on.store.set("pathPoint", at < 0 ? near[0].place : behind.place);
    return true;
  }

  hover(x_px: number, y_px: number): "grab" | "pointer" | "" {
    if (!this.shown) return "";
    const grip = this.gripAt(x_px, y_px);
    if (grip?.kind !== this.held?.kind || grip?.axis !== this.held?.axis) {
      this.held = grip;
      this.on.changed();
    }
    if (grip) return "grab";
    return this.marks.near(x_px, y_px, REACH_PX, this.work, this.on.rig).length > 0 ? "pointer" : "";
  }

  private gripAt(x_px: number, y_px: number): Grip | null {
    const stand = this.stand();
    return stand && gripAt(stand, x_px, y_px, this.direction() !== null);
  }

  /** Grabs the handle if it is under the pointer. A drag is shown at once, and stored on release. */
  grab(x_px: number, y_px: number): Grabbed | null {
    const { chosen } = this;
    const { store } = this.on;
    const [stand, grip] = [this.stand(), this.gripAt(x_px, y_px)];
    if (!chosen || !stand || !grip) return null;
    const pull = new Pull(stand, grip, new Vector2(x_px, y_px));
    const orientation = this.orientation();
    let text = chosen.shown.text;
    this.held = grip;
    const end = () => {
      this.pulling = null;
      this.held = null;
      this.on.changed();
    };
    const cancel = () => {
      store.set("path", chosen.shown);
      end();
    };
    this.pulling = { cancel };
    return {
      drag: (x, y) => {
        if (!this.pulling) return;
        text = grip.kind === "turn" ? this.turned(chosen, orientation, pull, x, y) : moved(chosen, pull, x, y);
        store.set("path", pathShown(chosen.shown.name, text));
      },
      drop: () => {
        if (!this.pulling) return;
        end();
        const label = grip.kind === "turn" ? words.turn : words.move;
        // States shown during the drag are not states of the file.
        store.set("path", chosen.shown);
        if (text !== chosen.shown.text) editPath(store, this.on.session, label, text);
      },
      cancel,
    };
  }

  escape(): boolean {
    const { pulling } = this;
    pulling?.cancel();
    return pulling !== null;
  }

  private turned({ place, shown }: { place: Place; shown: PathShown }, orientation: Orientation, pull: Pull, x: number, y: number): string {
    const change = turnedOrientation(orientation, pull.turn(x, y), robotOf(this.on.store)?.chain ?? null);
    return change ? setTarget(shown.text, place, change) : shown.text;
  }
}

function moved({ place, point, shown }: { place: Place; point: Point; shown: PathShown }, pull: Pull, x: number, y: number): string {
  const [dx, dy, dz] = pull.shift(x, y).toArray();
  const [px, py, pz] = point.position_mm;
  if (dx === 0 && dy === 0 && dz === 0) return shown.text;
  return movePoint(shown.text, shown.file, shown.walk, place, [px + dx, py + dy, pz + dz]);
}
