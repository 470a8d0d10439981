// One chart: curves with their limits, the points at which limits are exceeded, the shown instant.

import uPlot from "uplot";
import { element } from "../../core/dom";
import { themeColour } from "../../core/theme";
import { vermilion } from "../../core/colours";
import { ticks, type TimeWindow } from "../time_window";
import type { Curves } from "./curves";
import type { Limit } from "./limit_lines";
import { areaPaths, linePaths } from "./paths";
import { short } from "./traces";
import type { ScaleId, Trace } from "./trace";

/** Width to the left of the plot (px), so that charts and scrubber are aligned. */
export const LEFT_PX = 62;
export const RIGHT_PX = 58;
const TOP_PX = 6;
const BOTTOM_PX = 6;
/** Height of a limit's name. */
const LABEL_PX = 10;

export interface ChartActions {
  choose(t_s: number): void;
  /** null: the pointer has left. */
  hover(t_s: number | null): void;
}

export class Chart {
  readonly element: HTMLElement;
  private readonly plot: uPlot;
  private readonly now = element("div", { class: "now" });
  private readonly values: HTMLElement[];
  private areColumns = false;
  /** For traces that are limits, the value nearest to 0. */
  private nearest: { scale: ScaleId; value: number }[] = [];

  constructor(
    title: string,
    private readonly traces: Trace[],
    private readonly window: TimeWindow,
    private readonly marks_s: readonly number[],
    actions: ChartActions,
  ) {
    this.values = traces.map(() => element("b"));
    // A limit in both directions is listed once.
    const legend = traces.filter(({ isLimit, factor }) => !isLimit || factor > 0).map((trace) =>
      element(
        "span",
        { class: "trace" },
        element("i", { class: trace.dashed ? "dashed" : "", style: `--colour:${trace.colour}` }),
        `${trace.name} `,
        this.values[traces.indexOf(trace)],
      ),
    );
    const head = element("div", { class: "chart-head" }, element("span", { class: "chart-title" }, title), ...legend);
    this.element = element("div", { class: "chart", role: "img", "aria-label": title }, head);
    this.plot = new uPlot(this.options(actions), [[0], ...traces.map(() => [null])], this.element);
    this.plot.over.append(this.now);
    this.listen(actions);
  }

  private get scales(): ScaleId[] {
    return [...new Set(this.traces.map((trace) => trace.scale))].slice(0, 2);
  }

  private options(actions: ChartActions): uPlot.Options {
    const scales: uPlot.Scales = { x: { time: false, auto: false, range: () => this.displayed } };
    for (const scale of this.scales) scales[scale] = { range: (_, low, high) => this.range(scale, low, high) };
    return {
      width: 300,
      height: 100,
      padding: [TOP_PX, this.scales.length > 1 ? 0 : RIGHT_PX, BOTTOM_PX, this.scales.length > 0 ? 0 : LEFT_PX],
      legend: { show: false },
      cursor: {
        y: false,
        points: { show: false },
        drag: { x: true, y: false, setScale: false },
        bind: { dblclick: () => () => (this.window.reset(), null) },
      },
      scales,
      axes: [this.timeAxis(), ...this.scales.map((scale, i) => this.valueAxis(scale, i))],
      series: [{}, ...this.traces.map((trace) => this.series(trace))],
      hooks: {
        draw: [() => this.drawLimits(), () => this.drawMarks()],
        setSelect: [() => this.zoomToSelection()],
        setCursor: [(plot) => this.reportHover(plot, actions)],
      },
    };
  }

  private get displayed(): [number, number] {
    return [this.window.start_s, this.window.end_s];
  }

  /** The scrubber has the numbers. */
  private timeAxis(): uPlot.Axis {
    return {
      size: 0,
      gap: 0,
      ticks: { show: false },
      grid: { stroke: () => themeColour("--line"), width: 1 },
      splits: () => ticks(...this.displayed, this.plot ? this.plot.bbox.width / devicePixelRatio / 90 : 8).at_s,
      values: (_, splits) => splits.map(() => ""),
    };
  }

