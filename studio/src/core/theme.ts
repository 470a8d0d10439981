// Colours of the CSS, for items that are drawn without styles.

/** Returns a value that the theme sets: themeColour("--accent"). */
export const themeColour = (name: string): string =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** Calls `listener` when the page has turned light or dark; returns a function that ends this. */
export function onTheme(listener: () => void): () => void {
  const observer = new MutationObserver(listener);
  observer.observe(document.documentElement, { attributeFilter: ["data-theme"] });
  return () => observer.disconnect();
}
