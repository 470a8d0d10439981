// Pictures on buttons: lines in a square of 20.

import { svgElement } from "../core/dom";

const cube = "M10 2 17 6V14L10 18 3 14V6Z M3 6 10 10 17 6 M10 10V18";

const drawings = {
  fit: ["M3 7V3H7 M13 3H17V7 M17 13V17H13 M7 17H3V13 M7.5 7.5H12.5V12.5H7.5Z", ""],
  top: [cube, "M10 2 17 6 10 10 3 6Z"],
  front: [cube, "M3 6 10 10V18L3 14Z"],
  side: [cube, "M17 6 10 10V18L17 14Z"],
  iso: [cube, ""],
  perspective: ["M2 17 6 4H14L18 17Z M4 10.5H16 M10 4V17", ""],
  follow: ["M10 2V6 M10 14V18 M2 10H6 M14 10H18 M10 5A5 5 0 1 0 10 15A5 5 0 1 0 10 5Z", "M10 8.6A1.4 1.4 0 1 0 10 11.4A1.4 1.4 0 1 0 10 8.6Z"],
  measure: ["M2 13 13 2 18 7 7 18Z M5 10 7 12 M8 7 10.5 9.5 M11 4 13 6", ""],
  headset: ["M2 6H18V15H12.5L11 12.5H9L7.5 15H2Z M5 6V4H15V6", ""],
  layers: ["M10 3 18 7.5 10 12 2 7.5Z M3 11 10 15 17 11 M3 14 10 18 17 14", ""],
} as const;

export type Icon = keyof typeof drawings;

export function icon(name: Icon): SVGElement {
  const [lines, filled] = drawings[name];
  const parts = [svgElement("path", { d: lines, class: "drawn" })];
  if (filled) parts.unshift(svgElement("path", { d: filled, class: "filled" }));
  return svgElement("svg", { viewBox: "0 0 20 20", "aria-hidden": "true" }, ...parts);
}