  private valueAxis(scale: ScaleId, index: number): uPlot.Axis {
    return {
      scale,
      side: index === 0 ? 3 : 1,
      size: index === 0 ? LEFT_PX : RIGHT_PX,
      gap: 4,
      space: 22,
      font: "11px system-ui, sans-serif",
      stroke: () => themeColour("--dim"),
      ticks: { show: false },
      grid: { show: index === 0, stroke: () => themeColour("--line"), width: 1 },
      values: (_, splits) => splits.map((value) => `${Number(value.toPrecision(6))}`),
    };
  }

  private series(trace: Trace): uPlot.Series {
    return {
      scale: trace.scale,
      auto: !trace.isLimit,
      stroke: trace.colour,
      fill: trace.colour,
      width: 1.25,
      pxAlign: 0, // slopes without steps
      dash: trace.dashed ? [5, 3] : undefined,
      points: { show: false },
      paths: (...of) => (this.areColumns && !trace.dashed ? areaPaths(...of) : linePaths(...of)),
    };
  }

  private limitsOf(scale: ScaleId): Limit[] {
    return this.traces.filter((trace) => trace.scale === scale).flatMap((trace) => trace.limits);
  }

  /** Returns the range of all values, and of limits that are not far beyond them. */
  private range(scale: ScaleId, low: number | null, high: number | null): [number, number] {
    const zero = this.traces.some((trace) => trace.scale === scale && trace.fromZero);
    let [from, to] = zero ? [Math.min(low ?? 0, 0), Math.max(high ?? 0, 0)] : [low ?? 0, high ?? 0];
    const [bottom, top] = [from - (to - from), to + (to - from)];
    for (const { value } of [...this.limitsOf(scale), ...this.nearest.filter((end) => end.scale === scale)]) {
      if (value >= bottom && value <= top) [from, to] = [Math.min(from, value), Math.max(to, value)];
    }
    const margin = to > from ? 0.04 * (to - from) : Math.max(Math.abs(to) * 0.1, 1);
    return [from < 0 || from === to ? from - margin : from, to + margin];
  }

  private drawLimits(): void {
    const { ctx, bbox } = this.plot;
    ctx.save();
    ctx.font = `${10 * devicePixelRatio}px system-ui, sans-serif`;
    ctx.textAlign = "left";
    ctx.textBaseline = "middle";
    const labelled = new Set<string>();
    const labels_px: number[] = [];
    for (const scale of this.scales) {
      const { min, max } = this.plot.scales[scale];
      for (const { value, label, colour } of this.limitsOf(scale)) {
        if (value < min! || value > max! || labelled.has(`${label} ${value}`)) continue;
        labelled.add(`${label} ${value}`);
        const y = this.plot.valToPos(value, scale, true);
        ctx.strokeStyle = ctx.fillStyle = colour;
        ctx.lineWidth = devicePixelRatio;
        ctx.setLineDash([6 * devicePixelRatio, 4 * devicePixelRatio]);
        ctx.beginPath();
        ctx.moveTo(bbox.left, y);
        ctx.lineTo(bbox.left + bbox.width, y);
        ctx.stroke();
        // Overlapping labels would not be legible.
        if (this.scales.length > 1 || labels_px.some((other) => Math.abs(other - y) < LABEL_PX * devicePixelRatio)) continue;
        labels_px.push(y);
        ctx.fillText(label, bbox.left + bbox.width + 4 * devicePixelRatio, y);
      }
    }
    ctx.restore();
  }

