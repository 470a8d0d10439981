// Numbers as people read them, in mm or inch. The engine's are mm, deg and s throughout.

import type { Units } from "./store";

const MM_PER_INCH = 25.4;

export const lengthUnit = (units: Units): string => (units === "inch" ? "in" : "mm");
/** A length in the unit that is shown. */
export const length = (mm: number, units: Units): number => (units === "inch" ? mm / MM_PER_INCH : mm);
export const mmOf = (value: number, units: Units): number => (units === "inch" ? value * MM_PER_INCH : value);

/** "12.340 mm": as many digits as a control shows. */
export const lengthText = (mm: number, units: Units): string =>
  `${length(mm, units).toFixed(units === "inch" ? 4 : 3)} ${lengthUnit(units)}`;

/** A value of an axis with its unit. */
export const axisText = (value: number, rotary: boolean, units: Units): string =>
  rotary ? `${value.toFixed(3)}°` : lengthText(value, units);

/** A speed along the path, as feeds are given: per minute. */
export const feedText = (mm_s: number, units: Units): string => {
  const perMinute = length(mm_s * 60, units);
  return `${perMinute >= 100 ? perMinute.toFixed(0) : perMinute.toPrecision(3)} ${lengthUnit(units)}/min`;
};

/** "1:02:03.4", "2.345 s" */
export function timeText(t_s: number, digits = 3): string {
  if (t_s < 60) return `${t_s.toFixed(digits)} s`;
  const hours = Math.floor(t_s / 3600);
  const minutes = Math.floor((t_s % 3600) / 60);
  const seconds = (t_s % 60).toFixed(digits).padStart(digits > 0 ? digits + 3 : 2, "0");
  return hours > 0 ? `${hours}:${String(minutes).padStart(2, "0")}:${seconds}` : `${minutes}:${seconds}`;
}
