// View: draws a frame when something has changed, and sleeps otherwise.

import { Box3, Matrix4, Scene, Vector3 } from "three";
import { Debounced } from "../core/debounced";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import { onTheme } from "../core/theme";
import type { SourceLocation } from "../run/report";
import type { Run } from "../run/run";
import { CameraRig, type StandardView } from "./camera";
import { Canvas } from "./canvas";
import { selectedRanges, blockRange, type Range } from "./selected_ranges";
import type { Frame } from "./frame";
import type { CreateDraggables, Draggable } from "./draggables";
import type { ViewLayers } from "./layers";
import { Legend } from "./legend";
import { Labels } from "./marks/labels";
import { Triad } from "./marks/triad";
import { legendKey } from "./path/path_colours";
import { PathLayer, type Hit, type FrameAppearance } from "./path/path_layer";
import { lastDoneVertex } from "./picking";
import { RunScene } from "./run_scene";
import { isDark, palette, toRgb } from "./theme";

const IDLE_MS = 150;
const REMAINING_OPACITY = { dark: 0.34, light: 0.28 };
const WHITE_SHARE = { dark: 0.2, light: 0 };

export class View {
  readonly rig = new CameraRig();
  readonly runScene = new RunScene();
  readonly labels = new Labels();
  readonly triad = new Triad();
  readonly legend: Legend;
  readonly own: ViewLayers = { machine: true, cell: true, grid: true, extents: false };
  readonly draggables: Draggable[];
  layer: PathLayer;
  private colours = palette();
  private chosen: Range[][] = [];
  private frame: Frame | null = null;
  private asked = 0;
  /** True while a headset draws, and the page's picture is paused. */
  private isRendererLent = false;
  /** Called for each move of the camera. */
  readonly cameraListeners = new Set<() => void>();
  private readonly idleTimer = new Debounced(() => this.placeDirections());
  private tip: Vector3 | null = null;
  /** Run in progress that is partly shown. */
  private taken: Run | null = null;
  /** Diagonal of the work at the last fit. */
  private fittedSize_mm = 0;

  constructor(
    readonly canvas: Canvas,
    private readonly store: Store,
    session: Session,
    createDraggables: CreateDraggables,
  ) {
    this.layer = new PathLayer(canvas.gl);
    this.legend = new Legend(store);
    const { runScene, rig } = this;
    this.draggables = createDraggables({
      ...{ store, session, runScene, rig, size: canvas },
      changed: () => this.invalidate(),
      moved: () => this.turned(),
      onOutOfView: () => this.fit(false),
    });
    this.recolour();
    onTheme(() => this.recolour());
    store.watch(["run", "partialRun"], () => this.updateRun());
    store.watch(["colour", "units"], () => this.explain());
    store.watch(["compare"], () => this.updatePaths());
    store.watch(["selection", "robot"], () => this.choose());
    store.watch(["perspective"], () => {
      this.rig.perspective = store.get("perspective");
      this.turned();
    });
    store.watch(["follow"], () => (this.tip = null));
    store.watch(["showRapids", "showDirections"], () => this.turned());
    for (const key of ["time_s", "playing", "showZones", "follow", "jog", "loadCount"] as const) store.on(key, () => this.invalidate());
  }

  /** A frame is drawn soon. */
  invalidate(): void {
    this.asked ||= requestAnimationFrame(() => {
      this.asked = 0;
      this.draw();
    });
  }

  /** Called after a move of the camera; at standstill, marks are updated for the view. */
  turned(): void {
    this.idleTimer.after(IDLE_MS);
    this.invalidate();
    for (const listener of this.cameraListeners) listener();
  }

  onResized(): void {
    this.rig.resize(this.canvas.width_px, this.canvas.height_px);
    if (this.runScene.paths.length === 0) this.fit(false);
    // A canvas of another size is empty until it is drawn.
    this.draw();
    this.idleTimer.after(IDLE_MS);
  }

  /** Lends renderer and scene to another picture, until reclaimRenderer(). */
  lendRenderer(): void {
    this.isRendererLent = true;
  }

