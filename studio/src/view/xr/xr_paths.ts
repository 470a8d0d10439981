// Paths of all robots in a headset: redrawn for each eye, among the bodies. The page's kept picture uses
// pixels of the screen; here positions of the world are used, so that both eyes see the same: rapids are
// dashed by length.

import { BufferGeometry, DoubleSide, ExternalTexture, GLSL3, Group, Mesh, RawShaderMaterial, Vector2, type Matrix4, type PerspectiveCamera } from "three";
import { PREVIOUS_RUN, type FrameAppearance, type PathLayer } from "../path/path_layer";
import { eyeShaders } from "../path/shaders";
import type { PathTexture } from "../path/path_texture";
import type { PathStrip } from "../path/path_strip";

/** Width of a line, in pixels of an eye, which are coarser than a screen's. */
const WIDE_PX = 2;
/** Max number of parts; more are simplified, because a headset needs 72 pictures in a second, twice. */
const MAX_SEGMENTS = 100_000;
/** Number of dashes in the length of the path's box. */
const DASH_COUNT = 60;

/** Path of one `PathTexture`. */
class PathMesh {
  readonly mesh: Mesh<BufferGeometry, RawShaderMaterial>;

  constructor(
    private readonly pathStrip: PathStrip,
    sheet: PathTexture,
    pieces: number,
  ) {
    const { data, robot } = pathStrip;
    const stride = Math.max(1, Math.ceil(pieces / MAX_SEGMENTS));
    const texture = (source: WebGLTexture) => new ExternalTexture(source);
    const size_mm = data.bounds.max.distanceTo(data.bounds.min);
    const values = {
      ...{ points: texture(sheet.points), colours: texture(sheet.colours), matrix: null, size_px: new Vector2() },
      ...{ first: 1, base: sheet.first, small_mm: 0, stride, robot, width_px: WIDE_PX, join_px: WIDE_PX / 4, paint: [0, 0, 0, 0], nearer: robot === PREVIOUS_RUN ? -2e-5 : 0 },
      ...{ rapids: true, clean: robot === PREVIOUS_RUN, dash_mm: Math.max(size_mm / DASH_COUNT, 1e-3), now_s: 0, dimmed: 1, lightened: 0 },
    };
    const uniforms = Object.fromEntries(Object.entries(values).map(([name, value]) => [name, { value }]));
    const [vertexShader, fragmentShader] = eyeShaders;
    const shaders = { vertexShader, fragmentShader, glslVersion: GLSL3 };
    const material = new RawShaderMaterial({ uniforms, ...shaders, transparent: true, side: DoubleSide });
    const geometry = new BufferGeometry();
    geometry.setDrawRange(0, 6 * Math.max(0, Math.floor((sheet.end - sheet.first - 1) / stride)));
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.matrixAutoUpdate = false;
    this.mesh.onBeforeRender = (_renderer, _scene, camera) => this.updateForEye(camera as PerspectiveCamera);
  }

  /** By one eye. */
  private updateForEye(eye: PerspectiveCamera): void {
    const { uniforms } = this.mesh.material;
    uniforms.matrix.value = eye.projectionMatrix.clone().multiply(eye.matrixWorldInverse).multiply(this.mesh.matrixWorld);
    if (eye.viewport) uniforms.size_px.value.set(eye.viewport.z, eye.viewport.w);
    this.mesh.material.uniformsNeedUpdate = true;
  }

  show(look: FrameAppearance, works: Matrix4[]): void {
    const { frame, robot } = this.pathStrip;
    const old = robot === PREVIOUS_RUN;
    const { uniforms } = this.mesh.material;
    this.mesh.visible = frame < works.length && (!old || look.compare);
    if (!this.mesh.visible) return;
    this.mesh.matrix.copy(works[frame]);
    // After the end all is done; a finite number is used, because shaders need not support infinity.
    const now_s = old ? Infinity : look.now_s[frame];
    const values = { rapids: look.rapids, now_s: Math.min(now_s, 3e38), dimmed: look.dimmed, lightened: look.lightened };
    for (const [name, value] of Object.entries(values)) uniforms[name].value = value;
    if (old) uniforms.paint.value = [...look.compareColour, 1];
  }

  /** Its textures belong to the page. */
  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

export class XrPaths {
  readonly group = new Group();
  private pathStrips: readonly PathStrip[] = [];
  private pathMeshes: PathMesh[] = [];

  show(layer: PathLayer, look: FrameAppearance, works: Matrix4[]): void {
    if (this.pathStrips !== layer.visibleStrips) this.setContent(layer.visibleStrips);
    for (const pathMesh of this.pathMeshes) pathMesh.show(look, works);
  }

  private setContent(pathStrips: readonly PathStrip[]): void {
    this.dispose();
    this.pathStrips = pathStrips;
    const pieces = pathStrips.reduce((sum, { data }) => sum + data.count, 0);
    this.pathMeshes = pathStrips.flatMap((pathStrip) => pathStrip.pathTextures.map((sheet) => new PathMesh(pathStrip, sheet, pieces)));
    for (const { mesh } of this.pathMeshes) this.group.add(mesh);
  }

  dispose(): void {
    for (const pathMesh of this.pathMeshes) pathMesh.dispose();
    this.group.clear();
    this.pathMeshes = [];
    this.pathStrips = [];
  }
}
