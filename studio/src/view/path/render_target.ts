// Kept picture of the path: colours, vertex and time of each pixel, and depths.

export class Target {
  readonly colours: WebGLTexture;
  readonly known: WebGLTexture;
  readonly depths: WebGLTexture;
  private readonly buffer: WebGLFramebuffer;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    readonly width: number,
    readonly height: number,
  ) {
    this.buffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.buffer);
    this.colours = this.attach(gl.RGBA8, gl.COLOR_ATTACHMENT0);
    this.known = this.attach(gl.RG32UI, gl.COLOR_ATTACHMENT1);
    this.depths = this.attach(gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT);
    gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
  }

  private attach(format: number, place: number): WebGLTexture {
    const { gl } = this;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, this.width, this.height);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, place, gl.TEXTURE_2D, texture, 0);
    return texture;
  }

  /** Directs draws here from now on. */
  go(): void {
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.buffer);
    this.gl.viewport(0, 0, this.width, this.height);
  }

  /** As go(), and clears it. */
  begin(): void {
    const { gl } = this;
    this.go();
    gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
    gl.clearBufferuiv(gl.COLOR, 1, [0, 0, 0, 0]);
    gl.clearBufferfv(gl.DEPTH, 0, [1]);
  }

  /**
   * Returns vertex and time of the pixels in a square around a position, row by row from below; four numbers
   * for each.
   */
  read(x: number, y: number, reach: number): Uint32Array {
    const { gl } = this;
    const side = 2 * reach + 1;
    const pixels = new Uint32Array(4 * side * side);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.buffer);
    gl.readBuffer(gl.COLOR_ATTACHMENT1);
    gl.readPixels(x - reach, y - reach, side, side, gl.RGBA_INTEGER, gl.UNSIGNED_INT, pixels);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return pixels;
  }

  dispose(): void {
    const { gl } = this;
    gl.deleteFramebuffer(this.buffer);
    for (const texture of [this.colours, this.known, this.depths]) gl.deleteTexture(texture);
  }
}
