// Position of a person in the cell. Metres, Y up, the floor at 0; rotations about Y, counter-clockwise from
// above (rad).

/** Pose of the head, as reported by the headset relative to its floor. */
export interface HeadPose {
  x_m: number;
  z_m: number;
  /** 0: it looks along -Z. */
  turn: number;
}

export interface FloorPosition {
  x_m: number;
  z_m: number;
}

const turned = ({ x_m, z_m }: FloorPosition, angle: number): FloorPosition => ({
  x_m: x_m * Math.cos(angle) + z_m * Math.sin(angle),
  z_m: z_m * Math.cos(angle) - x_m * Math.sin(angle),
});

/** Pose of the floor of the headset in the cell. */
export class FloorPose {
  x_m = 0;
  z_m = 0;
  turn = 0;

  /** Places the head at a spot, looking along -Z. */
  placeHead(head: HeadPose, spot: FloorPosition): void {
    this.face(head, spot, -head.turn);
  }

  private face(head: HeadPose, spot: FloorPosition, turn: number): void {
    const off = turned(head, turn);
    this.turn = turn;
    this.x_m = spot.x_m - off.x_m;
    this.z_m = spot.z_m - off.z_m;
  }

  floorPosition(head: HeadPose): FloorPosition {
    const off = turned(head, this.turn);
    return { x_m: this.x_m + off.x_m, z_m: this.z_m + off.z_m };
  }

  /** Walks in the direction of the head: so far to the right, so far forward. */
  walk(head: HeadPose, right_m: number, on_m: number): void {
    const way = turned({ x_m: right_m, z_m: -on_m }, this.turn + head.turn);
    this.x_m += way.x_m;
    this.z_m += way.z_m;
  }

  /** Turns on the spot. */
  turnBy(head: HeadPose, angle: number): void {
    this.face(head, this.floorPosition(head), this.turn + angle);
  }
}
