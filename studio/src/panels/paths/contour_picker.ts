// Contours of a part that can be cut, as a picture and a list to choose from. A new request is sent if the
// fields choose other contours.

import { element } from "../../core/dom";
import type { Session } from "../../core/session";
import type { Units } from "../../core/store";
import { texts } from "../../texts";
import type { ContourChoice } from "./contour_fields";
import { ContourList, contourText } from "./contour_list";
import { areSelectable, selectedContours, selectedEdges, keepKnownEdges, toggleContour, type ListedContour } from "./contour_picks";
import { ContourView } from "./contour_view";
import { readContours } from "./engine_requests";

const words = texts.paths.contours.picture;

/** Part, and the fields that choose its contours. */
export interface ContourSource {
  drawing: string;
  curve_tolerance_mm: number | undefined;
  contours: ContourChoice;
}

/** Returns the request to the engine, which other fields do not change. */
function contourRequest({ drawing, curve_tolerance_mm, contours: { kind, side, faces, axis } }: ContourSource) {
  return { drawing, curve_tolerance_mm, contours: { kind, side, faces, axis } };
}

export class ContourPicker {
  readonly element: HTMLElement;
  private readonly view = new ContourView({
    onPointed: (contour) => this.point(contour, true),
    onClicked: (contour) => this.toggle(contour),
  });
  private readonly list = new ContourList({
    onPointed: (contour) => this.point(contour, false),
    onToggled: (contour, isCut) => this.setSelected(contour, isCut),
  });
  private readonly status = element("p", { class: "status", role: "status" });
  private readonly error = element("p", { class: "fault", role: "alert", hidden: true });
  private readonly pointedLabel = element("p", { class: "pointed-at", "aria-hidden": "true" });
  private readonly notes = element("ul", { class: "notes" });
  private readonly all = element("button", { type: "button", onclick: () => this.pick(this.isCut.map(() => true)) }, words.all);
  private readonly none = element("button", { type: "button", onclick: () => this.pick(this.isCut.map(() => false)) }, words.none);
  private readonly found: HTMLElement;
  private contours: ListedContour[] = [];
  private picks: readonly string[] | undefined;
  private isCut: boolean[] = [];
  private highlighted = -1;
  private units: Units = "mm";
  /** Wanted request, and the request of the known result, as text. Empty: none. */
  private requested = "";
  private known = "";
  private isRequestPending = false;

  /** `picked`: an edge of each contour that is cut; undefined: all are. */
  constructor(
    private readonly session: Session,
    private readonly picked: (edges: string[] | undefined) => void,
  ) {
    const buttons = element("div", { class: "buttons" }, this.all, this.none);
    const picture = element("div", { class: "picture" }, this.view.element, this.pointedLabel);
    this.found = element("div", { class: "found" }, picture, element("div", { class: "listed" }, buttons, this.list.element), this.notes);
    this.element = element("section", { class: "contour-picker", "aria-label": words.title }, this.status, this.error, this.found);
  }

  /** A source of null: nothing can be chosen. */
  show(source: ContourSource | null, picks: readonly string[] | undefined, units: Units): void {
    this.element.hidden = source === null;
    this.requested = source ? JSON.stringify(contourRequest(source)) : "";
    this.picks = picks;
    if (units !== this.units) {
      this.units = units;
      this.showContours();
    }
    this.showPicks();
    this.showState();
    void this.ask();
  }

  end(): void {
    this.requested = "";
    this.view.end();
  }

  /**
   * Sends one request at a time. A request that comes meanwhile is sent after it, and an outdated response
   * changes nothing.
   */
  private async ask(): Promise<void> {
    if (this.isRequestPending) return;
    this.isRequestPending = true;
    while (this.requested !== "" && this.requested !== this.known) {
      const asked = this.requested;
      this.showState();
      const response = await readContours(this.session, JSON.parse(asked) as Record<string, unknown>);
      if (asked !== this.requested) continue;
      this.known = asked;
      this.contours = "refused" in response ? [] : response.contours;
      this.error.textContent = "refused" in response ? response.refused : "";
      this.notes.replaceChildren(...("refused" in response ? [] : response.notes).map((note) => element("li", {}, note)));
      this.accept(asked);
    }
    this.isRequestPending = false;
    this.showState();
  }

  private accept(asked: string): void {
    const { contours } = JSON.parse(asked) as ContourSource;
    this.highlighted = -1;
    this.view.showLines(
      this.contours.map(({ polyline_mm }) => polyline_mm),
      contours.side ?? "z",
    );
    this.showContours();
    const known = keepKnownEdges(this.contours, this.picks);
    if (this.contours.length > 0 && known?.join() !== this.picks?.join()) this.picked(known);
    this.showPicks();
  }

  private toggle(contour: number): void {
    if (areSelectable(this.contours)) this.setSelected(contour, !this.isCut[contour]);
  }

  private setSelected(contour: number, isCut: boolean): void {
    this.pick(toggleContour(this.contours, this.isCut, contour, isCut));
  }

  private pick(isCut: readonly boolean[]): void {
    this.picked(selectedEdges(this.contours, isCut));
  }

  private point(contour: number, inPicture: boolean): void {
    if (contour === this.highlighted) return;
    this.highlighted = contour;
    if (inPicture && contour >= 0) this.list.scrollTo(contour);
    this.showPicks();
  }

  private showContours(): void {
    this.list.showContours(this.contours, this.units, areSelectable(this.contours));
  }

  private showPicks(): void {
    const { contours, highlighted } = this;
    this.isCut = selectedContours(contours, this.picks);
    this.view.show(this.isCut, highlighted);
    this.list.show(this.isCut, highlighted);
    this.pointedLabel.textContent = highlighted < 0 ? words.hint : contourText(contours[highlighted], this.units);
    this.element.classList.toggle("pointed", highlighted >= 0);
  }

  private showState(): void {
    const isKnown = this.known === this.requested;
    const { contours } = this;
    this.found.hidden = !isKnown || contours.length === 0;
    this.error.hidden = !isKnown || this.error.textContent === "";
    const cut = this.isCut.filter(Boolean).length;
    const count = areSelectable(contours) ? words.cut(cut, contours.length) : words.unnumbered(contours.length);
    this.status.textContent = !isKnown ? words.asking : contours.length > 0 ? count : "";
    this.all.disabled = this.none.disabled = !areSelectable(contours);
  }
}
