// Six numbers of a frame and its matrix: Rz(roll) Ry(pitch) Rx(yaw), as in machine files.

import { Euler, MathUtils, Matrix4, Vector3 } from "three";
import type { TomlPath, TomlChange, TomlTable } from "../file/toml";

const { degToRad, radToDeg } = MathUtils;

const numberAt = (table: TomlTable, key: string): number => (typeof table[key] === "number" ? table[key] : 0);

export function poseMatrix(pose: TomlTable): Matrix4 {
  const [roll, pitch, yaw] = ["roll_deg", "pitch_deg", "yaw_deg"].map((key) => degToRad(numberAt(pose, key)));
  const turned = new Matrix4().makeRotationFromEuler(new Euler(yaw, pitch, roll, "ZYX"));
  return turned.setPosition(numberAt(pose, "x_mm"), numberAt(pose, "y_mm"), numberAt(pose, "z_mm"));
}

/** Returns a rigid matrix as the table of a frame, with so many digits. */
export function toPose(matrix: Matrix4, digits: number): TomlTable {
  const place = new Vector3().setFromMatrixPosition(matrix);
  const { x, y, z } = new Euler().setFromRotationMatrix(matrix, "ZYX");
  // Avoids "-0".
  const rounded = (value: number) => Number(value.toFixed(digits)) + 0;
  const angle = (radians: number) => rounded(radToDeg(radians));
  return {
    x_mm: rounded(place.x),
    y_mm: rounded(place.y),
    z_mm: rounded(place.z),
    roll_deg: angle(z),
    pitch_deg: angle(y),
    yaw_deg: angle(x),
  };
}

/** Returns the changes that turn one frame into another; unchanged numbers are left out. */
export function poseChanges(at: TomlPath, before: TomlTable, after: TomlTable): TomlChange[] {
  return Object.entries(after).flatMap(([key, value]): TomlChange[] =>
    numberAt(before, key) === value ? [] : [{ op: "set", at: [...at, key], value }],
  );
}
