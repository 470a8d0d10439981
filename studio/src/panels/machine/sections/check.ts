// Details for a careful user: directions of the machine, its inverse, singular ranges, possible contacts.

import { arrange, element } from "../../../core/dom";
import { texts } from "../../../texts";
import type { CheckResponse } from "../file/model";

const words = texts.machine.check;

/** Result as of gsim-run --check-machine --json. */
export interface MachineCheck {
  clean: boolean;
  home_mm: number[];
  motions: { text: string }[];
  left_handed: string[];
  inverse: { poses: number; unsolved: number; out_of_range: number; off: number; worst_mm: number; worst_deg: number } | null;
  singular: { ranges: { axis: string; min_deg: number; max_deg: number; lined_up: string[] }[]; near_share: number; at_home: boolean };
  pairs: { pair: [string, string]; verdict: "touch" | "free" | "undecided"; nearest_mm: number; contact_share: number; at: Record<string, number> }[];
  notes: string[];
}

interface Line {
  kind: "good" | "bad" | "plain";
  text: string;
}

const plain = (text: string): Line => ({ kind: "plain", text });

function inverseLine({ inverse }: MachineCheck): Line {
  if (!inverse) return plain(words.noInverse);
  const bad = inverse.unsolved + inverse.out_of_range + inverse.off;
  if (bad > 0) return { kind: "bad", text: words.inverseFails(bad, inverse.poses) };
  return { kind: "good", text: words.inverseHolds(inverse.poses, inverse.worst_mm.toExponential(1), inverse.worst_deg.toExponential(1)) };
}

function singularLines({ singular: { ranges, near_share, at_home } }: MachineCheck): Line[] {
  const lines = ranges.map(({ axis, min_deg, max_deg, lined_up }) => plain(words.singular(axis, min_deg.toFixed(1), max_deg.toFixed(1), lined_up.join(" "))));
  if (near_share > 0) lines.push(plain(words.nearSingular((100 * near_share).toFixed(1))));
  if (at_home) lines.push(plain(words.singularHome));
  return lines;
}

function pairLines({ pairs }: MachineCheck): Line[] {
  const at = (values: Record<string, number>) => Object.entries(values).map(([letter, value]) => `${letter} ${Number(value.toFixed(1))}`).join(" ");
  const blockingPairs = pairs.filter(({ verdict }) => verdict !== "free").map(({ pair, verdict, nearest_mm, at: where }): Line => {
    const text = verdict === "touch" ? words.touch(pair.join(" – "), at(where)) : words.undecided(pair.join(" – "), nearest_mm.toFixed(1));
    return { kind: "bad", text };
  });
  const free = pairs.length - blockingPairs.length;
  return free > 0 ? [...blockingPairs, { kind: "good", text: words.free(free) }] : blockingPairs;
}

export function checkLines(check: MachineCheck): Line[] {
  return [
    ...check.motions.map(({ text }) => plain(text)),
    ...check.left_handed.map((text): Line => ({ kind: "bad", text })),
    inverseLine(check),
    ...singularLines(check),
    ...pairLines(check),
    ...check.notes.map(plain),
  ];
}

export class CheckResult {
  readonly element: HTMLElement;
  private readonly verdict = element("p", { class: "verdict", role: "status" });
  private readonly list = element("ul", { class: "check-lines" });

  constructor(...controls: HTMLElement[]) {
    this.element = element("div", {}, this.verdict, ...controls, this.list);
  }

  show({ check, errors }: CheckResponse): void {
    const found = check as unknown as MachineCheck | null;
    const hasErrors = errors.some(({ severity }) => severity === "error");
    this.verdict.textContent = hasErrors || !found ? words.broken : found.clean ? words.clean : words.found;
    this.verdict.dataset.kind = found?.clean ? "good" : "bad";
    arrange(this.list, (found ? checkLines(found) : []).map(({ kind, text }) => element("li", { class: kind }, text)));
  }

  wait(): void {
    this.verdict.textContent = words.checking;
    this.verdict.dataset.kind = "plain";
  }
}
