// Check if the change of a file would change a run.

import type { Run } from "../run/run";
import type { FileKind } from "./file_kinds";
import type { Setup } from "./setup";

/** Files that no run reads. */
const NEVER_READ = /\.(json|md|dxf|svg)$/i;

export function affectsRun(name: string, kind: FileKind, setup: Readonly<Setup>, ran: Run | null): boolean {
  const { program, machine, cell, machine_data, robots, controller } = setup;
  if ([program, machine, cell, machine_data, robots, controller].includes(name)) return name !== "";
  if (ran?.robots.some(({ files }) => files.includes(name)) || ran?.diagnostics.some(({ file }) => file === name)) return true;
  switch (kind) {
    case "program":
      return false; // one that is called has been run
    case "machine":
      return cell !== "" || robots !== "";
    case "other":
      return (machine !== "" || cell !== "" || robots !== "") && !NEVER_READ.test(name);
    default:
      return robots !== "" && !NEVER_READ.test(name);
  }
}