  /** Draws the page's picture as before. */
  reclaimRenderer(): void {
    this.isRendererLent = false;
    this.canvas.fill();
    this.rig.resize(this.canvas.width_px, this.canvas.height_px);
    this.draw();
    this.turned();
  }

  restored(): void {
    this.layer = new PathLayer(this.canvas.gl);
    this.updatePaths();
  }

  private recolour(): void {
    this.colours = palette();
    this.runScene.recolour(this.colours);
    for (const hold of this.draggables) hold.recolour(this.colours);
    this.canvas.renderer.setClearColor(this.colours.background);
    this.layer.refresh();
    this.invalidate();
  }

  /** Returns the shown run; a long one is shown before its end, as far as it is loaded. */
  private get run() {
    return this.store.get("partialRun")?.run ?? this.store.get("run");
  }

  private updateRun(): void {
    const { run } = this;
    const isGrowing = this.store.get("partialRun") !== null;
    if (isGrowing && run === this.taken) return this.grow();
    this.taken = isGrowing ? run : null;
    const before = this.runScene.paths.length > 0;
    this.runScene.setContent(this.run, this.store.get("units"));
    this.tip = null;
    this.updatePaths();
    this.choose();
    this.updateVisibleBounds();
    if (!before || !this.isWorkVisible()) this.fit(false);
    this.turned();
  }

  /** Adds new data of the shown run. */
  private grow(): void {
    for (const path of this.runScene.paths) path.grow();
    const key = this.key();
    if (key) this.layer.grow(key);
    this.legend.show(key, this.runScene.grid.step_mm);
    this.updateVisibleBounds();
    if (!this.isWorkVisible()) this.fit(false);
    this.turned();
  }

  private key() {
    const segments = this.runScene.paths.map((path) => path.segments);
    return segments.length > 0 ? legendKey(this.store.get("colour"), segments) : null;
  }

  private updatePaths(): void {
    const previous = this.store.get("compare") ? this.runScene.pathsOf(this.store.get("previous")) : [];
    const key = this.key() ?? legendKey(this.store.get("colour"), []);
    this.layer.setContent(this.runScene.paths, previous, key);
    this.legend.show(this.key(), this.runScene.grid.step_mm);
    this.invalidate();
  }

  private explain(): void {
    const key = this.key();
    if (key) this.layer.colour(key);
    this.runScene.updateGrid(this.store.get("units"));
    this.legend.show(key, this.runScene.grid.step_mm);
    this.invalidate();
  }

  private choose(): void {
    const { run, store } = this;
    const state = { selection: store.get("selection"), robot: store.get("robot") };
    this.chosen = run ? this.runScene.paths.map((data, i) => selectedRanges(run, i, data, state)) : [];
    this.bringToSight();
    this.invalidate();
  }

  /** Centres a selection that is outside the screen. */
  private bringToSight(): void {
    const robot = this.chosen.findIndex((ranges) => ranges.length > 0);
    if (robot < 0 || !this.frame) return;
    const [from, to] = this.chosen[robot][0];
    if (to <= from) return;
    const work = this.frame.instants[robot]?.linkPoses.work ?? new Matrix4();
    const place = this.runScene.paths[robot].point((from + to - 1) >> 1).applyMatrix4(work);
    const viewed = this.rig.project(place);
    const { width_px, height_px } = this.canvas;
    if (viewed && viewed.x > 0 && viewed.y > 0 && viewed.x < width_px && viewed.y < height_px) return;
    this.rig.target.copy(place);
    this.turned();
  }

  /** True if the work is on the screen, and about as large as at the last fit. */
  private isWorkVisible(): boolean {
    const box = this.runScene.workBox(this.works());
    const growth = box.getSize(new Vector3()).length() / this.fittedSize_mm;
    const viewed = this.rig.project(box.getCenter(new Vector3()));
    if (!viewed || growth > 2 || growth < 0.5) return false;
    return viewed.x > 0 && viewed.y > 0 && viewed.x < this.canvas.width_px && viewed.y < this.canvas.height_px;
  }

