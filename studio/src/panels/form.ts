// Form in the side panel of the page.

/** `shown` is called each time that the form becomes visible, `hidden` when it no longer is. */
export interface Form {
  element: HTMLElement;
  shown?(): void;
  hidden?(): void;
}
