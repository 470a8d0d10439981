// Numbers as users read and write them: files are in mm, the page in mm or inch.

import type { Units } from "../../../core/store";
import { length, lengthUnit, toMm } from "../../../core/units";
import type { Toml } from "../file/toml";

const MAX_DIGITS = 9;
const rounded = (value: number): number => Number(value.toPrecision(MAX_DIGITS));

const isLength = (unit: string): boolean => unit.startsWith("mm");

const powers: Record<string, string> = { s2: "s²", s3: "s³" };
const unitSymbols: Record<string, string> = { deg: "°", percent: "%" };

/** Returns the shown unit: "mm/s2" is "mm/s²" or "in/s²". */
export function unitText(unit: string, units: Units): string {
  const [above, below] = unit.split("/");
  const top = above === "mm" ? lengthUnit(units) : (unitSymbols[above] ?? above);
  return below ? `${top}/${powers[below] ?? below}` : top;
}

const suffixes = ["mm_s3", "mm_s2", "mm_s", "mm_min", "mm", "deg_s3", "deg_s2", "deg_s", "deg", "percent", "1_s", "s"];

/** Returns the unit from the end of a key's name: "max_speed_mm_s" is in "mm/s". */
export function keyUnit(key: string): string {
  return suffixes.find((suffix) => key.endsWith(`_${suffix}`))?.replace("_", "/") ?? "";
}

/** Returns the shown name: "max_speed_mm_s" is "Max speed". */
export function keyLabel(key: string): string {
  const unit = keyUnit(key).replace("/", "_");
  const bare = (unit ? key.slice(0, -unit.length - 1) : key).replaceAll("_", " ").replace(/(\D)(\d)$/, "$1 $2");
  return bare.charAt(0).toUpperCase() + bare.slice(1);
}

/** Returns a number of a file as text, or the name of a number that is not finite. */
export function numberText(value: Toml | undefined, unit: string, units: Units): string {
  if (typeof value === "string") return value;
  if (typeof value !== "number") return "";
  return String(isLength(unit) && units === "inch" ? rounded(length(value, units)) : value);
}

/** Converts typed text to a number for the file; null: not a number. */
export function parseNumber(text: string, unit: string, units: Units): number | string | null {
  const written = text.trim().toLowerCase().replace("−", "-");
  if (/^[+-]?inf$/.test(written)) return written.replace("+", "");
  const value = Number(written);
  if (written === "" || !Number.isFinite(value)) return null;
  return isLength(unit) && units === "inch" ? rounded(toMm(value, units)) : value;
}