  private works(): Matrix4[] {
    return this.frame?.instants.map(({ linkPoses }) => linkPoses.work) ?? [];
  }

  /** Shows the complete path; `all`: also the machine. */
  fit(all: boolean): void {
    this.updateVisibleBounds();
    this.rig.resize(this.canvas.width_px, this.canvas.height_px);
    const work = this.runScene.workBox(this.works());
    const frame = this.place().work;
    for (const hold of this.draggables) work.union(hold.box?.(frame) ?? new Box3());
    this.rig.fit(all ? this.runScene.fullBox() : work);
    this.fittedSize_mm = work.getSize(new Vector3()).length();
    this.turned();
  }

  /** In pixels of the window. */
  screenOf(point_mm: [number, number, number]): [number, number] {
    const { work } = this.place();
    const { x, y } = new Vector3(...point_mm).applyMatrix4(work).project(this.rig.camera);
    const { left, top, width, height } = this.canvas.element.getBoundingClientRect();
    return [left + (width * (x + 1)) / 2, top + (height * (1 - y)) / 2];
  }

  setStandardView(name: StandardView): void {
    this.rig.setStandardView(name);
    this.fit(false);
  }

  /** Places everything for the shown instant. */
  private place(): Frame {
    const t_s = this.taken ? 0 : this.store.get("time_s");
    const robot = this.store.get("robot");
    const jog = this.store.get("jog");
    const instants = this.runScene.machines.map((machine, i) => {
      const isJogged = i === robot && jog?.length === machine.robot.scene.axes.length;
      return machine.at(t_s, isJogged ? jog : null);
    });
    const work = instants[robot]?.linkPoses.work ?? new Matrix4();
    this.frame = { t_s, instants, work };
    this.runScene.place(instants, work);
    return this.frame;
  }

  /** As place(), and sets the depth range of the camera. */
  private updateVisibleBounds(): void {
    this.place();
    const { runScene } = this;
    if (runScene.machines.length === 0) return;
    const viewed = runScene.fullBox().union(runScene.workBox(this.works()));
    this.rig.setVisibleBounds(viewed.expandByScalar(0.5 * viewed.getSize(new Vector3()).length()));
  }

  private update(): Frame {
    const { runScene, own, store } = this;
    const frame = this.place();
    runScene.light(frame.t_s, this.activeLines(frame));
    runScene.show(own);
    runScene.grid.group.visible = own.grid;
    runScene.extents.lines.visible = own.extents;
    runScene.zones.group.visible = store.get("showZones");
    runScene.directions.group.visible = store.get("showDirections");
    this.followTool(frame);
    return frame;
  }

  private activeLines({ t_s, instants }: Frame): SourceLocation[] {
    return instants.flatMap((_, i) => this.run?.locationsAt(i, t_s) ?? []);
  }

  private followTool({ instants }: Frame): void {
    const tip = this.store.get("follow") ? instants[this.store.get("robot")]?.tip_mm : undefined;
    if (tip) this.rig.target.add(this.tip ? tip.clone().sub(this.tip) : tip.clone().sub(this.rig.target));
    this.tip = tip?.clone() ?? null;
  }

