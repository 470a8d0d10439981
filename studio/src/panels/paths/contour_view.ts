// Picture of a part's contours that can be turned: a click on one removes it, or adds it again.

import { element } from "../../core/dom";
import { onTheme, themeColour } from "../../core/theme";
import { texts } from "../../texts";
import {
  projectLine,
  lineExtent,
  initialCamera,
  nearestLine,
  turned,
  zoomCamera,
  type Camera,
  type Extent,
  type Size,
} from "./contour_camera";

const words = texts.paths.contours.picture;

const HIT_DISTANCE_px = 9;
/** A pointer that has moved this far turns the picture, and is not a click. */
const MIN_DRAG_px = 4;
const KEY_STEP_px = 12;
const ZOOM_FACTOR = 1.25;

export interface ContourViewEvents {
  /** Called with the contour under the pointer; -1: none. */
  onPointed(contour: number): void;
  onClicked(contour: number): void;
}

export class ContourView {
  readonly element: HTMLCanvasElement;
  private lines_mm: Float64Array[] = [];
  private lines: Float32Array[] = [];
  private isCut: readonly boolean[] = [];
  private highlighted = -1;
  private side = "z";
  private camera: Camera = initialCamera("z");
  private extent: Extent = lineExtent([], this.camera);
  /** Position of the pointer press, and whether it has turned the picture since. */
  private held: { x: number; y: number; turns: boolean } | null = null;
  private frame = 0;
  private readonly resizeObserver = new ResizeObserver(() => this.draw());
  private readonly removeThemeListener = onTheme(() => this.draw());

  constructor(private readonly on: ContourViewEvents) {
    this.element = element("canvas", {
      class: "contour-view",
      role: "img",
      tabindex: 0,
      "aria-label": words.label,
      onpointerdown: (event) => this.down(event as PointerEvent),
      onpointermove: (event) => this.move(event as PointerEvent),
      onpointerup: (event) => this.up(event as PointerEvent),
      onpointercancel: () => (this.held = null),
      onpointerleave: () => this.on.onPointed(-1),
      ondblclick: () => this.setCamera(initialCamera(this.side)),
      onwheel: (event) => this.onWheel(event as WheelEvent),
      onkeydown: (event) => this.key(event as KeyboardEvent),
    });
    this.resizeObserver.observe(this.element);
  }

  /** Shows other lines, seen from a side. */
  showLines(lines_mm: Float64Array[], side: string): void {
    this.lines_mm = lines_mm;
    this.side = side;
    this.extent = lineExtent(lines_mm, initialCamera(side));
    this.setCamera(initialCamera(side));
  }

  show(isCut: readonly boolean[], highlighted: number): void {
    this.isCut = isCut;
    this.highlighted = highlighted;
    this.draw();
  }

  end(): void {
    this.resizeObserver.disconnect();
    this.removeThemeListener();
    cancelAnimationFrame(this.frame);
  }

  private get size(): Size {
    return { width: this.element.clientWidth, height: this.element.clientHeight };
  }

  private setCamera(camera: Camera): void {
    this.camera = camera;
    this.draw();
  }

  private at(event: MouseEvent): [x: number, y: number] {
    const { left, top } = this.element.getBoundingClientRect();
    return [event.clientX - left - this.element.clientLeft, event.clientY - top - this.element.clientTop];
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0) return;
    const [x, y] = this.at(event);
    this.held = { x, y, turns: false };
    this.element.setPointerCapture(event.pointerId);
  }

  private move(event: PointerEvent): void {
    const [x, y] = this.at(event);
    if (!this.held) return this.on.onPointed(nearestLine(this.lines, x, y, HIT_DISTANCE_px));
    const { held } = this;
    if (!held.turns && Math.hypot(x - held.x, y - held.y) < MIN_DRAG_px) return;
    this.setCamera(turned(this.camera, x - held.x, y - held.y));
    this.held = { x, y, turns: true };
  }

  private up(event: PointerEvent): void {
    const { held } = this;
    this.held = null;
    if (!held || held.turns) return;
    const contour = nearestLine(this.lines, ...this.at(event), HIT_DISTANCE_px);
    if (contour >= 0) this.on.onClicked(contour);
  }

  private onWheel(event: WheelEvent): void {
    event.preventDefault();
    this.setCamera(zoomCamera(this.camera, event.deltaY < 0 ? ZOOM_FACTOR : 1 / ZOOM_FACTOR, this.extent, this.size, ...this.at(event)));
  }

  private key(event: KeyboardEvent): void {
    const turns: Record<string, [number, number]> = {
      ArrowLeft: [-KEY_STEP_px, 0],
      ArrowRight: [KEY_STEP_px, 0],
      ArrowUp: [0, -KEY_STEP_px],
      ArrowDown: [0, KEY_STEP_px],
    };
    const zoomKeys: Record<string, number> = { "+": ZOOM_FACTOR, "=": ZOOM_FACTOR, "-": 1 / ZOOM_FACTOR };
    const { width, height } = this.size;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key in turns) this.setCamera(turned(this.camera, ...turns[event.key]));
    else if (event.key in zoomKeys)
      this.setCamera(zoomCamera(this.camera, zoomKeys[event.key], this.extent, this.size, width / 2, height / 2));
    else if (event.key === "0") this.setCamera(initialCamera(this.side));
    else return;
    event.preventDefault();
  }

  /** With the next frame. */
  private draw(): void {
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => this.drawNow());
  }

  private drawNow(): void {
    const { element: canvas, size } = this;
    const context = canvas.getContext("2d");
    if (!context || size.width === 0 || size.height === 0) return;
    const ratio = window.devicePixelRatio;
    canvas.width = Math.round(size.width * ratio);
    canvas.height = Math.round(size.height * ratio);
    context.scale(ratio, ratio);
    context.lineJoin = "round";
    this.lines = this.lines_mm.map((line) => projectLine(line, this.extent, this.camera, size));
    const [accentColour, dimColour] = [themeColour("--accent"), themeColour("--dim")];
    const stroke = (i: number, width: number) => {
      context.strokeStyle = this.isCut[i] ? accentColour : dimColour;
      context.lineWidth = width;
      context.setLineDash(this.isCut[i] ? [] : [4, 3]);
      context.beginPath();
      const line = this.lines[i];
      for (let k = 0; k < line.length; k += 2) context.lineTo(line[k], line[k + 1]);
      context.stroke();
    };
    // Cut contours are drawn over uncut ones, and the one pointed at over all.
    this.lines.forEach((_, i) => !this.isCut[i] && stroke(i, 1.2));
    this.lines.forEach((_, i) => this.isCut[i] && stroke(i, 2));
    if (this.highlighted >= 0 && this.highlighted < this.lines.length) stroke(this.highlighted, 5);
  }
}
