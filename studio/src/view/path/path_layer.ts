// Paths of all robots on the screen. At standstill of the camera they are drawn once into a kept picture,
// which is combined with the machine in each frame. During motion, many paths are drawn with fewer parts at
// half the resolution.

import type { Matrix4 } from "three";
import { areSameColours, type LegendKey } from "./path_colours";
import type { PathData } from "./path_data";
import { Program } from "./shader_program";
import * as shaders from "./shaders";
import { PathStrip, type DrawCall } from "./path_strip";
import { Target } from "./render_target";
import { Timer } from "./draw_timer";

/** Robot number for drawing the previous run, for comparison. */
export const PREVIOUS_RUN = 31;

/** Look of the paths in a frame. */
export interface FrameAppearance {
  /** Transformation from each robot's work frame to the clip space. */
  matrices: Matrix4[];
  width_px: number;
  height_px: number;
  pixelRatio: number;
  /** Scale at the middle of the view, for pixels of the screen. */
  mmPerPixel: number;
  rapids: boolean;
  compare: boolean;
  compareColour: number[];
  /** Time up to which each robot's vertices are done, s. */
  now_s: number[];
  /** Opacity of the remaining path, and share of white mixed into all; 0 to 1. */
  dimmed: number;
  lightened: number;
}

/** Ranges of one robot's vertices that are drawn over all else. */
export interface HighlightedRanges {
  robot: number;
  ranges: [number, number][];
  colour: number[];
  width_px: number;
  opacity: number;
}

/** Contents of a pixel: the vertex that ends the part there, and the time there. */
export interface Hit {
  robot: number;
  vertex: number;
  t_s: number;
}

// Parts that even software draws within a frame or so; beyond MAX_WIDE_SEGMENTS lines have no width.
const MAX_DIRECT_SEGMENTS = 40_000;
const MAX_WIDE_SEGMENTS = 300_000;
const MOVING_SEGMENTS = 60_000;
const SEGMENTS_PER_SLICE = 200_000;
const MAX_HIGHLIGHT_SEGMENTS = 100_000;
// A step that is shorter shows no corner between its ends.
const MIN_STEP_PX = 1;
const SLOW_DRAW_MS = 40;
// Time without motion after which the camera is at standstill.
const IDLE_MS = 120;

export type RemainingDrawing = "nothing" | "now" | "at rest";

