// A headset that shows the cell: from its entering to its end nothing else draws, and behind it all is as it was.

import type { Frames } from "../../core/frames";
import type { Store } from "../../core/store";
import type { View } from "../view";
import { Place, type Head } from "./place";
import { Room } from "./room";
import { SPEED_M_S, STEP_DEG, Sticks, type Stick } from "./sticks";

/** A longer time between two pictures is none of walking. */
const LONGEST_S = 0.1;

const isOfSticks = ({ gamepad, targetRayMode }: XRInputSource): boolean => targetRayMode === "tracked-pointer" && (gamepad?.axes.length ?? 0) >= 2;

/** Of a pad with four axes the first two are its touchpad. */
function stickOf({ gamepad, handedness }: XRInputSource): Stick {
  const [x, y] = gamepad!.axes.slice(gamepad!.axes.length >= 4 ? 2 : 0);
  return { hand: handedness, x, y };
}

function headOf({ transform: { position, orientation } }: XRViewerPose): Head {
  const { x, y, z, w } = orientation;
  // Where -Z of the head points to, from above.
  const turn = Math.atan2(2 * (x * z + w * y), 1 - 2 * (x * x + y * y));
  return { x_m: position.x, z_m: position.z, turn };
}

export class Visit {
  private readonly place = new Place();
  private readonly sticks = new Sticks();
  private readonly room: Room;
  private stands = false;
  private before_ms: number | null = null;

  constructor(
    private readonly view: View,
    store: Store,
    private readonly frames: Frames,
    private readonly session: XRSession,
  ) {
    this.room = new Room(view);
    session.addEventListener("select", () => store.set("playing", !store.get("playing") && store.get("run") !== null));
    session.addEventListener("squeeze", () => (this.stands = false));
  }

  /** A picture of the headset is due. */
  show(now_ms: number, frame: XRFrame): void {
    this.frames.drive(now_ms);
    const space = this.view.canvas.renderer.xr.getReferenceSpace();
    const pose = space && frame.getViewerPose(space);
    const passed_s = Math.min(Math.max(now_ms - (this.before_ms ?? now_ms), 0) / 1000, LONGEST_S);
    this.before_ms = now_ms;
    if (!pose) return; // it is not worn, or does not know where it is
    this.go(headOf(pose), passed_s);
    this.room.draw(this.place, this.view.arrange());
  }

  private go(head: Head, passed_s: number): void {
    if (!this.stands) this.place.stand(head, this.room.entry);
    this.stands = true;
    const { right, on, turns } = this.sticks.ask([...this.session.inputSources].filter(isOfSticks).map(stickOf));
    const way_m = SPEED_M_S * passed_s;
    this.place.walk(head, right * way_m, on * way_m);
    if (turns !== 0) this.place.turnBy(head, (-turns * STEP_DEG * Math.PI) / 180);
  }

  end(): void {
    this.room.dispose();
    this.frames.release();
  }
}

export class Headset {
  private session: XRSession | null = null;

  constructor(
    private readonly view: View,
    private readonly store: Store,
    private readonly frames: Frames,
    private readonly system: XRSystem,
    /** It shows the cell, or no more. */
    private readonly changed: () => void,
  ) {}

  get isWorn(): boolean {
    return this.session !== null;
  }

  /** Fails with the reason where the browser or the device refuses. */
  async enter(): Promise<void> {
    const { xr } = this.view.canvas.renderer;
    const session = await this.system.requestSession("immersive-vr", { requiredFeatures: ["local-floor"] });
    this.session = session;
    this.view.lend();
    const visit = new Visit(this.view, this.store, this.frames, session);
    const ended = () => {
      xr.removeEventListener("sessionend", ended);
      visit.end();
      this.giveBack();
    };
    // Told by three.js, behind what it does itself then.
    xr.addEventListener("sessionend", ended);
    xr.enabled = true;
    xr.setReferenceSpaceType("local-floor");
    xr.setAnimationLoop((now_ms: number, frame?: XRFrame) => frame && visit.show(now_ms, frame));
    this.changed();
    try {
      await xr.setSession(session);
    } catch (fault) {
      await this.leave();
      throw fault;
    }
  }

  async leave(): Promise<void> {
    // One that has ended by itself cannot be ended.
    await this.session?.end().catch(() => undefined);
  }

  private giveBack(): void {
    const { renderer } = this.view.canvas;
    this.session = null;
    renderer.xr.enabled = false;
    // three.js goes on asking for pictures of the window else.
    renderer.setAnimationLoop(null);
    this.view.takeBack();
    this.changed();
  }
}
