// Paths of all robots on the screen. At standstill of the camera they are drawn once into a kept picture,
// which is combined with the machine in each frame. During motion, many paths are drawn with fewer parts at
// half the resolution.

import type { Matrix4 } from "three";
import { areSameColours, type Key } from "./path_colours";
import type { PathData } from "./path_data";
import { Program } from "./program";
import * as shaders from "./shaders";
import { Strand, type Draw } from "./strand";
import { Target } from "./target";
import { Timer } from "./timer";

/** Robot number for drawing the previous run, for comparison. */
export const PREVIOUS = 31;

/** Look of the paths in a frame. */
export interface Look {
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
export interface Accent {
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

// Parts that even software draws within a frame or so; beyond WIDE_PIECES lines have no width.
const QUICK_PIECES = 40_000;
const WIDE_PIECES = 300_000;
const MOVING_PIECES = 60_000;
const SLICE_PIECES = 200_000;
const ACCENT_PIECES = 100_000;
// A step that is shorter shows no corner between its ends.
const SMALL_PX = 1;
const SLOW_MS = 40;
// Time without motion after which the camera is at standstill.
const REST_MS = 120;

export type More = "nothing" | "now" | "at rest";

export class PathLayer {
  private strands: Strand[] = [];
  private readonly keptThin: Program;
  private readonly keptWide: Program;
  private readonly shownWide: Program;
  private readonly screen: Program;
  private readonly nothing: WebGLVertexArrayObject;
  private full: Target | null = null;
  private coarse: Target | null = null;
  /** Contents of the full picture, and of the last request. */
  private drawn = "";
  private asked = "";
  private since_ms = 0;
  /** Draws that show the complete path, and how much of them is done. */
  private plan: Draw[] = [];
  private planned = 0;
  private slice = 0;
  private key: Key | null = null;
  private shown: Target | null = null;
  private readonly timer: Timer;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.keptThin = new Program(gl, shaders.keptThin);
    this.keptWide = new Program(gl, shaders.keptWide);
    this.shownWide = new Program(gl, shaders.shownWide);
    this.screen = new Program(gl, shaders.screen);
    this.nothing = gl.createVertexArray();
    this.timer = new Timer(gl);
  }

  /** Sets the paths to show; `previous` are those of the previous run. */
  take(current: PathData[], previous: PathData[], key: Key): void {
    const before = this.strands;
    const strandOf = (data: PathData, robot: number, frame: number) =>
      before.find((strand) => strand.data === data && strand.robot === robot && strand.frame === frame) ??
      new Strand(this.gl, data, robot, frame);
    this.strands = [
      ...previous.slice(0, current.length).map((data, robot) => strandOf(data, PREVIOUS, robot)),
      ...current.map((data, robot) => strandOf(data, robot, robot)),
    ];
    for (const strand of before) if (!this.strands.includes(strand)) strand.dispose();
    this.timer.forget();
    const isSame = areSameColours(key, this.key);
    for (const strand of this.strands) {
      strand.grow(isSame ? key : null);
      if (strand.robot !== PREVIOUS && !(isSame && before.includes(strand))) strand.colour(key);
    }
    this.key = key;
    this.renew();
  }

  /** Adds the path data that has arrived since. */
  grow(key: Key): void {
    const isSame = areSameColours(key, this.key);
    for (const strand of this.strands) strand.grow(isSame ? key : null);
    this.strands = [...this.strands]; // they have other sheets
    if (isSame) this.renew();
    else this.colour(key);
  }

  colour(key: Key): void {
    this.key = key;
    for (const strand of this.strands) if (strand.robot !== PREVIOUS) strand.colour(key);
    this.renew();
  }

  /** Requests a redraw of the kept picture. */
  renew(): void {
    this.drawn = "";
    this.asked = "";
  }

  /** Returns the shown strands; another list after each change of paths. */
  get shownStrands(): readonly Strand[] {
    return this.strands;
  }

  /** True if the kept picture shows everything that was requested. */
  get complete(): boolean {
    return this.drawn !== "" && this.drawn === this.asked;
  }

  private get slow(): boolean {
    return this.planned > QUICK_PIECES && (this.timer.cost_ms ?? Infinity) > SLOW_MS;
  }

  /** Updates the kept picture; returns if more is to be drawn. */
  prepare(look: Look, time_ms: number): More {
    const { width_px, height_px, rapids, compare } = look;
    const matrices = look.matrices.map((matrix) => matrix.elements.join());
    const wanted = [width_px, height_px, rapids, compare, look.compareColour, ...matrices].join();
    if (this.asked !== wanted) {
      this.layPlan(look);
      this.slice = 0;
      this.since_ms = time_ms;
    }
    this.asked = wanted;
    const rests = time_ms - this.since_ms > REST_MS;
    if (this.drawn !== wanted) this.update(look, wanted, rests);
    if (this.drawn === wanted) return "nothing";
    return rests ? "now" : "at rest";
  }

  private layPlan(look: Look): void {
    const { width_px, height_px } = look;
    const shown = this.strands.filter(({ robot }) => robot !== PREVIOUS || look.compare);
    this.plan = shown.flatMap((strand) => strand.plan(look.matrices[strand.frame], width_px, height_px));
    this.planned = this.plan.reduce((sum, { from, to, stride }) => sum + (to - from) / stride, 0);
  }

