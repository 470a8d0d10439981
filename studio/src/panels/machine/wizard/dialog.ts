// Makes a machine file from a kind of machine, its sizes, speeds and controller; it is shown, and checked,
// before it is used.

import { Debounced } from "../../../core/debounced";
import { arrange, choice, element, setOptions } from "../../../core/dom";
import { texts } from "../../../texts";
import type { CheckResponse } from "../file/model";
import type { TomlPath } from "../file/toml";
import type { Context } from "../form/context";
import { Field, type FieldSpec } from "../form/field";
import { keyLabel, keyUnit } from "../form/quantity";
import { CheckResult } from "../sections/check";
import { ErrorList } from "../sections/error_list";
import { MachineDraft, type NewMachineFile } from "./draft";
import { kindNames, type KindName } from "./kinds";

const words = texts.machine.wizard;
const PAUSE_MS = 200;

const AXIS_KEYS = ["min", "max", "max_speed", "max_acceleration", "max_jerk", "home"] as const;
const PATH_KEYS = ["max_feed_mm_s", "max_rapid_mm_s", "max_acceleration_mm_s2"];
const powers = { max_speed: "_s", max_acceleration: "_s2", max_jerk: "_s3" } as Record<string, string>;

/** Returns the full key: "max_speed" of a rotary axis is "max_speed_deg_s". */
const fullKey = (key: string, isRotary: boolean): string => `${key}_${isRotary ? "deg" : "mm"}${powers[key] ?? ""}`;

const isPositiveLimit = (key: string): boolean => key.startsWith("max_") && !/^max_(mm|deg)$/.test(key);

class Wizard {
  private readonly dialog: HTMLDialogElement;
  private readonly kind: HTMLSelectElement;
  private readonly about = element("p", { class: "note" });
  private readonly fields = element("div", { class: "wizard-fields" });
  private readonly file = element("b", {});
  private readonly text = element("pre", { tabindex: 0, "aria-label": words.text });
  private readonly errors = new ErrorList(null);
  private readonly check = new CheckResult();
  private readonly accept = element("button", { type: "button", class: "primary", onclick: () => void this.onAccept() }, words.accept);
  private readonly updateTimer = new Debounced(() => void this.make());
  private draft: MachineDraft;
  private made: NewMachineFile | null = null;
  private asked = 0;

  constructor(private readonly context: Context) {
    this.draft = new MachineDraft(context.session, kindNames[0]);
    const kinds = kindNames.map((name): [string, string] => [name, words.kinds[name].title]);
    this.kind = choice(words.kind, kinds, kindNames[0], (name) => void this.begin(name as KindName));
    this.dialog = element(
      "dialog",
      { class: "wizard", "aria-label": words.title, onclose: () => this.close() },
      element("h2", {}, words.title),
      element("label", { class: "wizard-kind" }, words.kind, this.kind),
      this.about,
      element(
        "div",
        { class: "wizard-columns" },
        this.fields,
        element(
          "div",
          { class: "wizard-result" },
          element("p", { class: "file" }, this.file),
          this.text,
          this.errors.element,
          this.check.element,
        ),
      ),
      element(
        "div",
        { class: "buttons" },
        this.accept,
        element("button", { type: "button", onclick: () => this.dialog.close() }, texts.bar.close),
      ),
    );
  }

  async open(): Promise<void> {
    document.body.append(this.dialog);
    this.dialog.showModal();
    await this.begin(kindNames[0]);
  }

  private close(): void {
    this.updateTimer.cancel();
    ++this.asked;
    this.dialog.remove();
  }

  private async begin(kind: KindName): Promise<void> {
    const draft = new MachineDraft(this.context.session, kind);
    this.draft = draft;
    // A result for the previous kind must not be used for this one.
    ++this.asked;
    this.updateTimer.cancel();
    this.accept.disabled = true;
    this.about.textContent = words.kinds[kind].about;
    await draft.begin();
    if (draft !== this.draft) return;
    arrange(this.fields, [this.nameField(), ...this.axisFields(), this.pathFields(), this.controller(), ...this.bodies()]);
    this.refresh();
  }

