// Keys that work everywhere except in text input.

export type Keys = Record<string, () => void>;

const boxes = ":is([type=checkbox], [type=radio])";
const textInputSelector = `input:not(${boxes}), textarea, select, [contenteditable], .cm-editor`;
// These elements use Space themselves.
const pressableElements = `button, summary, a[href], input${boxes}, [role=tab], [role=option], [role=menuitem]`;

/** Listens on the page; `keys` by KeyboardEvent.key. */
export function createKeyboard(keys: Keys): void {
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target as Element;
    if (target.closest?.(textInputSelector)) return;
    if (event.key === " " && target.closest?.(pressableElements)) return;
    const act = keys[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
}
