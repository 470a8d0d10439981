// Machines to start from: samples with the right kinematics, and the changes that make another machine of
// one.

import type { TomlChange } from "../file/toml";

const FOLDER = "samples/machines/";

export interface MachineKind {
  sample: string;
  /** Changes in addition to those of the user. */
  changes: TomlChange[];
}

/**
 * X and Y are under the work, as in most mills; directions describe the motion of the tool against the work.
 */
const movingTableChanges: TomlChange[] = [0, 1].map((axis) => ({ op: "set", at: ["axis", axis, "carries"], value: "work" }));

export const machineKinds = {
  router3: { sample: `${FOLDER}router3.toml`, changes: [] },
  mill3: { sample: `${FOLDER}router3.toml`, changes: movingTableChanges },
  gantry5: { sample: `${FOLDER}gantry-offset-head.toml`, changes: [] },
  mill_table_table: { sample: `${FOLDER}mill-table-table.toml`, changes: [] },
  mill_head_table: { sample: `${FOLDER}mill-head-table.toml`, changes: [] },
  arm6: { sample: `${FOLDER}arm6.toml`, changes: [] },
} satisfies Record<string, MachineKind>;

export type KindName = keyof typeof machineKinds;
export const kindNames = Object.keys(machineKinds) as KindName[];
