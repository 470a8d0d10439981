// Canvas of the picture: its renderer, its size, and the recovery after the graphics card drops it.

import { WebGLRenderer } from "three";

export interface CanvasEvents {
  onResized(): void;
  lost(): void;
  restored(): void;
}

const MAX_PIXEL_RATIO = 2;

/**
 * True if a processor does the work of a graphics card: smooth edges of bodies would cost half of its time.
 */
function isSoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  const known = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = known ? String(gl?.getParameter(known.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}

export class Canvas {
  readonly element: HTMLCanvasElement;
  readonly gl: WebGL2RenderingContext;
  width_px = 1;
  height_px = 1;

  private constructor(
    readonly renderer: WebGLRenderer,
    private readonly host: HTMLElement,
    on: CanvasEvents,
  ) {
    this.element = renderer.domElement;
    this.gl = renderer.getContext() as WebGL2RenderingContext;
    renderer.autoClear = false;
    this.element.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      on.lost();
    });
    this.element.addEventListener("webglcontextrestored", () => on.restored());
    const resize = () => {
      this.fill();
      on.onResized();
    };
    new ResizeObserver(resize).observe(host);
    window.addEventListener("resize", resize);
    this.fill();
  }

  /** null: there is no WebGL 2. */
  static make(host: HTMLElement, on: CanvasEvents): Canvas | null {
    try {
      return new Canvas(new WebGLRenderer({ antialias: !isSoftware(), powerPreference: "high-performance" }), host, on);
    } catch {
      return null;
    }
  }

  get pixelRatio(): number {
    return this.renderer.getPixelRatio();
  }

  /** Returns the size of the picture in pixels of the screen. */
  get drawn(): { width_px: number; height_px: number } {
    return { width_px: this.element.width, height_px: this.element.height };
  }

  /** Fits the size to the page; not while the renderer is lent to a headset. */
  fill(): void {
    if (this.renderer.xr.isPresenting) return;
    this.width_px = Math.max(this.host.clientWidth, 1);
    this.height_px = Math.max(this.host.clientHeight, 1);
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, MAX_PIXEL_RATIO));
    this.renderer.setSize(this.width_px, this.height_px);
  }

  /** Waits until all requests are drawn. */
  finish(): void {
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4));
  }
}
