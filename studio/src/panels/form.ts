// Form in the side panel of the page.

/** `shown` is called each time that the form becomes visible, `hidden` when it no longer is. */
export interface PanelForm {
  element: HTMLElement;
  displayed?(): void;
  hidden?(): void;
}
