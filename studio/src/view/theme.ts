// Colours of objects other than the path, for a light page and a dark one.

import { Color, SRGBColorSpace } from "three";
import { blue, orange, purple, sky, vermilion, yellow } from "../core/colours";
import { themeColour } from "../core/theme";

export const isDark = (): boolean => document.documentElement.dataset.theme === "dark";

export interface Palette {
  background: Color;
  machine: Color;
  structure: Color;
  fixture: Color;
  workpiece: Color;
  jet: Color;
  tool: Color;
  edges: Color;
  grid: Color;
  marks: Color;
  selected: Color;
  progressColour: Color;
  hit: Color;
  near: Color;
  envelope: Color;
  inside: Color;
  outside: Color;
  compare: Color;
  measure: Color;
  editedPath: Color;
}

export function palette(): Palette {
  const pick = (light: string, dark: string) => new Color(isDark() ? dark : light);
  return {
    background: new Color(themeColour("--view-bg") || "#eef1f5"),
    machine: pick("#aab4c2", "#5d6b80"),
    structure: pick("#c3ccd8", "#465266"),
    fixture: pick("#b9a98f", "#6d6250"),
    workpiece: new Color(sky),
    jet: new Color(sky),
    tool: pick("#5b6472", "#c6cedb"),
    edges: pick("#5b6677", "#9aa6ba"),
    grid: pick("#a9b4c4", "#3c4656"),
    marks: pick("#39424f", "#dfe5ee"),
    selected: pick(vermilion, yellow),
    progressColour: pick("#1d2330", "#ffffff"),
    hit: pick("#e0301e", "#ff5a47"),
    near: new Color(orange),
    envelope: new Color(purple),
    inside: new Color(isDark() ? sky : blue),
    outside: new Color(vermilion),
    compare: pick("#7a5195", "#cc79a7"),
    measure: pick("#a3195b", "#ff9ad0"),
    editedPath: pick("#a3195b", "#ff9ad0"),
  };
}

/** Returns the colour for the project's own shaders. */
export function toRgb(colour: Color): number[] {
  const { r, g, b } = colour.getRGB({ r: 0, g: 0, b: 0 }, SRGBColorSpace);
  return [r, g, b];
}
