// Contours of a part in words: the functions of the picture for the keyboard and for screen readers.

import { check, element } from "../../core/dom";
import type { Units } from "../../core/store";
import { lengthShort } from "../../core/units";
import { texts } from "../../texts";
import type { ListedContour } from "./contour_picks";

const words = texts.paths.contours.picture;

/** "hole at edge #705 of the plane face #933, 56.55 mm long, 6.00 mm deep, leans by 12.0°" */
export function contourText({ face, isHole, edges, length_mm, depth_mm, tilt_deg }: ListedContour, units: Units): string {
  const kind = isHole ? words.hole : words.outline;
  const [length, depth] = [lengthShort(length_mm, units), lengthShort(depth_mm, units)];
  return words.contour(kind, edges.find((edge) => edge !== "") ?? "", face, length, depth, tilt_deg.toFixed(1));
}

export interface ContourListEvents {
  /** Called with the contour of the row with the pointer or the focus; -1: none. */
  onPointed(contour: number): void;
  onToggled(contour: number, isCut: boolean): void;
}

export class ContourList {
  readonly element = element("ul", { class: "contour-list", "aria-label": words.list });
  private boxes: HTMLInputElement[] = [];
  private rows: HTMLElement[] = [];

  constructor(private readonly on: ContourListEvents) {}

  showContours(contours: readonly ListedContour[], units: Units, areSelectable: boolean): void {
    const made = contours.map((contour, i) => check(contourText(contour, units), (isCut) => this.on.onToggled(i, isCut)));
    this.boxes = made.map(({ box }) => box);
    this.rows = made.map(({ row, box }, i) => {
      box.disabled = !areSelectable;
      const point = () => this.on.onPointed(i);
      const leave = () => this.on.onPointed(-1);
      return element("li", { onpointerenter: point, onpointerleave: leave, onfocusin: point, onfocusout: leave }, row);
    });
    this.element.replaceChildren(...this.rows);
  }

  show(isCut: readonly boolean[], highlighted: number): void {
    this.boxes.forEach((box, i) => (box.checked = isCut[i]));
    this.rows.forEach((row, i) => row.classList.toggle("highlighted", i === highlighted));
  }

  /** Scrolls to the contour pointed at in the picture. */
  scrollTo(contour: number): void {
    this.rows[contour]?.scrollIntoView({ block: "nearest" });
  }
}
