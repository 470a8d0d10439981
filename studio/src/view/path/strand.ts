// One robot's path in the graphics card, texture by texture.

import type { Matrix4 } from "three";
import type { Key } from "./path_colours";
import type { PathData } from "./path_data";
import { MOST_STRIDE, stridesOf } from "./plan";
import type { Program } from "./program";
import { SHEET_PIECES, Sheet } from "./sheet";

/** Parts that end at vertices from one to before another, each `stride`-th of them. */
export interface Draw {
  strand: Strand;
  from: number;
  to: number;
  stride: number;
}

export class Strand {
  readonly sheets: Sheet[] = [];

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
  grow(key: Key | null): void {
    const { gl, data, sheets } = this;
    if (sheets.at(-1)?.end === data.count) return;
    sheets.pop()?.dispose();
    for (let first = sheets.length * SHEET_PIECES; first + 1 < data.count || first === 0; first += SHEET_PIECES) {
      const sheet = new Sheet(gl, data, first, Math.min(first + SHEET_PIECES + 1, data.count));
      sheets.push(sheet);
      if (key) sheet.colour(data, key);
    }
  }

  colour(key: Key): void {
    for (const sheet of this.sheets) sheet.colour(this.data, key);
  }

  /** Returns the draws that show the complete path on a screen. */
  plan(matrix: Matrix4, width_px: number, height_px: number): Draw[] {
    const draws: Draw[] = [];
    const rows = this.sheets.flatMap((sheet) => sheet.rows);
    const strides = stridesOf(rows, matrix, width_px, height_px);
    let row = 0;
    for (const sheet of this.sheets) {
      let from = sheet.first + 1;
      for (const { pieces } of sheet.rows) {
        const [stride, to] = [strides[row++], from + pieces];
        const last = draws.at(-1);
        if (last?.to === from && last.stride === stride) last.to = to;
        else if (stride > 0) draws.push({ strand: this, from, to, stride });
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
    for (let k = Math.floor((Math.max(from, 1) - 1) / SHEET_PIECES); k < this.sheets.length; ++k) {
      const sheet = this.sheets[k];
      const [begin, end] = [Math.max(from - sheet.first, 1), Math.min(to, sheet.end) - sheet.first];
      if (sheet.first + 1 >= to) break;
      const pieces = Math.floor((end - begin) / stride);
      if (pieces < 0) continue;
      sheet.bind();
      program.set1i("first", begin);
      program.set1i("base", sheet.first);
      this.drawPieces(pieces, wide);
      // Remainder after the last step; not drawn while the camera moves.
      const rest = end - begin - pieces * stride;
      if (rest === 0 || stride > MOST_STRIDE) continue;
      program.set1i("stride", 1);
      program.set1i("first", end - rest);
      this.drawPieces(rest, wide);
      program.set1i("stride", stride);
    }
  }

  private drawPieces(count: number, wide: boolean): void {
    if (wide) this.gl.drawArrays(this.gl.TRIANGLES, 0, 6 * count);
    else if (count > 0) this.gl.drawArrays(this.gl.LINES, 0, 2 * count);
  }

  dispose(): void {
    for (const sheet of this.sheets) sheet.dispose();
  }
}
