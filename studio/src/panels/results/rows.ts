// Rows that are one stop of the Tab key: arrows go among them, Enter chooses.

/** `rows` are children of `container`; `choose` gets the number of one. `keys` do something else than choosing. */
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
    const acts: Record<string, () => void> = {
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
    const act = own ? () => own(row) : acts[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
}

/** Makes the first of rows that have been put in the one that Tab comes to. */
export function beginRows(container: HTMLElement): void {
  [...container.children].forEach((row, i) => ((row as HTMLElement).tabIndex = i === 0 ? 0 : -1));
}
