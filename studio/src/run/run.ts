// Run as the page has it: the messages of the engine, robot by robot.

import type { Message } from "../core/message";
import { Blocks } from "./blocks";
import { Chain, axisValue, jointValue } from "./chain";
import { ChunkCache, type FetchLaws } from "./chunk_cache";
import { SAME_TIME_S, type Clearance, type SourceLocation, type Report, type ReportEvent, type Severity } from "./report";
import type { Scene } from "./scene";
import { lastIndex } from "./search";
import { Segments } from "./segments";
import { Series, type SeriesKind } from "./series";

/** One machine of a run. */
export class Robot {
  readonly segments: Segments;
  readonly blocks: Blocks;
  /** Values over time in addition to the segments, if the machine has masses or servo loops. */
  readonly series = new Map<SeriesKind, Series>();
  chain: Chain;
  /** Names of sources, in the numbering of segments. */
  files: string[] = [];

  constructor(
    readonly name: string,
    public scene: Scene,
    /** Meshes of bodies: nine coordinates (mm) for a triangle. */
    readonly meshes: Float32Array[],
    laws: ChunkCache | null = null,
  ) {
    this.segments = new Segments(scene.axes.length, scene.position_joints, laws);
    this.blocks = new Blocks(this.segments);
    this.chain = new Chain(scene);
  }

  refresh(scene: Scene, files: string[]): void {
    this.scene = scene;
    this.files = files;
    this.chain = new Chain(scene);
  }

  /** Of its axes. */
  get letters(): string[] {
    return this.scene.axes.map((axis) => axis.letter);
  }

  /** Returns joints in mm and rad at a time; at home if nothing has moved; null: not loaded yet. */
  joints_at(t_s: number): ArrayLike<number> | null {
    const { segments } = this;
    const state = segments.joints_at(t_s);
    if (state) return state.position;
    return segments.count > 0 ? null : this.home;
  }

  get home(): number[] {
    return this.scene.axes.map((axis) => jointValue(axis, axis.home));
  }

  /** Returns the TCP in use at a time, by its number in the scene; null: not loaded yet. */
  tcp_at(t_s: number): number | null {
    const segment = this.segments.at(t_s);
    return segment >= 0 ? (this.segments.info(segment)?.tip ?? null) : 0;
  }

  /** Returns the values of the axes in mm and deg; null: not loaded yet. */
  axes_at(t_s: number): number[] | null {
    const joints = this.joints_at(t_s);
    return joints && this.scene.axes.map((axis, i) => axisValue(axis, joints[i]));
  }
}

export interface EngineDiagnostic {
  severity: Severity;
  code: string;
  file: string;
  line: number;
  column: number;
  end_column: number;
  text: string;
  hint: string;
}

/** Sets the times of clearances, which reports do not have because each needs a search. */
function addClearanceTimes(clearances: Clearance[] = [], near_s: (number | null)[] = []): void {
  clearances.forEach((clearance, i) => (clearance.t_s = near_s[i] ?? undefined));
}

export class Run {
  readonly robots: Robot[] = [];
  readonly diagnostics: EngineDiagnostic[] = [];
  report: Report | null = null;
  reportText = "";
  /** Reason why it was not run. */
  error: { code: string; message: string } | null = null;
  /** Events of each robot in the order of time. */
  private readonly events = new Map<number, ReportEvent[]>();
  /** Loader of missing parts, for a run that may be too long for the page. */
  readonly laws: ChunkCache | null;
  /** Number of messages of segments received. */
  private parts = 0;

  constructor(
    /** Sources at the time of the run, by name. */
    readonly sources: Map<string, string> = new Map(),
    fetchLaws: FetchLaws | null = null,
    /** Name under which the engine keeps it; empty: it does not. */
    readonly storageKey = "",
  ) {
    this.laws = fetchLaws && new ChunkCache(fetchLaws);
  }

  /** True if not all of it is loaded. */
  get isLong(): boolean {
    return this.robots.some(({ segments }) => segments.isLong);
  }

