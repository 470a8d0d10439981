// One robot's way in the graphics card: a texture of vertices and one of colours.

import type { Matrix4 } from "three";
import { colourTexels, type Key } from "./path_colours";
import { ROW, type PathData } from "./path_data";
import type { Program } from "./program";

export class Strand {
  private readonly points: WebGLTexture;
  private readonly colours: WebGLTexture;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    readonly data: PathData,
    /** From 0; the run before for comparing is 31. */
    readonly robot: number,
    /** The robot in whose work frame it stands. */
    readonly frame: number,
  ) {
    this.points = this.texture();
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, ROW, data.rows, 0, gl.RGBA, gl.FLOAT, data.texels());
    this.colours = this.texture();
  }

  private texture(): WebGLTexture {
    const { gl } = this;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return texture;
  }

  colour(key: Key): void {
    const { gl, data } = this;
    gl.bindTexture(gl.TEXTURE_2D, this.colours);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, ROW, data.rows, 0, gl.RGBA, gl.UNSIGNED_BYTE, colourTexels(data, key));
  }

  /** Draws the pieces that end at vertices from `from` to before `to`, each `stride`-th of them. */
  draw(program: Program, matrix: Matrix4, from: number, to: number, stride: number, wide: boolean): void {
    const { gl } = this;
    const first = Math.max(from, 1);
    const pieces = Math.floor((to - first) / stride);
    if (pieces <= 0) return;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.points);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.colours);
    program.set1i("points", 0);
    program.set1i("colours", 1);
    program.set1i("first", first);
    program.set1i("stride", stride);
    gl.uniform1ui(program.place("robot"), this.robot);
    gl.uniformMatrix4fv(program.place("matrix"), false, matrix.elements);
    if (wide) gl.drawArrays(gl.TRIANGLES, 0, 6 * pieces);
    else gl.drawArrays(gl.LINES, 0, 2 * pieces);
  }

  dispose(): void {
    this.gl.deleteTexture(this.points);
    this.gl.deleteTexture(this.colours);
  }
}
