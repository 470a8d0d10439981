// Bodies that have collided by an instant, and those that come near to each other in the current line.

import { Vector3 } from "three";
import { matrixOf } from "../run/chain";
import type { Clearance, Collision, SourceLocation, LocatedEntry, Report } from "../run/report";
import type { Run } from "../run/run";
import type { Role } from "./machine/body_materials";
import type { Label } from "./marks/labels";

const MAX_MARKS = 8;

const robotReports = (run: Run | null): Report[] => (run?.report ? [run.report, ...(run.report.robots ?? [])] : []);

/** Returns points in the world of all robots; in a robot's report they are in its machine's own world. */
function contactPoints(run: Run | null): Map<Collision | Clearance, Vector3> {
  const points = new Map<Collision | Clearance, Vector3>();
  run?.report?.robots?.forEach((report, i) => {
    const base = matrixOf(run.robots[i].scene.base);
    for (const place of [...(report.collisions ?? []), ...(report.clearances ?? [])]) {
      points.set(place, new Vector3(...place.point_mm).applyMatrix4(base));
    }
  });
  return points;
}

const lineKey = ({ file, line }: LocatedEntry): string => `${file}\n${line}`;

export class ContactHighlights {
  private readonly collisions: Collision[];
  private readonly near = new Map<string, Clearance[]>();
  private readonly points: Map<Collision | Clearance, Vector3>;
  private contactBodies = new Set<string>();
  private passedContactCount = 0;

  constructor(run: Run | null) {
    const reports = robotReports(run);
    this.points = contactPoints(run);
    this.collisions = reports.flatMap((report) => report.collisions ?? []).sort((a, b) => a.t_s - b.t_s);
    for (const clearance of reports.flatMap((report) => report.clearances ?? [])) {
      const key = lineKey(clearance);
      this.near.set(key, [...(this.near.get(key) ?? []), clearance]);
    }
  }

  /** Returns the highlight of bodies at a time, during the given lines; null: none. */
  at(t_s: number, lines: SourceLocation[]): ((name: string) => Role | undefined) | null {
    this.goTo(t_s);
    const near = new Set(this.clearancesAtLines(lines).flatMap(({ pair }) => pair));
    if (this.contactBodies.size === 0 && near.size === 0) return null;
    return (name) => (this.contactBodies.has(name) ? "hit" : near.has(name) ? "near" : undefined);
  }

  private clearancesAtLines(lines: SourceLocation[]): Clearance[] {
    return lines.flatMap((place) => this.near.get(lineKey(place)) ?? []);
  }

  private goTo(t_s: number): void {
    const after = this.collisions.findIndex((collision) => collision.t_s > t_s);
    const count = after < 0 ? this.collisions.length : after;
    if (count === this.passedContactCount) return;
    this.passedContactCount = count;
    this.contactBodies = new Set(this.collisions.slice(0, count).flatMap(({ pair }) => pair));
  }

  /** Returns labels at the last collisions, and at near passes. */
  labels(lines: SourceLocation[]): Label[] {
    const met = this.collisions.slice(Math.max(0, this.passedContactCount - MAX_MARKS), this.passedContactCount);
    const mark = (kind: string) => (place: Collision | Clearance) => {
      return { at: this.points.get(place) ?? new Vector3(...place.point_mm), text: "", kind };
    };
    return [...this.clearancesAtLines(lines).map(mark("near")), ...met.map(mark("hit"))];
  }
}