  /** Fetches the data shown at a time; `ahead`: also those after it. */
  prefetch(t_s: number, ahead = false): void {
    if (!this.isLong) return;
    const all = this.robots.map(({ segments }) => segments);
    const now = all.flatMap((segments) => segments.missingSection(t_s) ?? []);
    const next = all.flatMap((segments) => segments.missingSection(segments.sectionAt(t_s)?.end_s ?? 0) ?? []);
    this.laws?.prefetch(ahead ? [...now, ...next] : now);
  }

  get end_s(): number {
    return Math.max(this.report?.cycle_time_s ?? 0, ...this.robots.map((robot) => robot.segments.end_s));
  }

  /** Processes a message of the engine. */
  addMessage(message: Message): void {
    const { header, columns } = message;
    const robot = this.robots[header.robot as number];
    switch (message.is) {
      case "scene": {
        const scene = header.scene as Scene;
        const files = header.files as string[];
        if (robot) return robot.refresh(scene, files);
        const meshes: Float32Array[] = [];
        for (let i = 0; columns.has(`mesh${i}`); ++i) meshes.push(columns.get(`mesh${i}`) as Float32Array);
        const added = new Robot(header.name as string, scene, meshes, this.laws);
        added.files = files;
        this.robots.push(added);
        return;
      }
      case "segments": {
        robot.segments.add(message, this.parts++);
        const chunk = robot.segments.chunks.at(-1);
        if (chunk && chunk.first === header.first && !header.lean) robot.blocks.add(chunk);
        return;
      }
      case "efforts":
      case "following":
        robot.series.set(message.is, new Series(message));
        return;
      case "diagnostic":
        this.diagnostics.push(header as unknown as EngineDiagnostic);
        return;
      case "report":
        this.report = header.report as Report;
        this.robots.forEach((each, i) => addClearanceTimes(this.reportOf(i)?.clearances, each.scene.near_s));
        this.events.clear();
        this.reportText = header.text as string;
        return;
      case "failed":
        this.error = header as unknown as { code: string; message: string };
        return;
    }
  }

  /** Returns a robot's own report; that of the run if it is the only robot. */
  reportOf(robot: number): Report | null {
    return this.report?.robots?.[robot] ?? this.report;
  }

  /**
   * Returns the active lines at a time: those of events at that instant, which occur between moves, else that
   * of the active segment; none if the robot is done.
   */
  locationsAt(robot: number, t_s: number): SourceLocation[] {
    if (!this.robots[robot]) return [];
    const places = this.eventsAt(robot, t_s).flatMap(({ file, line }) =>
      file !== null && line !== null ? [{ file, line }] : [],
    );
    const moving = places.length === 0 ? this.locationOfMotion(robot, t_s) : null;
    return moving ? [moving] : places;
  }

  /**
   * Returns the line of the segment active at a time; null: the robot is done, has not moved at all, or the
   * data is not loaded.
   */
  locationOfMotion(robot: number, t_s: number): SourceLocation | null {
    const { segments, files } = this.robots[robot] ?? {};
    if (!segments || segments.count === 0 || t_s > segments.end_s + SAME_TIME_S) return null;
    const at = segments.lineAt(t_s);
    return at && { file: files[at.file], line: at.line };
  }

  private eventsAt(robot: number, t_s: number): ReportEvent[] {
    const all = this.events.get(robot) ?? [...(this.reportOf(robot)?.events ?? [])].sort((a, b) => a.t_s - b.t_s);
    this.events.set(robot, all);
    const end = lastIndex(all.length, (i) => all[i].t_s <= t_s + SAME_TIME_S) + 1;
    let first = end;
    while (first > 0 && all[first - 1].t_s >= t_s - SAME_TIME_S) --first;
    return all.slice(first, end);
  }

  /** Returns the index of a source in a robot's list; -1: it has not run. */
  fileOf(robot: number, name: string): number {
    return this.robots[robot]?.files.indexOf(name) ?? -1;
  }
}
