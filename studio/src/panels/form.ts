// A form of the side of the page.

/** `shown` is called each time that it comes to be looked at, `hidden` when it no longer is. */
export interface Form {
  element: HTMLElement;
  shown?(): void;
  hidden?(): void;
}
