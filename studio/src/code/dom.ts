// Elements in one call.

/** An element with a class, attributes and children. */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  className: string,
  attributes: Record<string, string> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  if (className) made.className = className;
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

/** Calls no more than once in the time, the last call counts. */
export class Debounced {
  private timer = 0;

  constructor(private readonly action: () => void) {}

  after(delay_ms: number): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      this.action();
    }, delay_ms);
  }

  /** Does at once what is due. */
  flush(): void {
    if (!this.timer) return;
    this.cancel();
    this.action();
  }

  cancel(): void {
    clearTimeout(this.timer);
    this.timer = 0;
  }
}