  private drawMarks(): void {
    const { ctx, bbox } = this.plot;
    ctx.save();
    ctx.strokeStyle = ctx.fillStyle = vermilion;
    ctx.lineWidth = devicePixelRatio;
    const size = 5 * devicePixelRatio;
    let last = -Infinity;
    for (const t_s of this.marks_s) {
      if (t_s < this.window.start_s || t_s > this.window.end_s) continue;
      const x = this.plot.valToPos(t_s, "x", true);
      if (x - last < 1) continue;
      last = x;
      ctx.globalAlpha = 0.5;
      ctx.fillRect(x, bbox.top, devicePixelRatio, bbox.height);
      ctx.globalAlpha = 1;
      ctx.beginPath();
      ctx.moveTo(x - size, bbox.top);
      ctx.lineTo(x + size, bbox.top);
      ctx.lineTo(x, bbox.top + 1.5 * size);
      ctx.fill();
    }
    ctx.restore();
  }

  private zoomToSelection(): void {
    const { left, width } = this.plot.select;
    if (width < 3) return;
    const [from_s, to_s] = [this.plot.posToVal(left, "x"), this.plot.posToVal(left + width, "x")];
    this.plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.window.set(from_s, to_s);
  }

  private reportHover(plot: uPlot, actions: ChartActions): void {
    const left = plot.cursor.left ?? -1;
    actions.hover(left < 0 ? null : plot.posToVal(left, "x"));
  }

  private listen(actions: ChartActions): void {
    const { over } = this.plot;
    const at_s = (event: MouseEvent) => this.plot.posToVal(event.clientX - over.getBoundingClientRect().left, "x");
    over.addEventListener("click", (event) => actions.choose(at_s(event)));
    over.addEventListener(
      "wheel",
      (event) => {
        if (event.ctrlKey) this.window.zoom(at_s(event), Math.exp(event.deltaY / 400));
        else if (event.shiftKey) this.window.pan((this.window.span_s * (event.deltaX + event.deltaY)) / 1000);
        else return;
        event.preventDefault();
      },
      { passive: false },
    );
  }

  resize(width: number, height: number): void {
    const inner = height - (this.element.firstElementChild as HTMLElement).offsetHeight;
    if (this.plot.width !== width || this.plot.height !== inner) this.plot.setSize({ width, height: inner });
  }

  show(curves: Curves): void {
    this.areColumns = curves.areColumns;
    const displayed = this.traces.map((trace) => curves.values[trace.channel].map((value) => displayedValue(trace, value)));
    this.nearest = this.traces.flatMap(({ isLimit, scale }, i) => {
      return isLimit ? [{ scale, value: nearestToZero(displayed[i]) }] : [];
    });
    this.plot.batch(() => {
      this.plot.setData([curves.t_s, ...displayed] as uPlot.AlignedData, false);
      this.plot.setScale("x", { min: this.window.start_s, max: this.window.end_s });
    });
  }

  /** Shows the instant, and the values at it or under the pointer. */
  point(now_s: number, values: ArrayLike<number>): void {
    const x = this.plot.valToPos(now_s, "x");
    const inside = now_s >= this.window.start_s && now_s <= this.window.end_s;
    this.now.style.transform = `translateX(${x}px)`;
    this.now.hidden = !inside;
    this.traces.forEach((trace, i) => {
      const value = displayedValue(trace, values[trace.channel]);
      this.values[i].textContent = value === null ? "–" : withUnit(value, trace.unit);
    });
  }

  destroy(): void {
    this.plot.destroy();
    this.element.remove();
  }
}

function nearestToZero(values: readonly (number | null)[]): number {
  let nearest = Infinity;
  for (const value of values) if (value !== null && Math.abs(value) < Math.abs(nearest)) nearest = value;
  return nearest;
}

const displayedValue = (trace: Trace, value: number): number | null =>
  Number.isFinite(value) ? trace.offset + trace.factor * value : null;

/** "12.3°", "1234 mm/min" */
const withUnit = (value: number, unit: string): string => `${short(value)}${unit.startsWith("°") ? "" : " "}${unit}`;