export class PathLayer {
  private pathStrips: PathStrip[] = [];
  private readonly storedThin: Program;
  private readonly storedWide: Program;
  private readonly displayedWide: Program;
  private readonly screen: Program;
  private readonly nothing: WebGLVertexArrayObject;
  private full: Target | null = null;
  private coarse: Target | null = null;
  /** Contents of the full picture, and of the last request. */
  private drawn = "";
  private asked = "";
  private since_ms = 0;
  /** Draws that show the complete path, and how much of them is done. */
  private plan: DrawCall[] = [];
  private planned = 0;
  private slice = 0;
  private key: LegendKey | null = null;
  private displayed: Target | null = null;
  private readonly timer: Timer;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.storedThin = new Program(gl, shaders.storedThin);
    this.storedWide = new Program(gl, shaders.storedWide);
    this.displayedWide = new Program(gl, shaders.displayedWide);
    this.screen = new Program(gl, shaders.screen);
    this.nothing = gl.createVertexArray();
    this.timer = new Timer(gl);
  }

  /** Sets the paths to show; `previous` are those of the previous run. */
  setContent(current: PathData[], previous: PathData[], key: LegendKey): void {
    const before = this.pathStrips;
    const findOrCreateStrip = (data: PathData, robot: number, frame: number) =>
      before.find((pathStrip) => pathStrip.data === data && pathStrip.robot === robot && pathStrip.frame === frame) ??
      new PathStrip(this.gl, data, robot, frame);
    this.pathStrips = [
      ...previous.slice(0, current.length).map((data, robot) => findOrCreateStrip(data, PREVIOUS_RUN, robot)),
      ...current.map((data, robot) => findOrCreateStrip(data, robot, robot)),
    ];
    for (const pathStrip of before) if (!this.pathStrips.includes(pathStrip)) pathStrip.dispose();
    this.timer.forget();
    const isSame = areSameColours(key, this.key);
    for (const pathStrip of this.pathStrips) {
      pathStrip.grow(isSame ? key : null);
      if (pathStrip.robot !== PREVIOUS_RUN && !(isSame && before.includes(pathStrip))) pathStrip.colour(key);
    }
    this.key = key;
    this.refresh();
  }

  /** Adds the path data that has arrived since. */
  grow(key: LegendKey): void {
    const isSame = areSameColours(key, this.key);
    for (const pathStrip of this.pathStrips) pathStrip.grow(isSame ? key : null);
    this.pathStrips = [...this.pathStrips]; // they have other sheets
    if (isSame) this.refresh();
    else this.colour(key);
  }

  colour(key: LegendKey): void {
    this.key = key;
    for (const pathStrip of this.pathStrips) if (pathStrip.robot !== PREVIOUS_RUN) pathStrip.colour(key);
    this.refresh();
  }

  /** Requests a redraw of the kept picture. */
  refresh(): void {
    this.drawn = "";
    this.asked = "";
  }

  /** Returns the shown strands; another list after each change of paths. */
  get visibleStrips(): readonly PathStrip[] {
    return this.pathStrips;
  }

  /** True if the kept picture shows everything that was requested. */
  get complete(): boolean {
    return this.drawn !== "" && this.drawn === this.asked;
  }

  private get slow(): boolean {
    return this.planned > MAX_DIRECT_SEGMENTS && (this.timer.cost_ms ?? Infinity) > SLOW_DRAW_MS;
  }

  /** Updates the kept picture; returns if more is to be drawn. */
  prepare(look: FrameAppearance, time_ms: number): RemainingDrawing {
    const { width_px, height_px, rapids, compare } = look;
    const matrices = look.matrices.map((matrix) => matrix.elements.join());
    const requested = [width_px, height_px, rapids, compare, look.compareColour, ...matrices].join();
    if (this.asked !== requested) {
      this.createDrawPlan(look);
      this.slice = 0;
      this.since_ms = time_ms;
    }
    this.asked = requested;
    const isSettled = time_ms - this.since_ms > IDLE_MS;
    if (this.drawn !== requested) this.update(look, requested, isSettled);
    if (this.drawn === requested) return "nothing";
    return isSettled ? "now" : "at rest";
  }

  private createDrawPlan(look: FrameAppearance): void {
    const { width_px, height_px } = look;
    const displayed = this.pathStrips.filter(({ robot }) => robot !== PREVIOUS_RUN || look.compare);
    this.plan = displayed.flatMap((pathStrip) => pathStrip.plan(look.matrices[pathStrip.frame], width_px, height_px));
    this.planned = this.plan.reduce((sum, { from, to, stride }) => sum + (to - from) / stride, 0);
  }

  private update(look: FrameAppearance, requested: string, isSettled: boolean): void {
    const { width_px, height_px } = look;
    if (this.full?.width !== width_px || this.full.height !== height_px) this.resize(width_px, height_px);
    this.setState();
    const isWide = this.planned <= MAX_WIDE_SEGMENTS;
    if (!this.slow) {
      this.full!.begin();
      this.timer.begin();
      this.paint(look, 0, Infinity, 1, isWide);
      this.timer.end(1);
      this.show(this.full!, requested);
    } else if (!isSettled) {
      this.coarse!.begin();
      this.paint(look, 0, Infinity, Math.ceil(this.planned / MOVING_SEGMENTS), false);
      this.displayed = this.coarse;
    } else this.refine(look, requested, isWide);
  }

  // Draws in slices, so that the page stays responsive.
  private refine(look: FrameAppearance, requested: string, isWide: boolean): void {
    if (this.slice === 0) this.full!.begin();
    else this.full!.go();
    this.timer.begin();
    this.paint(look, this.slice, this.slice + SEGMENTS_PER_SLICE, 1, isWide);
    this.timer.end(Math.max(1, this.planned / SEGMENTS_PER_SLICE));
    this.slice += SEGMENTS_PER_SLICE;
    if (this.slice >= this.planned) this.show(this.full!, requested);
  }

  private show(target: Target, requested: string): void {
    this.displayed = target;
    this.drawn = requested;
    this.slice = 0;
  }

  private resize(width: number, height: number): void {
    this.full?.dispose();
    this.coarse?.dispose();
    this.full = new Target(this.gl, width, height);
    this.coarse = new Target(this.gl, Math.ceil(width / 2), Math.ceil(height / 2));
    this.displayed = null;
    this.slice = 0;
  }

  private setState(): void {
    const { gl } = this;
    gl.bindVertexArray(this.nothing);
    gl.disable(gl.CULL_FACE);
    gl.disable(gl.SCISSOR_TEST);
    gl.disable(gl.STENCIL_TEST);
    gl.colorMask(true, true, true, true);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.depthMask(true);
    gl.enable(gl.BLEND);
    gl.blendEquation(gl.FUNC_ADD);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  /** Draws parts of the plan from number `from` to before `to`; only each `coarser`-th of those. */
  private paint(look: FrameAppearance, from: number, to: number, coarser: number, wide: boolean): void {
    const { gl } = this;
    const program = wide ? this.storedWide : this.storedThin;
    program.use();
    const ratio = look.pixelRatio;
    this.setSize(program, look, 1.4 * ratio);
    gl.uniform1i(program.place("rapids"), look.rapids ? 1 : 0);
    let before = 0;
    for (const { pathStrip, from: first, to: end, stride } of this.plan) {
      const begin = first + Math.ceil(Math.max(from - before, 0)) * stride;
      const last = Math.min(end, first + Math.ceil(Math.max(to - before, 0)) * stride);
      before += (end - first) / stride;
      if (begin >= last) continue;
      const old = pathStrip.robot === PREVIOUS_RUN;
      gl.uniform4fv(program.place("paint"), old ? [...look.compareColour, 1] : [0, 0, 0, 0]);
      gl.uniform1i(program.place("clean"), old ? 1 : 0);
      program.set1f("nearer", old ? -2e-5 : 0);
      program.set1f("small_mm", stride > 1 ? MIN_STEP_PX * look.mmPerPixel : 0);
      pathStrip.draw(program, look.matrices[pathStrip.frame], begin, last, stride * coarser, wide);
    }
  }

  private setSize(program: Program, look: FrameAppearance, width_px: number): void {
    this.gl.uniform2f(program.place("size_px"), look.width_px, look.height_px);
    program.set1f("width_px", width_px);
    program.set1f("opacity", 1);
    program.set1f("dash_px", 8 * look.pixelRatio);
    program.set1f("join_px", 0.35 * look.pixelRatio);
  }

  /** Draws the kept picture to the screen, except where nearer bodies hide it. */
  compose(look: FrameAppearance): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, look.width_px, look.height_px);
    if (!this.displayed || this.pathStrips.length === 0) return;
    this.setState();
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.screen.use();
    [this.displayed.colours, this.displayed.known, this.displayed.depths].forEach((texture, i) => {
      gl.activeTexture(gl.TEXTURE0 + i);
      gl.bindTexture(gl.TEXTURE_2D, texture);
    });
    this.screen.set1i("kept", 0);
    this.screen.set1i("known", 1);
    this.screen.set1i("depth", 2);
    this.screen.set1f("dimmed", look.dimmed);
    this.screen.set1f("lightened", look.lightened);
    const now_s = new Float32Array(32).fill(Infinity);
    now_s.set(look.now_s);
    gl.uniform1fv(this.screen.place("now_s"), now_s);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** Draws ranges over all else; parts hidden by nearer bodies are faint. */
  drawHighlight(accent: HighlightedRanges, look: FrameAppearance): void {
    const { gl } = this;
    const pathStrip = this.pathStrips.find(({ robot }) => robot === accent.robot);
    if (!pathStrip || accent.ranges.length === 0) return;
    this.setState();
    gl.depthMask(false);
    const program = this.displayedWide;
    program.use();
    this.setSize(program, look, accent.width_px * look.pixelRatio);
    gl.uniform1i(program.place("rapids"), 1);
    gl.uniform1i(program.place("clean"), 1);
    gl.uniform4fv(program.place("paint"), [...accent.colour, 1]);
    program.set1f("nearer", 1e-4);
    for (const [comparison, share] of [
      [gl.LEQUAL, 1],
      [gl.GREATER, 0.35],
    ]) {
      gl.depthFunc(comparison);
      const opacity = accent.opacity * share;
      program.set1f("opacity", opacity);
      // Overlaps of parts would be visible with transparency.
      program.set1f("join_px", opacity < 1 ? 0 : 0.25 * accent.width_px * look.pixelRatio);
      program.set1f("small_mm", 0);
      for (const [from, to] of accent.ranges) {
        pathStrip.draw(program, look.matrices[pathStrip.frame], from, to, Math.ceil((to - from) / MAX_HIGHLIGHT_SEGMENTS) || 1, true);
      }
    }
    gl.depthMask(true);
  }

  /**
   * Returns the nearest part to a position on the screen (0 to 1 from the left and from below), within some
   * pixels.
   */
  hit(x: number, y: number, hitRadius_px: number): Hit | null {
    if (!this.displayed || this.pathStrips.length === 0) return null;
    const { width, height } = this.displayed;
    const reach = this.displayed === this.full ? hitRadius_px : Math.ceil(hitRadius_px / 2);
    const pixels = this.displayed.read(Math.floor(x * width), Math.floor(y * height), reach);
    const side = 2 * reach + 1;
    let best = -1;
    let nearest = Infinity;
    for (let i = 0; i < side * side; ++i) {
      const id = pixels[4 * i];
      const away = Math.hypot((i % side) - reach, Math.floor(i / side) - reach);
      if (id === 0 || (id - 1) >>> 27 === PREVIOUS_RUN || away >= nearest) continue;
      nearest = away;
      best = i;
    }
    if (best < 0) return null;
    const id = pixels[4 * best] - 1;
    const t_s = new Float32Array(pixels.buffer, 16 * best + 4, 1)[0];
    const [robot, vertex] = [id >>> 27, id & 0x7ffffff];
    return { robot, vertex: this.segmentEndAt(robot, vertex, t_s), t_s };
  }

  /** One step may represent several parts up to a vertex: the time selects one of them. */
  private segmentEndAt(robot: number, vertex: number, t_s: number): number {
    const draw = this.plan.find(({ pathStrip, from, to }) => pathStrip.robot === robot && from <= vertex && vertex < to);
    if (!draw || (draw.stride === 1 && this.displayed === this.full)) return vertex;
    return Math.max(Math.min(vertex, draw.pathStrip.data.at(t_s)), 1);
  }
}
