// One robot's path in the graphics card, texture by texture.

import type { Matrix4 } from "three";
import type { LegendKey } from "./path_colours";
import type { PathData } from "./path_data";
import { MAX_STRIDE, rowStrides } from "./draw_plan";
import type { Program } from "./shader_program";
import { SEGMENTS_PER_TEXTURE, PathTexture } from "./path_texture";

/** Parts that end at vertices from one to before another, each `stride`-th of them. */
export interface DrawCall {
  pathStrip: PathStrip;
  from: number;
  to: number;
  stride: number;
}

export class PathStrip {
  readonly pathTextures: PathTexture[] = [];

  constructor(
    private readonly gl: WebGL2RenderingContext,
    readonly data: PathData,
    /** Number from 0; the previous run for comparison is 31. */
    readonly robot: number,
    /** Robot that has the work frame of the path. */
    readonly frame: number,
  ) {
    this.grow(null);
  }

  /** Adds vertices that have arrived since; `key`: their colours. */
  grow(key: LegendKey | null): void {
    const { gl, data, pathTextures } = this;
    if (pathTextures.at(-1)?.end === data.count) return;
    pathTextures.pop()?.dispose();
    for (let first = pathTextures.length * SEGMENTS_PER_TEXTURE; first + 1 < data.count || first === 0; first += SEGMENTS_PER_TEXTURE) {
      const sheet = new PathTexture(gl, data, first, Math.min(first + SEGMENTS_PER_TEXTURE + 1, data.count));
      pathTextures.push(sheet);
      if (key) sheet.colour(data, key);
    }
  }

  colour(key: LegendKey): void {
    for (const sheet of this.pathTextures) sheet.colour(this.data, key);
  }

  /** Returns the draws that show the complete path on a screen. */
  plan(matrix: Matrix4, width_px: number, height_px: number): DrawCall[] {
    const draws: DrawCall[] = [];
    const rows = this.pathTextures.flatMap((sheet) => sheet.rows);
    const strides = rowStrides(rows, matrix, width_px, height_px);
    let row = 0;
    for (const sheet of this.pathTextures) {
      let from = sheet.first + 1;
      for (const { pieces } of sheet.rows) {
        const [stride, to] = [strides[row++], from + pieces];
        const last = draws.at(-1);
        if (last?.to === from && last.stride === stride) last.to = to;
        else if (stride > 0) draws.push({ pathStrip: this, from, to, stride });
        from = to;
      }
    }
    return draws;
  }

  /** Draws the parts that end at vertices from `from` to before `to`, each `stride`-th of them. */
  draw(program: Program, matrix: Matrix4, from: number, to: number, stride: number, wide: boolean): void {
    const { gl } = this;
    program.set1i("points", 0);
    program.set1i("colours", 1);
    program.set1i("stride", stride);
    gl.uniform1ui(program.place("robot"), this.robot);
    gl.uniformMatrix4fv(program.place("matrix"), false, matrix.elements);
    for (let k = Math.floor((Math.max(from, 1) - 1) / SEGMENTS_PER_TEXTURE); k < this.pathTextures.length; ++k) {
      const sheet = this.pathTextures[k];
      const [begin, end] = [Math.max(from - sheet.first, 1), Math.min(to, sheet.end) - sheet.first];
      if (sheet.first + 1 >= to) break;
      const pieces = Math.floor((end - begin) / stride);
      if (pieces < 0) continue;
      sheet.bind();
      program.set1i("first", begin);
      program.set1i("base", sheet.first);
      this.drawSegments(pieces, wide);
      // Remainder after the last step; not drawn while the camera moves.
      const rest = end - begin - pieces * stride;
      if (rest === 0 || stride > MAX_STRIDE) continue;
      program.set1i("stride", 1);
      program.set1i("first", end - rest);
      this.drawSegments(rest, wide);
      program.set1i("stride", stride);
    }
  }

  private drawSegments(count: number, wide: boolean): void {
    if (wide) this.gl.drawArrays(this.gl.TRIANGLES, 0, 6 * count);
    else if (count > 0) this.gl.drawArrays(this.gl.LINES, 0, 2 * count);
  }

  dispose(): void {
    for (const sheet of this.pathTextures) sheet.dispose();
  }
}
