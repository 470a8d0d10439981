// Drawing of a manual path: its motions as lines and arcs with arrows, its points as dots.

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Points,
  PointsMaterial,
  Vector3,
  type Matrix4,
} from "three";
import type { DisplayedPath } from "../../core/displayed_path";
import { arcPoint, sampleArc } from "../../run/path/path_arc";
import { isPoint, type TargetId } from "../../run/path/path_file";
import type { Motion } from "../../run/path/path_traversal";
import { between, distance, subtract, type Vector } from "../../run/path/vector";
import type { CameraRig } from "../camera";
import { addArrow } from "../marks/directions";
import { setLines } from "../marks/grid";
import type { Palette } from "../theme";

const CHORD_MM = 0.01;
const DOT_PX = 7;
const DASH_PX = 6;
const ARROW_PX = 10;
/** Shorter motions have no arrow. */
const MIN_ARROW_DISTANCE_PX = 28;
const MAX_ARROWS = 400;

interface Dot {
  place: TargetId;
  at: Vector3;
}

/** Creates round dots; points are squares by default. */
function roundDots(size_px: number): PointsMaterial {
  const material = new PointsMaterial({ size: size_px, sizeAttenuation: false, depthTest: false, transparent: true });
  material.onBeforeCompile = (shader) => {
    const round = "#include <map_particle_fragment>\n if (length(gl_PointCoord - 0.5) > 0.5) discard;";
    shader.fragmentShader = shader.fragmentShader.replace("#include <map_particle_fragment>", round);
  };
  return material;
}

/** Adds pairs of ends of the lines that draw a motion. */
function addMotion({ from_mm, to_mm, arc }: Motion, into: number[]): void {
  let at = from_mm!;
  for (const next of arc ? sampleArc(arc, CHORD_MM) : [to_mm]) {
    into.push(...at, ...next);
    at = next;
  }
}

export class PathMarks {
  readonly group = new Group();
  dots: Dot[] = [];
  private motions: Motion[] = [];
  private readonly cuts = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ depthTest: false }));
  private readonly rapids = new LineSegments(
    new BufferGeometry(),
    new LineDashedMaterial({ depthTest: false, dashSize: DASH_PX, gapSize: DASH_PX }),
  );
  private readonly points = new Points(new BufferGeometry(), roundDots(DOT_PX));
  private readonly arrows = new Mesh(new BufferGeometry(), new MeshBasicMaterial({ depthTest: false, side: DoubleSide }));

  constructor() {
    this.group.matrixAutoUpdate = false;
    for (const part of [this.cuts, this.rapids, this.arrows, this.points]) {
      part.frustumCulled = false;
      this.group.add(part);
    }
    // Dots are drawn over lines.
    this.points.renderOrder = 1;
  }

  setContent(displayed: DisplayedPath | null): void {
    this.motions = displayed?.walk.motions.filter(({ from_mm }) => from_mm !== null) ?? [];
    const ends: Record<"cut" | "rapid", number[]> = { cut: [], rapid: [] };
    for (const motion of this.motions) addMotion(motion, motion.rapid ? ends.rapid : ends.cut);
    setLines(this.cuts, ends.cut);
    setLines(this.rapids, ends.rapid);
    this.rapids.computeLineDistances();
    this.dots = pathDots(displayed);
    this.points.geometry.dispose();
    const places = new Float32Array(this.dots.flatMap(({ at }) => at.toArray()));
    this.points.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(places, 3));
  }

  recolour(colours: Palette): void {
    for (const { material } of [this.cuts, this.rapids, this.points, this.arrows]) material.color.copy(colours.editedPath);
  }

  /** Places it for the frame of the path. */
  place(work: Matrix4, rig: CameraRig): void {
    this.group.matrix.copy(work);
    this.rapids.material.scale = 1 / rig.mmPerPixel;
  }

  /** Updates the arrows for the current view. */
  layOut(work: Matrix4, rig: CameraRig): void {
    const back = rig.basis().back.transformDirection(work.clone().invert());
    const corners: number[] = [];
    const world = new Vector3();
    let count = 0;
    for (const motion of this.motions) {
      const [at, along] = motionMiddle(motion);
      const mmPerPixel = rig.mmPerPixelAt(world.set(...at).applyMatrix4(work));
      if (distance(motion.from_mm!, motion.to_mm) < MIN_ARROW_DISTANCE_PX * mmPerPixel && !motion.arc) continue;
      if (++count > MAX_ARROWS) break;
      addArrow(corners, new Vector3(...at), new Vector3(...along).normalize(), ARROW_PX * mmPerPixel, back);
    }
    this.arrows.geometry.dispose();
    this.arrows.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(corners), 3));
  }

  /** Returns points within some pixels of a position on the screen, the nearest first. */
  near(x_px: number, y_px: number, hitRadius_px: number, work: Matrix4, rig: CameraRig): Dot[] {
    const world = new Vector3();
    const found: { dot: Dot; distance_px: number }[] = [];
    for (const dot of this.dots) {
      const projected = rig.project(world.copy(dot.at).applyMatrix4(work));
      const distance_px = projected ? Math.hypot(projected.x - x_px, projected.y - y_px) : Infinity;
      if (distance_px <= hitRadius_px) found.push({ dot, distance_px });
    }
    // Points at one position keep their order.
    return found.sort((a, b) => Math.round(a.distance_px - b.distance_px)).map(({ dot }) => dot);
  }
}

function motionMiddle({ from_mm, to_mm, arc }: Motion): [at: Vector, along: Vector] {
  if (!arc) return [between(from_mm!, to_mm, 0.5), subtract(to_mm, from_mm!)];
  return [arcPoint(arc, 0.5), subtract(arcPoint(arc, 0.501), arcPoint(arc, 0.499))];
}

const pathDots = (displayed: DisplayedPath | null): Dot[] =>
  displayed?.file.paths.flatMap(({ targets }, path) =>
    targets.flatMap((each, target) =>
      isPoint(each) ? [{ place: { path, target }, at: new Vector3(...each.position_mm) }] : [],
    ),
  ) ?? [];