  private update(look: Look, wanted: string, rests: boolean): void {
    const { width_px, height_px } = look;
    if (this.full?.width !== width_px || this.full.height !== height_px) this.resize(width_px, height_px);
    this.setState();
    const isWide = this.planned <= WIDE_PIECES;
    if (!this.slow) {
      this.full!.begin();
      this.timer.begin();
      this.paint(look, 0, Infinity, 1, isWide);
      this.timer.end(1);
      this.show(this.full!, wanted);
    } else if (!rests) {
      this.coarse!.begin();
      this.paint(look, 0, Infinity, Math.ceil(this.planned / MOVING_PIECES), false);
      this.shown = this.coarse;
    } else this.refine(look, wanted, isWide);
  }

  // Draws in slices, so that the page stays responsive.
  private refine(look: Look, wanted: string, isWide: boolean): void {
    if (this.slice === 0) this.full!.begin();
    else this.full!.go();
    this.timer.begin();
    this.paint(look, this.slice, this.slice + SLICE_PIECES, 1, isWide);
    this.timer.end(Math.max(1, this.planned / SLICE_PIECES));
    this.slice += SLICE_PIECES;
    if (this.slice >= this.planned) this.show(this.full!, wanted);
  }

  private show(target: Target, wanted: string): void {
    this.shown = target;
    this.drawn = wanted;
    this.slice = 0;
  }

  private resize(width: number, height: number): void {
    this.full?.dispose();
    this.coarse?.dispose();
    this.full = new Target(this.gl, width, height);
    this.coarse = new Target(this.gl, Math.ceil(width / 2), Math.ceil(height / 2));
    this.shown = null;
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
  private paint(look: Look, from: number, to: number, coarser: number, wide: boolean): void {
    const { gl } = this;
    const program = wide ? this.keptWide : this.keptThin;
    program.use();
    const ratio = look.pixelRatio;
    this.setSize(program, look, 1.4 * ratio);
    gl.uniform1i(program.place("rapids"), look.rapids ? 1 : 0);
    let before = 0;
    for (const { strand, from: first, to: end, stride } of this.plan) {
      const begin = first + Math.ceil(Math.max(from - before, 0)) * stride;
      const last = Math.min(end, first + Math.ceil(Math.max(to - before, 0)) * stride);
      before += (end - first) / stride;
      if (begin >= last) continue;
      const old = strand.robot === PREVIOUS;
      gl.uniform4fv(program.place("paint"), old ? [...look.compareColour, 1] : [0, 0, 0, 0]);
      gl.uniform1i(program.place("clean"), old ? 1 : 0);
      program.set1f("nearer", old ? -2e-5 : 0);
      program.set1f("small_mm", stride > 1 ? SMALL_PX * look.mmPerPixel : 0);
      strand.draw(program, look.matrices[strand.frame], begin, last, stride * coarser, wide);
    }
  }

  private setSize(program: Program, look: Look, width_px: number): void {
    this.gl.uniform2f(program.place("size_px"), look.width_px, look.height_px);
    program.set1f("width_px", width_px);
    program.set1f("opacity", 1);
    program.set1f("dash_px", 8 * look.pixelRatio);
    program.set1f("join_px", 0.35 * look.pixelRatio);
  }

  /** Draws the kept picture to the screen, except where nearer bodies hide it. */
  compose(look: Look): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, look.width_px, look.height_px);
    if (!this.shown || this.strands.length === 0) return;
    this.setState();
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.screen.use();
    [this.shown.colours, this.shown.known, this.shown.depths].forEach((texture, i) => {
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
  accent(accent: Accent, look: Look): void {
    const { gl } = this;
    const strand = this.strands.find(({ robot }) => robot === accent.robot);
    if (!strand || accent.ranges.length === 0) return;
    this.setState();
    gl.depthMask(false);
    const program = this.shownWide;
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
        strand.draw(program, look.matrices[strand.frame], from, to, Math.ceil((to - from) / ACCENT_PIECES) || 1, true);
      }
    }
    gl.depthMask(true);
  }

  /**
   * Returns the nearest part to a position on the screen (0 to 1 from the left and from below), within some
   * pixels.
   */
  hit(x: number, y: number, reach_px: number): Hit | null {
    if (!this.shown || this.strands.length === 0) return null;
    const { width, height } = this.shown;
    const reach = this.shown === this.full ? reach_px : Math.ceil(reach_px / 2);
    const pixels = this.shown.read(Math.floor(x * width), Math.floor(y * height), reach);
    const side = 2 * reach + 1;
    let best = -1;
    let nearest = Infinity;
    for (let i = 0; i < side * side; ++i) {
      const id = pixels[4 * i];
      const away = Math.hypot((i % side) - reach, Math.floor(i / side) - reach);
      if (id === 0 || (id - 1) >>> 27 === PREVIOUS || away >= nearest) continue;
      nearest = away;
      best = i;
    }
    if (best < 0) return null;
    const id = pixels[4 * best] - 1;
    const t_s = new Float32Array(pixels.buffer, 16 * best + 4, 1)[0];
    const [robot, vertex] = [id >>> 27, id & 0x7ffffff];
    return { robot, vertex: this.pieceAt(robot, vertex, t_s), t_s };
  }

  /** One step may represent several parts up to a vertex: the time selects one of them. */
  private pieceAt(robot: number, vertex: number, t_s: number): number {
    const draw = this.plan.find(({ strand, from, to }) => strand.robot === robot && from <= vertex && vertex < to);
    if (!draw || (draw.stride === 1 && this.shown === this.full)) return vertex;
    return Math.max(Math.min(vertex, draw.strand.data.at(t_s)), 1);
  }
}
