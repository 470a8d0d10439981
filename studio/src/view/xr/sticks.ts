// Input of the thumbsticks of a headset: the left one walks, the right one turns; a single one does both.

export interface Stick {
  hand: "left" | "right" | "none";
  /** Deflection to the right and towards the person, -1 to 1. */
  x: number;
  y: number;
}

/** Walking speed, 1 at full deflection; steps to turn by, to the right. */
export interface StickInput {
  right: number;
  on: number;
  turns: number;
}

/** Dead zone: sticks do not return exactly to 0. */
const DEAD_ZONE = 0.15;
/** Deflection that starts a turn, and limit for returning before the next one. */
const TURN_THRESHOLD = 0.7;
const REARM_THRESHOLD = 0.4;

export const SPEED_M_S = 1.5;
export const STEP_DEG = 30;

const applyDeadZone = (value: number): number => (Math.abs(value) < DEAD_ZONE ? 0 : value);

export class Sticks {
  private readonly turned = new Set<string>();

  ask(sticks: Stick[]): StickInput {
    const asked = { right: 0, on: 0, turns: 0 };
    const single = sticks.length < 2;
    for (const { hand, x, y } of sticks) {
      if (single || hand === "left") asked.on -= applyDeadZone(y);
      if (!single && hand === "left") asked.right += applyDeadZone(x);
      if (single || hand === "right") asked.turns += this.turns(hand, x);
    }
    return asked;
  }

  /** Once for each push. */
  private turns(hand: string, x: number): number {
    if (Math.abs(x) < REARM_THRESHOLD) this.turned.delete(hand);
    if (Math.abs(x) < TURN_THRESHOLD || this.turned.has(hand)) return 0;
    this.turned.add(hand);
    return Math.sign(x);
  }
}
