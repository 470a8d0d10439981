// Draws the strip of the scrubber: ticks, marks, kinds of motion, process on.

import { grey, kindColours, orange, purple, vermilion, yellow } from "../core/colours";
import { themeColour } from "../core/theme";
import { timeText } from "../core/units";
import { markKinds, type Mark, type MarkKind } from "../run/marks";
import { SAME_TIME_S } from "../run/report";
import { moveKinds } from "../run/kinds";
import { decodeKind, type Segments } from "../run/segments";
import { isProcessOnWithin } from "./process";
import { firstAfter } from "./steps";
import { ticks, type TimeWindow } from "./time_window";

/** Contents of the strip for one robot. */
export interface Content {
  segments: Segments;
  marks: readonly Mark[];
  process_s: Float64Array;
}

const markColours: Record<MarkKind, string> = {
  alarm: vermilion,
  collision: vermilion,
  violation: vermilion,
  zone: purple,
  motor: orange,
  finding: yellow,
  near: orange,
  event: grey,
};

// Rows, px from the top.
const STRIP_HEIGHT = 50;
const TICKS_ROW = { top: 0, height: 14 };
const MARKS_ROW = { top: 15, height: 12 };
const KINDS_ROW = { top: 29, height: 11 };
const PROCESS_ROW = { top: 41, height: 6 };

/** Column of pixels of an instant. */
export const timePixel = (window: TimeWindow, width: number, t_s: number): number =>
  window.span_s > 0 ? ((t_s - window.start_s) / window.span_s) * width : 0;

export function drawStrip(canvas: HTMLCanvasElement, window: TimeWindow, content: Content | null): void {
  const width = canvas.clientWidth;
  const ratio = devicePixelRatio;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(STRIP_HEIGHT * ratio);
  const ctx = canvas.getContext("2d")!;
  ctx.scale(ratio, ratio);
  ctx.fillStyle = themeColour("--bg");
  ctx.fillRect(0, KINDS_ROW.top, width, KINDS_ROW.height);
  if (!content || content.segments.count === 0) return;
  drawTicks(ctx, window, width);
  drawKinds(ctx, window, width, content.segments);
  drawProcess(ctx, window, width, content.process_s);
  drawMarks(ctx, window, width, content.marks);
}

function drawTicks(ctx: CanvasRenderingContext2D, window: TimeWindow, width: number): void {
  const { at_s, digits } = ticks(window.start_s, window.end_s, width / 90);
  ctx.font = "11px system-ui, sans-serif";
  ctx.textBaseline = "top";
  for (const t_s of at_s) {
    const x = timePixel(window, width, t_s);
    ctx.fillStyle = themeColour("--line");
    ctx.fillRect(x, TICKS_ROW.top, 1, MARKS_ROW.top + MARKS_ROW.height);
    ctx.fillStyle = themeColour("--dim");
    ctx.fillText(timeText(t_s, digits), x + 3, TICKS_ROW.top + 1);
  }
}

/** Draws adjacent columns of one kind as one rectangle. */
function drawKinds(ctx: CanvasRenderingContext2D, window: TimeWindow, width: number, segments: Segments): void {
  let from = 0;
  let kind = -1;
  for (let x = 0; x <= width; ++x) {
    const t_s = window.start_s + ((x + 0.5) / width) * window.span_s;
    const flags = x === width ? null : segments.flagsAt(t_s);
    const here = flags === null ? -1 : decodeKind(flags);
    if (here === kind) continue;
    if (kind >= 0) {
      ctx.fillStyle = kindColours[moveKinds[kind]];
      ctx.fillRect(from, KINDS_ROW.top, x - from, KINDS_ROW.height);
    }
    [from, kind] = [x, here];
  }
}

function drawProcess(ctx: CanvasRenderingContext2D, window: TimeWindow, width: number, edges_s: Float64Array): void {
  ctx.fillStyle = themeColour("--dim");
  const step_s = window.span_s / width;
  for (let x = 0; x < width; ++x) {
    const t_s = window.start_s + x * step_s;
    if (isProcessOnWithin(edges_s, t_s, t_s + step_s)) ctx.fillRect(x, PROCESS_ROW.top, 1, PROCESS_ROW.height);
  }
}

/** Draws only the most severe mark in a column of pixels. */
function drawMarks(ctx: CanvasRenderingContext2D, window: TimeWindow, width: number, marks: readonly Mark[]): void {
  const mostSevere = new Map<number, MarkKind>();
  const rank = (kind: MarkKind) => markKinds.indexOf(kind);
  for (let i = firstAfter(marks, window.start_s - SAME_TIME_S); i < marks.length && marks[i].t_s <= window.end_s; ++i) {
    const x = Math.round(timePixel(window, width, marks[i].t_s));
    const known = mostSevere.get(x);
    if (known === undefined || rank(marks[i].kind) < rank(known)) mostSevere.set(x, marks[i].kind);
  }
  const ascendingSeverity = [...mostSevere].sort((a, b) => rank(b[1]) - rank(a[1]));
  for (const [x, kind] of ascendingSeverity) drawMark(ctx, x, kind);
}

/** Draws a shape for each kind, in addition to colours: bar, triangle, cross, diamond, circle. */
function drawMark(ctx: CanvasRenderingContext2D, x: number, kind: MarkKind): void {
  const [top, bottom] = [MARKS_ROW.top, MARKS_ROW.top + MARKS_ROW.height];
  const middle = (top + bottom) / 2;
  ctx.fillStyle = ctx.strokeStyle = markColours[kind];
  ctx.lineWidth = 2;
  ctx.beginPath();
  if (kind === "event") ctx.rect(x - 1, top + 2, 2, bottom - top);
  else if (kind === "collision") lines(ctx, [x - 4, top + 2, x + 4, bottom - 2], [x - 4, bottom - 2, x + 4, top + 2]);
  else if (kind === "near") ctx.arc(x, middle, 4, 0, 7);
  else if (kind === "finding") polygon(ctx, [x, top + 1, x + 5, middle, x, bottom - 1, x - 5, middle]);
  else if (kind === "zone") ctx.rect(x - 4, top + 2, 8, 8);
  else polygon(ctx, [x - 5, top + 1, x + 5, top + 1, x, bottom]);
  if (kind === "collision" || kind === "near") return ctx.stroke();
  ctx.fill();
  if (kind === "finding") {
    ctx.strokeStyle = themeColour("--dim");
    ctx.lineWidth = 1;
    ctx.stroke();
  }
}

function polygon(ctx: CanvasRenderingContext2D, points: number[]): void {
  for (let i = 0; i < points.length; i += 2) ctx.lineTo(points[i], points[i + 1]);
  ctx.closePath();
}

function lines(ctx: CanvasRenderingContext2D, ...all: [number, number, number, number][]): void {
  for (const [x1, y1, x2, y2] of all) {
    ctx.moveTo(x1, y1);
    ctx.lineTo(x2, y2);
  }
}
