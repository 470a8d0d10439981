// Headset that shows the cell: from entry to end nothing else draws, and afterwards everything is as before.

import type { AnimationFrames } from "../../core/animation_frames";
import type { Store } from "../../core/store";
import type { View } from "../view";
import { FloorPose, type HeadPose } from "./floor_pose";
import { XrScene } from "./xr_scene";
import { SPEED_M_S, STEP_DEG, Sticks, type Stick } from "./sticks";

/** Max time between two pictures that counts for walking. */
const MAX_FRAME_TIME_S = 0.1;

const isThumbstick = ({ gamepad, targetRayMode }: XRInputSource): boolean => targetRayMode === "tracked-pointer" && (gamepad?.axes.length ?? 0) >= 2;

/** Returns the stick; on a pad with four axes the first two are its touchpad. */
function readStick({ gamepad, handedness }: XRInputSource): Stick {
  const [x, y] = gamepad!.axes.slice(gamepad!.axes.length >= 4 ? 2 : 0);
  return { hand: handedness, x, y };
}

function readHeadPose({ transform: { position, orientation } }: XRViewerPose): HeadPose {
  const { x, y, z, w } = orientation;
  // Direction of -Z of the head, from above.
  const turn = Math.atan2(2 * (x * z + w * y), 1 - 2 * (x * x + y * y));
  return { x_m: position.x, z_m: position.z, turn };
}

export class XrSession {
  private readonly place = new FloorPose();
  private readonly sticks = new Sticks();
  private readonly xrScene: XrScene;
  private stands = false;
  private before_ms: number | null = null;

  constructor(
    private readonly view: View,
    store: Store,
    private readonly frames: AnimationFrames,
    private readonly session: XRSession,
  ) {
    this.xrScene = new XrScene(view);
    session.addEventListener("select", () => store.set("playing", !store.get("playing") && store.get("run") !== null));
    session.addEventListener("squeeze", () => (this.stands = false));
  }

  /** Called when a picture of the headset is due. */
  show(now_ms: number, frame: XRFrame): void {
    this.frames.drive(now_ms);
    const space = this.view.canvas.renderer.xr.getReferenceSpace();
    const pose = space && frame.getViewerPose(space);
    const elapsed_s = Math.min(Math.max(now_ms - (this.before_ms ?? now_ms), 0) / 1000, MAX_FRAME_TIME_S);
    this.before_ms = now_ms;
    if (!pose) return; // not worn, or its pose is unknown
    this.go(readHeadPose(pose), elapsed_s);
    this.xrScene.draw(this.place, this.view.arrange());
  }

  private go(head: HeadPose, elapsed_s: number): void {
    if (!this.stands) this.place.placeHead(head, this.xrScene.entry);
    this.stands = true;
    const { right, on, turns } = this.sticks.ask([...this.session.inputSources].filter(isThumbstick).map(readStick));
    const distance_m = SPEED_M_S * elapsed_s;
    this.place.walk(head, right * distance_m, on * distance_m);
    if (turns !== 0) this.place.turnBy(head, (-turns * STEP_DEG * Math.PI) / 180);
  }

  end(): void {
    this.xrScene.dispose();
    this.frames.release();
  }
}

export class Headset {
  private session: XRSession | null = null;

  constructor(
    private readonly view: View,
    private readonly store: Store,
    private readonly frames: AnimationFrames,
    private readonly system: XRSystem,
    /** Called when it starts or ends showing the cell. */
    private readonly changed: () => void,
  ) {}

  get isActive(): boolean {
    return this.session !== null;
  }

  /** Fails with the reason if the browser or the device refuses. */
  async enter(): Promise<void> {
    const { xr } = this.view.canvas.renderer;
    const session = await this.system.requestSession("immersive-vr", { requiredFeatures: ["local-floor"] });
    this.session = session;
    this.view.lendRenderer();
    const visit = new XrSession(this.view, this.store, this.frames, session);
    const ended = () => {
      xr.removeEventListener("sessionend", ended);
      visit.end();
      this.restoreView();
    };
    // Sent by three.js, after its own actions.
    xr.addEventListener("sessionend", ended);
    xr.enabled = true;
    xr.setReferenceSpaceType("local-floor");
    xr.setAnimationLoop((now_ms: number, frame?: XRFrame) => frame && visit.show(now_ms, frame));
    this.changed();
    try {
      await xr.setSession(session);
    } catch (error) {
      await this.leave();
      throw error;
    }
  }

  async leave(): Promise<void> {
    // A session that has ended by itself cannot be ended.
    await this.session?.end().catch(() => undefined);
  }

  private restoreView(): void {
    const { renderer } = this.view.canvas;
    this.session = null;
    renderer.xr.enabled = false;
    // Otherwise three.js continues to request pictures of the window.
    renderer.setAnimationLoop(null);
    this.view.reclaimRenderer();
    this.changed();
  }
}
