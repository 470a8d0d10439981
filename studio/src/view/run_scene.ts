// Scene of a run, except the paths themselves.

import { AmbientLight, Box3, DirectionalLight, Group, Matrix4, Scene, Vector3 } from "three";
import type { Units } from "../core/store";
import type { SourceLocation } from "../run/report";
import type { Robot, Run } from "../run/run";
import { ContactHighlights } from "./contact_highlights";
import type { CameraRig } from "./camera";
import type { Frame } from "./frame";
import { BodyMaterials } from "./machine/body_materials";
import { Machine, type Instant } from "./machine/machine";
import { Directions } from "./marks/directions";
import { Envelope } from "./marks/envelope";
import { Extents } from "./marks/extents";
import { Grid } from "./marks/grid";
import { ApproximateTcps } from "./marks/approximate_tcps";
import { Measure } from "./marks/measure";
import { Zones } from "./marks/zones";
import { PathData } from "./path/path_data";
import type { Palette } from "./theme";

const DEFAULT_BOUNDS = new Box3(new Vector3(-100, -100, 0), new Vector3(100, 100, 0));

/** A shorter path, as of a run that ended before it began, is not worth showing. */
const MIN_WORK_SIZE_MM = 1;

export class RunScene {
  readonly scene = new Scene();
  readonly machineGroup = new Group();
  readonly grid = new Grid();
  readonly extents = new Extents();
  readonly measure = new Measure();
  readonly zones = new Zones();
  readonly envelope = new Envelope();
  readonly directions = new Directions();
  private readonly approximateTcps = new ApproximateTcps();
  machines: Machine[] = [];
  paths: PathData[] = [];
  alarms = new ContactHighlights(null);
  private readonly bodyMaterials = new BodyMaterials();
  private readonly directionalLight = new DirectionalLight(0xffffff, 2.2);
  private readonly known = new WeakMap<Robot, PathData>();

  constructor() {
    this.directionalLight.target.position.set(0, 0, 0);
    const parts = [this.machineGroup, this.grid.group, this.extents.lines, this.measure.lines, this.zones.group];
    this.scene.add(...parts, this.envelope.group, this.directions.group, this.approximateTcps.group);
    this.scene.add(new AmbientLight(0xffffff, 1.5), this.directionalLight, this.directionalLight.target);
    this.grid.layOut(DEFAULT_BOUNDS, "mm");
  }

  /** Returns the paths of a run's robots; made once for each. */
  pathsOf(run: Run | null): PathData[] {
    return (run?.robots ?? []).map((robot) => {
      const path = this.known.get(robot) ?? new PathData(robot.segments);
      this.known.set(robot, path);
      return path;
    });
  }

  setContent(run: Run | null, units: Units): void {
    for (const machine of this.machines) machine.dispose();
    this.machineGroup.clear();
    this.paths = this.pathsOf(run);
    this.machines = run?.robots.map((robot, i) => new Machine(robot, run.reportOf(i), this.bodyMaterials)) ?? [];
    for (const machine of this.machines) this.machineGroup.add(machine.group);
    this.alarms = new ContactHighlights(run);
    this.zones.setContent(run?.robots ?? [], (robot) => this.pathBox(robot));
    this.directions.setContent(this.paths);
    this.measure.clear();
    this.extents.setContent(this.pathBox(0));
    this.updateGrid(units);
  }

  updateGrid(units: Units): void {
    const box = this.pathBox(0);
    this.grid.layOut(box.isEmpty() ? DEFAULT_BOUNDS : box, units);
  }

  /** Returns the box of a robot's path in its work frame, without rapid moves if others exist. */
  pathBox(robot: number): Box3 {
    const path = this.paths[robot];
    if (!path) return new Box3();
    return path.cutBounds.isEmpty() ? path.bounds : path.cutBounds;
  }

  /** Returns the box to show for a view of the complete work, in the world. */
  workBox(works: Matrix4[]): Box3 {
    const box = new Box3();
    works.forEach((work, i) => {
      const path = this.pathBox(i);
      if (!path.isEmpty()) box.union(path.clone().applyMatrix4(work));
    });
    return box.getSize(new Vector3()).length() < MIN_WORK_SIZE_MM ? this.fullBox() : box;
  }

  fullBox(): Box3 {
    this.machineGroup.updateMatrixWorld(true);
    const box = new Box3().setFromObject(this.machineGroup);
    return box.isEmpty() ? DEFAULT_BOUNDS.clone() : box;
  }

  /** Places everything for an instant; `frame` is the work frame of the marks. */
  place(instants: Instant[], frame: Matrix4): void {
    this.machines.forEach((machine, i) => machine.place(instants[i]));
    for (const part of [this.grid.group, this.extents.lines, this.measure.lines]) part.matrix.copy(frame);
    this.directions.place(instants.map(({ linkPoses }) => linkPoses.work));
  }

  /** Shows only machines, only the contents of their cells, both, or neither. */
  show(of: { machine: boolean; cell: boolean }): void {
    for (const machine of this.machines) machine.show(of);
  }

  /** Marks TCPs on their paths, while the joints are not loaded. */
  markTcps({ instants }: Frame, mmPerPixelAt: (place: Vector3) => number): void {
    this.approximateTcps.put(instants.flatMap(({ isApproximate, tip_mm }) => (isApproximate ? tip_mm : [])), mmPerPixelAt);
  }

  /** Highlights bodies that have collided by now, or come near in the current lines. */
  light(t_s: number, lines: SourceLocation[]): void {
    const look = this.alarms.at(t_s, lines) ?? (() => undefined);
    for (const machine of this.machines) machine.bodies.light(look);
  }

  /** Moves the light with the camera. */
  follow(rig: Pick<CameraRig, "basis">): void {
    const { back, right, up } = rig.basis();
    this.directionalLight.position.copy(back).addScaledVector(up, 0.6).addScaledVector(right, -0.4).multiplyScalar(1000);
  }

  recolour(colours: Palette): void {
    this.bodyMaterials.recolour(colours);
    const parts = [this.grid, this.extents, this.measure, this.zones, this.envelope, this.directions, this.approximateTcps];
    for (const part of parts) part.recolour(colours);
  }
}
