// A run as the page has it: what the engine told of it, robot by robot.

import type { Message } from "../core/message";
import { Blocks } from "./blocks";
import { Chain, axisValue, jointValue } from "./chain";
import { SAME_TIME_S, type Clearance, type Place, type Report, type ReportEvent, type Severity } from "./report";
import type { Scene } from "./scene";
import { lastIndex } from "./search";
import { Segments } from "./segments";

/** One machine of a run. */
export class Robot {
  readonly segments: Segments;
  readonly blocks: Blocks;
  chain: Chain;
  /** Names of sources, as segments count them. */
  files: string[] = [];

  constructor(
    readonly name: string,
    public scene: Scene,
    /** Of bodies that are surfaces: nine coordinates (mm) for a triangle. */
    readonly meshes: Float32Array[],
  ) {
    this.segments = new Segments(scene.axes.length, scene.position_joints);
    this.blocks = new Blocks(this.segments);
    this.chain = new Chain(scene);
  }

  renew(scene: Scene, files: string[]): void {
    this.scene = scene;
    this.files = files;
    this.chain = new Chain(scene);
  }

  /** Of its axes. */
  get letters(): string[] {
    return this.scene.axes.map((axis) => axis.letter);
  }

  /** Joints in mm and rad at a time; at home where nothing has moved. */
  joints_at(t_s: number): ArrayLike<number> {
    const state = this.segments.joints_at(t_s);
    if (state) return state.position;
    return this.scene.axes.map((axis) => jointValue(axis, axis.home));
  }

  /** Values of the axes in mm and deg. */
  axes_at(t_s: number): number[] {
    const joints = this.joints_at(t_s);
    return this.scene.axes.map((axis, i) => axisValue(axis, joints[i]));
  }
}

export interface Told {
  severity: Severity;
  code: string;
  file: string;
  line: number;
  column: number;
  end_column: number;
  text: string;
  hint: string;
}

/** Times of clearances, which reports do not have, since each takes a search. */
function tellWhen(clearances: Clearance[] = [], near_s: (number | null)[] = []): void {
  clearances.forEach((clearance, i) => (clearance.t_s = near_s[i] ?? undefined));
}

export class Run {
  readonly robots: Robot[] = [];
  readonly told: Told[] = [];
  report: Report | null = null;
  reportText = "";
  /** Why it was not run. */
  failure: { code: string; message: string } | null = null;
  /** Of each robot its events in the order of time. */
  private readonly events = new Map<number, ReportEvent[]>();
  /** The sources as they were when it ran, by name. */
  readonly sources: Map<string, string>;

  constructor(sources: Map<string, string> = new Map()) {
    this.sources = sources;
  }

  get end_s(): number {
    return Math.max(this.report?.cycle_time_s ?? 0, ...this.robots.map((robot) => robot.segments.end_s));
  }

  /** Takes what the engine tells. */
  take(message: Message): void {
    const { header, columns } = message;
    const robot = this.robots[header.robot as number];
    switch (message.is) {
      case "scene": {
        const scene = header.scene as Scene;
        const files = header.files as string[];
        if (robot) return robot.renew(scene, files);
        const meshes: Float32Array[] = [];
        for (let i = 0; columns.has(`mesh${i}`); ++i) meshes.push(columns.get(`mesh${i}`) as Float32Array);
        const added = new Robot(header.name as string, scene, meshes);
        added.files = files;
        this.robots.push(added);
        return;
      }
      case "segments": {
        robot.segments.add(message);
        robot.blocks.add(robot.segments.chunks[robot.segments.chunks.length - 1]);
        return;
      }
      case "told":
        this.told.push(header as unknown as Told);
        return;
      case "report":
        this.report = header.report as Report;
        this.robots.forEach((each, i) => tellWhen(this.reportOf(i)?.clearances, each.scene.near_s));
        this.events.clear();
        this.reportText = header.text as string;
        return;
      case "failed":
        this.failure = header as unknown as { code: string; message: string };
        return;
    }
  }

  /** A robot's own report; of the only one that of the run. */
  reportOf(robot: number): Report | null {
    return this.report?.robots?.[robot] ?? this.report;
  }

  /**
   * The lines that are at work at a time: those of events at that instant, which stand between moves, else that of the
   * segment under way; none where the robot is done.
   */
  placesAt(robot: number, t_s: number): Place[] {
    if (!this.robots[robot]) return [];
    const places = this.eventsAt(robot, t_s).flatMap(({ file, line }) =>
      file !== null && line !== null ? [{ file, line }] : [],
    );
    const moving = places.length === 0 ? this.placeOfMotion(robot, t_s) : null;
    return moving ? [moving] : places;
  }

  /** The line of the segment under way at a time; null: the robot is done, or has not moved at all. */
  placeOfMotion(robot: number, t_s: number): Place | null {
    const { segments, files } = this.robots[robot] ?? {};
    if (!segments || segments.count === 0 || t_s > segments.end_s + SAME_TIME_S) return null;
    const [chunk, i] = segments.locate(segments.at(t_s));
    return { file: files[chunk.file[i]], line: chunk.line[i] };
  }

  private eventsAt(robot: number, t_s: number): ReportEvent[] {
    const all = this.events.get(robot) ?? [...(this.reportOf(robot)?.events ?? [])].sort((a, b) => a.t_s - b.t_s);
    this.events.set(robot, all);
    const end = lastIndex(all.length, (i) => all[i].t_s <= t_s + SAME_TIME_S) + 1;
    let first = end;
    while (first > 0 && all[first - 1].t_s >= t_s - SAME_TIME_S) --first;
    return all.slice(first, end);
  }

  /** The index of a source in a robot's list; -1: it has not run. */
  fileOf(robot: number, name: string): number {
    return this.robots[robot]?.files.indexOf(name) ?? -1;
  }
}
