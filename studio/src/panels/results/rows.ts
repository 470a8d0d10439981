// Rows that are one stop of the Tab key: arrows move between them, Enter selects.

/**
 * `rows` are children of `container`; `choose` gets the number of the selected one. `keys` have other
 * actions.
 */
export function makeRows(
  container: HTMLElement,
  choose: (row: number) => void,
  keys: Record<string, (row: number) => void> = {},
): void {
  const rows = () => [...container.children] as HTMLElement[];
  const indexOf = (target: EventTarget | null) => rows().findIndex((row) => row.contains(target as Node));
  const focus = (row: number) => {
    const all = rows();
    const next = all[Math.min(Math.max(row, 0), all.length - 1)];
    if (!next) return;
    for (const each of all) each.tabIndex = -1;
    next.tabIndex = 0;
    next.focus();
  };
  container.addEventListener("click", (event) => {
    const row = indexOf(event.target);
    if (row < 0) return;
    focus(row);
    choose(row);
  });
  container.addEventListener("keydown", (event) => {
    const row = indexOf(event.target);
    if (row < 0 || event.ctrlKey || event.metaKey || event.altKey) return;
    const actions: Record<string, () => void> = {
      ArrowDown: () => focus(row + 1),
      ArrowUp: () => focus(row - 1),
      PageDown: () => focus(row + 10),
      PageUp: () => focus(row - 10),
      Home: () => focus(0),
      End: () => focus(Infinity),
      Enter: () => choose(row),
      " ": () => choose(row),
    };
    const own = keys[event.key];
    const act = own ? () => own(row) : actions[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
}

/** Makes the first of newly inserted rows the one that the Tab key reaches. */
export function initializeTabStops(container: HTMLElement): void {
  [...container.children].forEach((row, i) => ((row as HTMLElement).tabIndex = i === 0 ? 0 : -1));
}
