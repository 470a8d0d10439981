// Elements, created in one call.

type Attributes = Record<string, string | number | boolean | ((event: Event) => void) | undefined>;

/**
 * Creates an element. `on...` attributes are listeners, true means an attribute without a value, false and
 * undefined none.
 */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") made.addEventListener(name.slice(2), value);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== undefined) made.setAttribute(name, String(value));
  }
  made.append(...children);
  return made;
}

/** Of a drawing. */
export function svgElement(tag: string, attributes: Record<string, string> = {}, ...children: Node[]): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

/** Creates a checkbox with its label. */
export function check(
  label: Node | string,
  change: (on: boolean) => void,
  attributes: Attributes = {},
): { row: HTMLLabelElement; box: HTMLInputElement } {
  const box = element("input", { type: "checkbox", onchange: () => change(box.checked) });
  return { row: element("label", { class: "check", ...attributes }, box, label), box };
}

/** Creates a choice among values, each with a label. */
export function choice(
  label: string,
  options: readonly (readonly [value: string, text: string])[],
  value: string,
  change: (value: string) => void,
): HTMLSelectElement {
  const select = element(
    "select",
    { "aria-label": label, title: label, onchange: () => change(select.value) },
    ...options.map(([each, text]) => element("option", { value: each, selected: each === value }, text)),
  );
  return select;
}

/** Replaces the values of a choice, if they differ, and chooses one; the focus stays. */
export function setOptions(
  select: HTMLSelectElement,
  options: readonly (readonly [value: string, text: string])[],
  value: string,
): void {
  const listed = [...select.options].map((option) => [option.value, option.text]);
  if (JSON.stringify(listed) !== JSON.stringify(options)) {
    select.replaceChildren(...options.map(([each, text]) => element("option", { value: each }, text)));
  }
  select.value = value;
}

/** Sets the children; those already in position are not touched, so that the focus in them stays. */
export function arrange(parent: HTMLElement, children: readonly HTMLElement[]): void {
  const requested = new Set<Node>(children);
  for (const child of [...parent.childNodes]) if (!requested.has(child)) child.remove();
  children.forEach((child, i) => {
    if (parent.childNodes[i] !== child) parent.insertBefore(child, parent.childNodes[i] ?? null);
  });
}