  private look({ t_s, instants }: Frame): FrameAppearance {
    const { camera } = this.rig;
    const viewed = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse);
    const theme = isDark() ? "dark" : "light";
    const end_s = this.run?.end_s ?? 0;
    // Before the start and after the end the path is shown undimmed, and also while joints are moved by hand.
    const whole = this.taken !== null || this.store.get("jog") !== null || t_s >= end_s || (t_s <= 0 && !this.store.get("playing"));
    return {
      ...this.canvas.drawn,
      matrices: instants.map(({ linkPoses }) => viewed.clone().multiply(linkPoses.work)),
      pixelRatio: this.canvas.pixelRatio,
      mmPerPixel: this.rig.mmPerPixel / this.canvas.pixelRatio,
      rapids: this.store.get("showRapids"),
      compare: this.store.get("compare"),
      compareColour: toRgb(this.colours.compare),
      now_s: instants.map(({ linkPoses, tip_mm }, i) =>
        whole ? Infinity : lastDoneVertex(this.runScene.paths[i], t_s, tip_mm.clone().applyMatrix4(linkPoses.work.clone().invert())),
      ),
      dimmed: REMAINING_OPACITY[theme],
      lightened: WHITE_SHARE[theme],
    };
  }

  /** Places everything for the shown instant, and returns the look of the paths. */
  arrange(): FrameAppearance {
    return this.look(this.update());
  }

  private draw(): void {
    if (this.isRendererLent || this.canvas.gl.isContextLost()) return;
    const { renderer } = this.canvas;
    const frame = this.update();
    this.rig.apply();
    this.runScene.follow(this.rig);
    this.runScene.markTcps(frame, (place) => this.rig.mmPerPixelAt(place));
    const look = this.look(frame);
    const more = this.layer.prepare(look, performance.now());
    renderer.resetState();
    renderer.setRenderTarget(null);
    renderer.clear();
    renderer.render(this.runScene.scene, this.rig.camera);
    // Dimmed parts show the background, so that is drawn first.
    this.layer.compose(look);
    this.drawHighlights(frame, look);
    for (const hold of this.draggables) hold.draw(renderer, frame.work);
    this.annotate(frame);
    if (more === "now") this.invalidate();
    else if (more === "at rest") setTimeout(() => this.invalidate(), IDLE_MS);
  }

  private drawHighlights({ instants }: Frame, look: FrameAppearance): void {
    const { runScene, layer, colours } = this;
    instants.forEach(({ segment }, robot) => {
      if (segment >= 0 && look.now_s[robot] !== Infinity) {
        const known = runScene.machines[robot].robot;
        const ranges = [blockRange(known, runScene.paths[robot], known.blocks.of(segment))];
        layer.drawHighlight({ robot, ranges, colour: toRgb(colours.progressColour), width_px: 7, opacity: 0.2 }, look);
      }
      const ranges = this.chosen[robot] ?? [];
      layer.drawHighlight({ robot, ranges, colour: toRgb(colours.selected), width_px: 4, opacity: 1 }, look);
    });
  }

  private annotate(frame: Frame): void {
    const units = this.store.get("units");
    const { runScene, rig } = this;
    this.triad.turn(rig.basis());
    const marks = runScene.alarms.labels(this.activeLines(frame));
    const measured = runScene.measure.labels(units, frame.work);
    this.labels.show([...marks, ...runScene.extents.labels(units, frame.work), ...measured], rig);
  }

  private placeDirections(): void {
    this.rig.apply();
    for (const hold of this.draggables) hold.layOut?.();
    this.invalidate();
    if (!this.store.get("showDirections") || this.runScene.paths.length === 0) return;
    const { runScene, rig, canvas } = this;
    runScene.directions.layOut(runScene.paths, this.works(), rig, canvas, this.store.get("showRapids"));
  }

  /** Returns the path at a position, px from the left and from above. */
  hit(x_px: number, y_px: number, hitRadius_px: number): Hit | null {
    if (this.taken) return null; // its instants and lines are not shown yet
    const { width_px, height_px, pixelRatio } = this.canvas;
    return this.layer.hit(x_px / width_px, 1 - y_px / height_px, Math.round(hitRadius_px * pixelRatio));
  }

  get displayed(): Frame | null {
    return this.frame;
  }

  /** Returns the time until a frame is drawn: at standstill, in an orbit of the camera, or empty. */
  measureFrame_ms(kind: "rest" | "orbit" | "empty"): number {
    const begun_ms = performance.now();
    if (kind === "empty") {
      this.canvas.renderer.resetState();
      this.canvas.renderer.clear();
      this.canvas.renderer.render(new Scene(), this.rig.camera);
    } else {
      if (kind === "orbit") this.rig.orbit(3, 0);
      this.draw();
    }
    this.canvas.finish();
    return performance.now() - begun_ms;
  }
}
