// Makes a path from a drawing: its parts to cut, and the options. The result is a path file.

import { check, choice, element } from "../../core/dom";
import { namesOfKind, shortName } from "../../core/file_kinds";
import type { Session } from "../../core/session";
import type { Setup } from "../../core/setup";
import type { Store, Units } from "../../core/store";
import { texts } from "../../texts";
import { ContourFields, type ContourChoice } from "./contour_fields";
import { ContourPicker } from "./contour_picker";
import { materials, generatePath, type GeneratedPath } from "./engine_requests";
import { ChoiceRow, NumberRow, NumbersRow, TextRow, type Quantity } from "./fields";

const words = texts.paths.drawing;

/** Options as the engine takes them; it decides about undefined ones. */
export interface DrawingChoice {
  material: string;
  thickness_mm?: number;
  quality?: number;
  speed_mm_min?: number;
  kerf_mm?: number;
  pierce_s?: number;
  origin_mm: number[];
  lead_mm?: number;
  safe_height_mm?: number;
  cut_height_mm?: number;
  bevel_deg?: number;
  unit_mm?: number;
  curve_tolerance_mm?: number;
  gap_mm?: number;
  layers?: string[];
  /** For a solid: direction of its upper side, and whether it is turned over. */
  up?: string;
  flip?: boolean;
  /** For flat parts and drawings: the jet tilts against the taper of its kerf; it moves while it pierces. */
  taper_compensation?: boolean;
  dynamic_pierce?: boolean;
  /** For a solid that need not be flat. */
  contours?: ContourChoice;
  /** True if paths between cuts avoid the machine and cell of the setup. */
  avoidsCollisions?: boolean;
  /** Part that had contours removed, and an edge of each remaining one. */
  picked?: { drawing: string; edges: string[] };
}

type NumberKey = {
  [Key in keyof DrawingChoice]-?: DrawingChoice[Key] extends number | undefined ? Key : never;
}[keyof DrawingChoice];

/** Numbers, and the default of the engine (0: that of the material, or nothing to set). */
const numbers: Partial<Record<NumberKey, [quantity: Quantity, without: number | undefined]>> = {
  thickness_mm: ["length", undefined],
  quality: ["none", undefined],
  speed_mm_min: ["feed", undefined],
  kerf_mm: ["length", undefined],
  pierce_s: ["time", undefined],
  lead_mm: ["length", undefined],
  safe_height_mm: ["length", 25],
  cut_height_mm: ["length", 3],
  bevel_deg: ["angle", 0],
  curve_tolerance_mm: ["length", 0.005],
  gap_mm: ["length", 0.02],
};
const commonKeys: NumberKey[] = ["thickness_mm", "quality"];
const own: NumberKey[] = ["speed_mm_min", "kerf_mm", "pierce_s"];
const pathKeys: NumberKey[] = ["lead_mm", "safe_height_mm", "cut_height_mm", "bevel_deg"];
const rareKeys: NumberKey[] = ["curve_tolerance_mm", "gap_mm"];

/** True for parts, which the native engine reads. */
const isSolid = (name: string): boolean => /\.(step|stp|iges|igs)$/i.test(name);

/** Returns the files that a path can be made from. */
export function drawingFiles({ documents }: Session): string[] {
  return [...namesOfKind("drawing", documents), ...documents.names().filter(isSolid)];
}

/** undefined: all contours are cut. */
const selectedEdgesFor = (drawing: string, { picked }: DrawingChoice): string[] | undefined => (picked?.drawing === drawing ? picked.edges : undefined);

/** True if both choices select the same contours of a part. */
const haveSameContours = (a: ContourChoice | undefined, b: ContourChoice | undefined): boolean =>
  a?.kind === b?.kind && a?.side === b?.side && a?.faces?.join(";") === b?.faces?.join(";");

/** Returns the options that apply to the drawing, of all that were chosen for this one and others. */
function drawingRequest(drawing: string, choice: DrawingChoice, { machine, cell, machine_data }: Readonly<Setup>) {
  const { material, up, flip, contours, picked, avoidsCollisions, taper_compensation, dynamic_pierce, bevel_deg, unit_mm, layers, ...rest } = choice;
  const common = {
    drawing,
    ...rest,
    material: material || undefined,
    place: avoidsCollisions ? { machine, cell, machine_data } : undefined,
  };
  if (isSolid(drawing) && contours) return { ...common, contours: { ...contours, edges: selectedEdgesFor(drawing, choice) } };
  const jetOptions = { taper_compensation: material ? taper_compensation : undefined, dynamic_pierce, bevel_deg };
  return isSolid(drawing) ? { ...common, ...jetOptions, up, flip } : { ...common, ...jetOptions, unit_mm, layers };
}

