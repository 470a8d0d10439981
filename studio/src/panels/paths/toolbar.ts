// Buttons for actions on the chosen points.

import { choice, element, setOptions } from "../../core/dom";
import type { DisplayedPath } from "../../core/displayed_path";
import { firstMachinePoint, noPoints } from "../../run/path/machine_points";
import { texts } from "../../texts";
import type { PathActions } from "./actions";
import type { TargetSelection } from "./target_selection";
import type { SetupPoints } from "./known_points";

const words = texts.paths.toolbar;
type ButtonName = "add" | "addMachinePoint" | "duplicate" | "remove" | "up" | "down" | "makeSubPath";

export class PathToolbar {
  readonly element: HTMLElement;
  private readonly buttons: Record<ButtonName, HTMLButtonElement>;
  private readonly uses: HTMLSelectElement;

  constructor(
    actions: PathActions,
    private readonly chosen: TargetSelection,
    known: SetupPoints,
  ) {
    const button = (name: ButtonName, act: () => void) =>
      element("button", { type: "button", title: words.titles[name], "aria-label": words.titles[name], onclick: act }, words.names[name]);
    this.buttons = {
      add: button("add", () => actions.add()),
      addMachinePoint: button("addMachinePoint", () => actions.addMachinePoint(firstMachinePoint(known.points ?? noPoints))),
      duplicate: button("duplicate", () => actions.duplicate()),
      remove: button("remove", () => actions.remove()),
      up: button("up", () => actions.move(-1)),
      down: button("down", () => actions.move(1)),
      makeSubPath: button("makeSubPath", () => actions.makeSubPath()),
    };
    this.uses = choice(words.use, [], "", (name) => {
      if (name) actions.addSubPath(name);
      this.uses.value = "";
    });
    this.element = element(
      "div",
      { class: "toolbar", role: "toolbar", "aria-label": words.label },
      ...Object.values(this.buttons),
      this.uses,
    );
  }

  show(displayed: DisplayedPath | null): void {
    const { range } = this.chosen;
    const isTarget = range !== null && range.place.target >= 0;
    const count = displayed && range ? (displayed.file.paths[range.place.path]?.targets.length ?? 0) : 0;
    this.buttons.duplicate.disabled = this.buttons.makeSubPath.disabled = !isTarget;
    this.buttons.remove.disabled = range === null;
    this.buttons.up.disabled = !isTarget || range.place.target === 0;
    this.buttons.down.disabled = !isTarget || range.place.target + range.count >= count;
    const names = displayed?.file.paths.map(({ name }) => name) ?? [];
    setOptions(this.uses, [["", words.use] as const, ...names.map((name) => [name, name] as const)], "");
  }
}
