// Distance between two bodies, at the shown instant.

import { choice, element, setOptions } from "../../../core/dom";
import { shownRobot } from "../../../core/display_state";
import type { Store } from "../../../core/store";
import { lengthText } from "../../../core/units";
import { createCore, distanceBetween } from "../../../run/body_distance";
import { texts } from "../../../texts";
import type { Context, Section } from "../form/context";

const words = texts.machine.distance;

/** Returns mm, or null if one of them does not exist. */
export function bodyDistance(store: Store, first: string, second: string): number | null {
  const robot = shownRobot(store);
  const bodies = robot?.scene.bodies ?? [];
  const [a, b] = [first, second].map((name) => bodies.find((body) => body.name === name));
  if (!robot || !a || !b) return null;
  const t_s = store.get("time_s");
  const joints = robot.joints_at(t_s);
  if (!joints) return null;
  const { frames } = robot.chain.linkPoses(joints, t_s);
  const [one, other] = [a, b].map(({ shape, frame }) => createCore(shape, robot.meshes, frames[frame]));
  return distanceBetween(one, other);
}

export function createDistance({ store }: Context): Section {
  const draw = () => {
    const bodies = shownRobot(store)?.scene.bodies ?? [];
    const names = bodies.map(({ name }): [string, string] => [name, name]);
    setOptions(first, names, first.value || (names[0]?.[0] ?? ""));
    setOptions(second, names, second.value || (names[1]?.[0] ?? ""));
    const gap_mm = bodyDistance(store, first.value, second.value);
    result.textContent = gap_mm === null ? words.none : gap_mm > 0 ? lengthText(gap_mm, store.get("units")) : words.touch;
    const hasMesh = bodies.some(({ name, shape }) => shape.kind === "mesh" && [first.value, second.value].includes(name));
    about.textContent = hasMesh ? words.ofHull : "";
  };
  const [first, second] = [words.first, words.second].map((label) => choice(label, [], "", () => draw()));
  const result = element("output", { class: "distance", "aria-label": words.title });
  const about = element("p", { class: "note" });
  for (const key of ["run", "time_s", "robot", "loadCount"] as const) store.on(key, draw);
  return { element: element("div", {}, element("p", { class: "note" }, words.about), first, second, element("p", {}, result), about), draw };
}
