// WebGL program, and its inputs by name.

export class Program {
  private readonly program: WebGLProgram;
  private readonly places = new Map<string, WebGLUniformLocation | null>();

  constructor(
    private readonly gl: WebGL2RenderingContext,
    [vertex, fragment]: readonly [string, string],
  ) {
    this.program = gl.createProgram();
    const shaders = [this.compile(gl.VERTEX_SHADER, vertex), this.compile(gl.FRAGMENT_SHADER, fragment)];
    gl.linkProgram(this.program);
    for (const shader of shaders) gl.deleteShader(shader);
  }

  private compile(type: number, source: string): WebGLShader {
    const { gl } = this;
    const shader = gl.createShader(type)!;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
      throw new Error(gl.getShaderInfoLog(shader) ?? "a shader does not compile");
    }
    gl.attachShader(this.program, shader);
    return shader;
  }

  use(): void {
    this.gl.useProgram(this.program);
  }

  place(name: string): WebGLUniformLocation | null {
    if (!this.places.has(name)) this.places.set(name, this.gl.getUniformLocation(this.program, name));
    return this.places.get(name)!;
  }

  set1i(name: string, value: number): void {
    this.gl.uniform1i(this.place(name), value);
  }

  set1f(name: string, value: number): void {
    this.gl.uniform1f(this.place(name), value);
  }
}
