// Form in the side panel of the page.

export interface PanelForm {
  element: HTMLElement;
  /** Called each time that the form becomes visible. */
  onDisplayed?(): void;
  /** Called each time that the form is no longer visible. */
  onHidden?(): void;
}
