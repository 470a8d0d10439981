// Follows a pointer from press to release, wherever it moves.

export interface Drag {
  begin?(event: PointerEvent): void;
  /** `x_px` and `y_px` since the last call. */
  move(event: PointerEvent, x_px: number, y_px: number): void;
}

export function listenToDrag(element: HTMLElement, drag: Drag): void {
  let last: PointerEvent | null = null;
  element.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    element.setPointerCapture(event.pointerId);
    last = event;
    drag.begin?.(event);
  });
  element.addEventListener("pointermove", (event) => {
    if (!last) return;
    const [x_px, y_px] = [event.clientX - last.clientX, event.clientY - last.clientY];
    last = event;
    if (x_px !== 0 || y_px !== 0) drag.move(event, x_px, y_px);
  });
  const end = () => (last = null);
  element.addEventListener("pointerup", end);
  element.addEventListener("pointercancel", end);
}