export const defaultDrawingChoice: DrawingChoice = { material: "", origin_mm: [0, 0, 0] };

export interface DrawingEvents {
  /** Called with the choice, to offer it again. */
  chosen(choice: DrawingChoice): void;
  /** What was made, and what of. */
  made(path: GeneratedPath, drawing: string): void;
}

export class DrawingDialog {
  private readonly element: HTMLDialogElement;
  private readonly rows = new Map<NumberKey, NumberRow>();
  private readonly material = new ChoiceRow<string>(words.material, [], (material) => this.set({ material }));
  private readonly origin = new NumbersRow(words.origin, ["X", "Y", "Z"], "length", (values) =>
    this.set({ origin_mm: values.map((value) => value ?? 0) }),
  );
  private readonly unit = new ChoiceRow<string>(
    words.unit,
    [
      ["", words.unitOfDrawing],
      ["1", "mm"],
      ["25.4", "inch"],
    ],
    (unit) => this.set({ unit_mm: unit ? Number(unit) : undefined }),
  );
  private readonly layers = new TextRow(words.layers, (text) => {
    const names = text.split(",").map((name) => name.trim());
    this.set({ layers: text.trim() ? names.filter((name) => name !== "") : undefined });
  });
  private readonly up = new ChoiceRow<string>(
    words.up,
    [["", words.largest], ...["x", "y", "z", "-x", "-y", "-z"].map((each) => [each, each] as const)],
    (up) => this.set({ up: up || undefined }),
  );
  private readonly flip = check(words.flip, (flip) => this.set({ flip: flip || undefined }));
  private readonly plateGroup = element("div", { class: "group" }, this.up.element, this.flip.row);
  private readonly contours = new ContourFields((contours) =>
    this.set(haveSameContours(contours, this.choice.contours) ? { contours } : { contours, picked: undefined }),
  );
  private readonly picker: ContourPicker;
  private readonly solidGroup = element("div", { class: "group" }, this.contours.element, this.plateGroup);
  private readonly taperCompensation = check(words.taperCompensation, (taper_compensation) => this.set({ taper_compensation: taper_compensation || undefined }));
  private readonly moving = check(words.movingPierce, (moving) => this.set({ dynamic_pierce: moving || undefined }));
  private readonly avoidsCollisions = check(words.avoidsCollisions, (avoidsCollisions) =>
    this.set({ avoidsCollisions: avoidsCollisions || undefined }),
  );
  private readonly accuracy = element("div", { class: "group" }, this.moving.row, this.taperCompensation.row);
  private readonly refused = element("p", { class: "fault", role: "alert", hidden: true });
  private readonly make = element("button", { type: "submit", class: "primary" }, words.make);
  private readonly materialGroup = element("div", { class: "group" });
  private readonly customGroup = element("div", { class: "group" });
  /** True if own values override those of the material. */
  private overridesMaterial = false;
  private readonly own = check(words.own, (on) => {
    this.overridesMaterial = on;
    this.set(on ? {} : { speed_mm_min: undefined, kerf_mm: undefined, pierce_s: undefined });
  });
  private materials: string[] = [];

  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private drawing: string,
    private choice: DrawingChoice,
    private readonly on: DrawingEvents,
  ) {
    for (const [key, known] of Object.entries(numbers) as [NumberKey, [Quantity, number | undefined]][]) {
      this.rows.set(key, new NumberRow(words.numbers[key as keyof typeof words.numbers], known[0], (value) => this.set({ [key]: value })));
    }
    this.overridesMaterial = own.some((key) => choice[key] !== undefined);
    this.picker = new ContourPicker(session, (edges) => this.set({ picked: edges && { drawing: this.drawing, edges } }));
    this.element = this.build();
    document.body.append(this.element);
    this.element.showModal();
    this.show();
    void this.loadMaterials();
  }

  private build(): HTMLDialogElement {
    const of = (keys: NumberKey[]) => keys.map((key) => this.rows.get(key)!.element);
    const drawingNames = drawingFiles(this.session).map((name) => [name, shortName(name)] as const);
    const chooser = choice(words.drawing, drawingNames, this.drawing, (name) => {
      this.drawing = name;
      this.show();
    });
    this.customGroup.append(...of(own));
    this.materialGroup.append(...of(commonKeys), this.own.row);
    const form = element(
      "form",
      { class: "form", onsubmit: (event) => this.submit(event) },
      element("label", { class: "field" }, element("span", { class: "field-name" }, words.drawing), chooser),
      this.material.element,
      this.materialGroup,
      this.customGroup,
      this.accuracy,
      this.solidGroup,
      this.origin.element,
      this.avoidsCollisions.row,
      element("details", {}, element("summary", {}, words.cuttingPath), ...of(pathKeys)),
      element("details", {}, element("summary", {}, words.reading), this.unit.element, this.layers.element, ...of(rareKeys)),
      this.refused,
      element("div", { class: "buttons" }, this.make, element("button", { type: "button", onclick: () => this.element.close() }, words.cancel)),
    );
    const attributes = { class: "drawing-dialog", "aria-label": words.title, onclose: () => this.end() };
    return element("dialog", attributes, element("h2", {}, words.title), element("div", { class: "columns" }, form, this.picker.element));
  }

  private end(): void {
    this.picker.end();
    this.element.remove();
  }

  private async loadMaterials(): Promise<void> {
    this.materials = await materials(this.session);
    this.show();
  }

  private set(change: Partial<DrawingChoice>): void {
    this.choice = { ...this.choice, ...change };
    this.on.chosen(this.choice);
    this.show();
  }

  private show(): void {
    const units = this.store.get("units");
    for (const [key, row] of this.rows) row.show({ value: this.choice[key], inherited: numbers[key]![1] }, units);
    this.material.setOptions([["", words.noMaterial], ...this.materials.map((name) => [name, name] as const)], this.choice.material);
    this.materialGroup.hidden = this.choice.material === "";
    this.own.box.checked = this.overridesMaterial;
    this.customGroup.hidden = !this.overridesMaterial && this.choice.material !== "";
    const isSurface = isSolid(this.drawing) && this.choice.contours !== undefined;
    this.solidGroup.hidden = !isSolid(this.drawing);
    this.plateGroup.hidden = isSurface;
    this.contours.show(this.choice.contours, units);
    this.showPicker(units);
    this.accuracy.hidden = isSurface;
    this.taperCompensation.box.checked = this.choice.taper_compensation ?? false;
    this.taperCompensation.row.hidden = this.choice.material === "";
    this.moving.box.checked = this.choice.dynamic_pierce ?? false;
    this.rows.get("bevel_deg")!.element.hidden = isSurface;
    this.up.show(this.choice.up ?? "");
    this.flip.box.checked = this.choice.flip ?? false;
    this.origin.show(this.choice.origin_mm, units);
    this.avoidsCollisions.box.checked = this.choice.avoidsCollisions ?? false;
    this.unit.show(this.choice.unit_mm ? String(this.choice.unit_mm) : "");
    this.layers.show(this.choice.layers?.join(", ") ?? "", words.allLayers);
  }

  private showPicker(units: Units): void {
    const { drawing, choice } = this;
    const { contours, curve_tolerance_mm } = choice;
    const source = isSolid(drawing) && contours ? { drawing, curve_tolerance_mm, contours } : null;
    this.element.classList.toggle("with-picture", source !== null);
    this.picker.show(source, selectedEdgesFor(drawing, choice), units);
  }

  private refuse(sentence: string): void {
    this.refused.hidden = sentence === "";
    this.refused.textContent = sentence;
  }

  private async submit(event: Event): Promise<void> {
    event.preventDefault();
    const { drawing } = this;
    if (this.choice.contours && isSolid(drawing) && selectedEdgesFor(drawing, this.choice)?.length === 0) return this.refuse(texts.paths.contours.picture.noneCut);
    this.make.disabled = true;
    const made = await generatePath(this.session, drawingRequest(drawing, this.choice, this.session.setup));
    this.make.disabled = false;
    // Cancelled meanwhile.
    if (!this.element.open) return;
    this.refuse("refused" in made ? made.refused : "");
    if ("refused" in made) return;
    this.element.close();
    this.on.made(made, drawing);
  }
}
