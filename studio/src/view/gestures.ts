// Gestures of mouse, pen and fingers: one rotates, two or the right button pan, the wheel or a pinch zooms.

/** Object that the pointer holds until release. */
export interface ActiveGrab {
  drag(x_px: number, y_px: number): void;
  drop(): void;
  cancel(): void;
}

export interface Gestures {
  /**
   * Called on a press at a position, px from the left and from above; returns null if nothing can be grabbed.
   */
  grab(x_px: number, y_px: number): ActiveGrab | null;
  orbit(dx_px: number, dy_px: number): void;
  pan(dx_px: number, dy_px: number): void;
  /** Zooms about a position, px from the middle. */
  zoom(factor: number, x_px: number, y_px: number): void;
  /** Called on press and release at one position, px from the left and from above. */
  click(x_px: number, y_px: number): void;
  hover(x_px: number, y_px: number): void;
  leave(): void;
}

const MAX_CLICK_MOVE_PX = 4;

interface PointerPosition {
  x: number;
  y: number;
}

export function listenToGestures(element: HTMLElement, on: Gestures): void {
  const pointers = new Map<number, PointerPosition>();
  let moved_px = 0;
  let shifts = false;
  let activeGrab: ActiveGrab | null = null;

  const place = (event: MouseEvent) => {
    const { left, top, width, height } = element.getBoundingClientRect();
    const [x, y] = [event.clientX - left, event.clientY - top];
    return { x, y, fromMiddle: [x - width / 2, y - height / 2] as const };
  };
  const middle = () => {
    const all = [...pointers.values()];
    return { x: (all[0].x + all[1].x) / 2, y: (all[0].y + all[1].y) / 2 };
  };
  const spread = () => {
    const all = [...pointers.values()];
    return Math.hypot(all[0].x - all[1].x, all[0].y - all[1].y);
  };

  element.addEventListener("pointerdown", (event) => {
    element.setPointerCapture(event.pointerId);
    const { x, y } = place(event);
    if (pointers.size === 0) {
      moved_px = 0;
      shifts = event.button !== 0 || event.shiftKey || event.ctrlKey;
      activeGrab = shifts ? null : on.grab(x, y);
    } else moved_px = Infinity;
    pointers.set(event.pointerId, { x, y });
  });

  element.addEventListener("pointermove", (event) => {
    const { x, y } = place(event);
    const pointer = pointers.get(event.pointerId);
    if (!pointer) return on.hover(x, y);
    const [dx, dy] = [x - pointer.x, y - pointer.y];
    moved_px += Math.abs(dx) + Math.abs(dy);
    if (activeGrab) {
      if (moved_px >= MAX_CLICK_MOVE_PX) activeGrab.drag(x, y);
      return;
    }
    if (pointers.size === 2) {
      const [before, wide] = [middle(), spread()];
      Object.assign(pointer, { x, y });
      const after = middle();
      on.pan(after.x - before.x, after.y - before.y);
      const { width, height } = element.getBoundingClientRect();
      if (spread() > 0) on.zoom(wide / spread(), after.x - width / 2, after.y - height / 2);
      return;
    }
    if (moved_px < MAX_CLICK_MOVE_PX) return;
    Object.assign(pointer, { x, y });
    if (shifts) on.pan(dx, dy);
    else on.orbit(dx, dy);
  });

  const end = (event: PointerEvent) => {
    if (!pointers.delete(event.pointerId)) return;
    const { x, y } = place(event);
    const held = activeGrab;
    activeGrab = null;
    if (held && event.type === "pointerup" && moved_px >= MAX_CLICK_MOVE_PX) return held.drop();
    held?.cancel();
    if (event.type === "pointerup" && moved_px < MAX_CLICK_MOVE_PX && event.button === 0) on.click(x, y);
  };
  element.addEventListener("pointerup", end);
  element.addEventListener("pointercancel", end);
  element.addEventListener("pointerleave", () => on.leave());
  element.addEventListener("contextmenu", (event) => event.preventDefault());
  element.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
      const [x, y] = place(event).fromMiddle;
      on.zoom(Math.exp(Math.min(Math.max(event.deltaY * lines, -300), 300) * 0.0012), x, y);
    },
    { passive: false },
  );
}
