// Numbers for users, in mm or inch. Those of the engine are in mm, deg and s throughout.

import type { Units } from "./store";

const MM_PER_INCH = 25.4;

export const lengthUnit = (units: Units): string => (units === "inch" ? "in" : "mm");
/** Returns a length in the shown unit. */
export const length = (mm: number, units: Units): number => (units === "inch" ? mm / MM_PER_INCH : mm);
export const toMm = (value: number, units: Units): number => (units === "inch" ? value * MM_PER_INCH : value);

/** Returns "12.340": with as many digits as a controller shows. */
export const lengthNumber = (mm: number, units: Units): string => length(mm, units).toFixed(units === "inch" ? 4 : 3);
/** "12.340 mm" */
export const lengthText = (mm: number, units: Units): string => `${lengthNumber(mm, units)} ${lengthUnit(units)}`;

/** As tables have it: "12.34 mm", "1,234 mm". */
export function lengthShort(mm: number, units: Units): string {
  const value = length(mm, units);
  const digits = value >= 1000 ? 0 : units === "inch" ? 3 : 2;
  const text = value.toLocaleString("en", { minimumFractionDigits: digits, maximumFractionDigits: digits });
  return `${text} ${lengthUnit(units)}`;
}

/** Returns the value of an axis with its unit. */
export const axisText = (value: number, rotary: boolean, units: Units): string =>
  rotary ? `${value.toFixed(3)}°` : lengthText(value, units);

const perMinuteText = (value: number, unit: string): string =>
  `${value >= 100 || value === 0 ? value.toFixed(0) : value.toPrecision(3)} ${unit}/min`;

/** Returns a speed along the path per minute, as for feeds. */
export const feedText = (mm_s: number, units: Units): string =>
  perMinuteText(length(mm_s * 60, units), lengthUnit(units));

/** Returns a programmed feed per minute; in degrees if the tool does not move along a path. */
export const programmedFeedText = (feed_per_min: number, length_mm: number, units: Units): string =>
  length_mm > 0 ? feedText(feed_per_min / 60, units) : perMinuteText(feed_per_min, "°");

/** Splits a time, rounded to so many digits, into hours, minutes, seconds and the fraction with its point. */
function clockParts(t_s: number, digits: number): [hours: number, minutes: number, seconds: number, fraction: string] {
  const scale = 10 ** digits;
  const parts = Math.round(t_s * scale);
  const total_s = Math.floor(parts / scale);
  const fraction = digits > 0 ? `.${String(parts - total_s * scale).padStart(digits, "0")}` : "";
  return [Math.floor(total_s / 3600), Math.floor(total_s / 60) % 60, total_s % 60, fraction];
}

const twoDigits = (value: number): string => String(value).padStart(2, "0");

/** "1:02:03.4", "2.345 s" */
export function timeText(t_s: number, digits = 3): string {
  const [hours, minutes, seconds, fraction] = clockParts(t_s, digits);
  if (hours > 0) return `${hours}:${twoDigits(minutes)}:${twoDigits(seconds)}${fraction}`;
  return minutes > 0 ? `${minutes}:${twoDigits(seconds)}${fraction}` : `${seconds}${fraction} s`;
}

/** "0:01:23.456" */
export function clockText(t_s: number): string {
  const [hours, minutes, seconds, fraction] = clockParts(t_s, 3);
  return `${hours}:${twoDigits(minutes)}:${twoDigits(seconds)}${fraction}`;
}

/** Returns "1,234", "12.3", "0.0567": an integer, or three digits, for values that are shown with a unit. */
export const valueText = (value: number): string =>
  value.toLocaleString("en", Math.abs(value) >= 1000 ? { maximumFractionDigits: 0 } : { maximumSignificantDigits: 3 });

/** "48.1 J", "1.23 kJ" */
export function energyText(energy_j: number): string {
  return Math.abs(energy_j) < 1000 ? `${valueText(energy_j)} J` : `${valueText(energy_j / 1000)} kJ`;
}

/** "1,234" */
export const countText = (count: number): string => count.toLocaleString("en");

/** Returns a percentage, "12.3", with as many digits as distinguish small shares. */
export function percentText(part: number, whole: number): string {
  const percent = whole > 0 ? (100 * part) / whole : 0;
  return percent >= 10 || percent === 0 ? percent.toFixed(1) : percent.toPrecision(2);
}
