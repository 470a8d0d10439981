// Numbers as the tables have them.

import type { Store } from "../../core/store";
import { length, lengthUnit } from "../../core/units";

/** "1,234" */
export const countText = (count: number): string => count.toLocaleString("en");

/** "12.3", of a whole; with as many digits as tell small shares apart. */
export function percentText(part: number, whole: number): string {
  const percent = whole > 0 ? (100 * part) / whole : 0;
  return percent >= 10 || percent === 0 ? percent.toFixed(1) : percent.toPrecision(2);
}

/** A short length: "12.34 mm", "1,234 mm". */
export function lengthShort(mm: number, store: Store): string {
  const units = store.get("units");
  const value = length(mm, units);
  const digits = value >= 1000 ? 0 : units === "inch" ? 3 : 2;
  const text = value.toLocaleString("en", { minimumFractionDigits: digits, maximumFractionDigits: digits });
  return `${text} ${lengthUnit(units)}`;
}
