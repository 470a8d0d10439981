// Part of a path in the graphics card: a texture of vertices and one of colours, and the path lengths of its
// rows.

import { rowLength, type Row } from "./draw_plan";
import { colourTexels, type LegendKey } from "./path_colours";
import { ROW, rowCount, type PathData } from "./path_data";

/** Number of path parts; the texture has one vertex more, at which the first part begins. */
export const SEGMENTS_PER_TEXTURE = 16 * ROW - 1;

export class PathTexture {
  readonly rows: Row[] = [];
  readonly points: WebGLTexture;
  readonly colours: WebGLTexture;

  /** Takes vertices from `first` to before `end`; its parts end at all but the first of them. */
  constructor(
    private readonly gl: WebGL2RenderingContext,
    data: PathData,
    readonly first: number,
    readonly end: number,
  ) {
    const texels = data.texels(first, end);
    this.points = this.texture();
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, ROW, rowCount(end - first), 0, gl.RGBA, gl.FLOAT, texels);
    this.colours = this.texture();
    for (let from = 0; from + 1 < end - first; from += ROW) {
      this.rows.push(rowLength(texels, from, Math.min(from + ROW, end - first - 1)));
    }
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

  colour(data: PathData, key: LegendKey): void {
    const { gl, first, end } = this;
    gl.bindTexture(gl.TEXTURE_2D, this.colours);
    const texels = colourTexels(data, key, first, end);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, ROW, rowCount(end - first), 0, gl.RGBA, gl.UNSIGNED_BYTE, texels);
  }

  bind(): void {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.points);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, this.colours);
  }

  dispose(): void {
    this.gl.deleteTexture(this.points);
    this.gl.deleteTexture(this.colours);
  }
}
