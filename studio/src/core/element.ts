// To be taken from core/dom (element) and core/theme; stands here for what was written against it.

export { element as make } from "./dom";
export { onTheme, themeColour } from "./theme";