  private refresh(): void {
    this.accept.disabled = true;
    this.check.wait();
    this.updateTimer.after(PAUSE_MS);
  }

  private async make(): Promise<void> {
    const asked = ++this.asked;
    const { draft } = this;
    const made = await draft.make();
    if (asked !== this.asked) return;
    if (!("file" in made)) return this.showCheckResult({ errors: [made], check: null });
    this.made = made;
    this.file.textContent = made.file;
    this.text.textContent = made.text;
    const checked = await draft.check(made);
    if (asked === this.asked) this.showCheckResult(checked);
  }

  private showCheckResult(checked: CheckResponse): void {
    this.errors.show(checked.errors);
    this.check.show(checked);
    this.accept.disabled = checked.errors.some(({ severity }) => severity === "error");
  }

  private async onAccept(): Promise<void> {
    if (!this.made) return;
    const { file, text } = this.made;
    await this.context.edits.choose("machine", words.made(this.draft.name), file, text);
    this.dialog.close();
  }

  private field(at: TomlPath, spec: FieldSpec): HTMLElement {
    const { draft } = this;
    const field = new Field(this.context.store, spec, (value) => {
      draft.set(at, value);
      for (const show of this.displayed) show();
      this.refresh();
      return Promise.resolve("");
    });
    const show = () => field.show(draft.get(at), spec.label === keyLabel("home_mm") ? 0 : "inf");
    this.displayed.push(show);
    show();
    return field.element;
  }

  /** Functions that show the draft again: a change of one value may change another. */
  private readonly displayed: (() => void)[] = [];

  private nameField(): HTMLElement {
    this.displayed.length = 0;
    const { draft } = this;
    const spec: FieldSpec = { label: words.name, kind: "text", isRequired: true };
    const field = new Field(this.context.store, spec, (value) => {
      draft.name = String(value);
      this.refresh();
      return Promise.resolve("");
    });
    field.show(draft.name);
    return field.element;
  }

  private axisFields(): HTMLElement[] {
    return this.draft.axes.map((axis, i) => {
      const isRotary = axis.kind === "rotary";
      const fields = AXIS_KEYS.map((each) => {
        const key = fullKey(each, isRotary);
        const spec: FieldSpec = { label: keyLabel(key), kind: "number", unit: keyUnit(key), isNarrow: true, ...(isPositiveLimit(key) ? { above: 0 } : {}) };
        return this.field(["axis", i, key], spec);
      });
      return element("fieldset", {}, element("legend", {}, words.axis(String(axis.letter))), element("div", { class: "rows pose" }, ...fields));
    });
  }

  private pathFields(): HTMLElement {
    const fields = PATH_KEYS.map((key) => this.field(["path", key], { label: keyLabel(key), kind: "number", unit: keyUnit(key), isNarrow: true, above: 0 }));
    return element("fieldset", {}, element("legend", {}, texts.machine.sections.limits), element("div", { class: "rows pose" }, ...fields));
  }

  private controller(): HTMLElement {
    const names = [...this.context.session.documents.samples.keys()].flatMap((name) => /^samples\/controllers\/(.+)\.toml$/.exec(name)?.[1] ?? []);
    const select = choice(texts.machine.controller.title, [], "", (model) => {
      this.draft.set(["controller", "model"], model);
      this.refresh();
    });
    setOptions(select, names.map((name) => [name, name]), this.draft.model || "exact-stop");
    return element("label", { class: "wizard-kind" }, texts.machine.controller.title, select);
  }

  private bodies(): HTMLElement[] {
    const { draft } = this;
    if (!draft.offersBodies) return [];
    const box = element("input", {
      type: "checkbox",
      checked: true,
      onchange: () => {
        draft.hasBodies = box.checked;
        this.refresh();
      },
    });
    return [element("label", { class: "check" }, box, words.bodies)];
  }
}

export function showWizard(context: Context): void {
  void new Wizard(context).open();
}
