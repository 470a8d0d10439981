// Button that repeats its action while it is held.

import { element } from "../../core/dom";

const INITIAL_DELAY_MS = 350;
const REPEAT_DELAY_MS = 70;

/** Waits for slow work before it is repeated. */
export function holdButton(text: string, label: string, act: () => void | Promise<void>): HTMLButtonElement {
  let timer: ReturnType<typeof setTimeout> | null = null;
  let isHeld = false;
  const end = () => {
    isHeld = false;
    if (timer !== null) clearTimeout(timer);
    timer = null;
  };
  const work = async (pause_ms: number) => {
    await act();
    if (isHeld) timer = setTimeout(() => void work(REPEAT_DELAY_MS), pause_ms);
  };
  const button = element(
    "button",
    {
      type: "button",
      class: "jog",
      title: label,
      "aria-label": label,
      onpointerdown: (event) => {
        if ((event as PointerEvent).button !== 0) return;
        button.setPointerCapture((event as PointerEvent).pointerId);
        end();
        isHeld = true;
        void work(INITIAL_DELAY_MS);
      },
      onpointerup: end,
      onpointercancel: end,
      onblur: end,
      // By keyboard, which repeats by itself.
      onclick: (event) => {
        if ((event as MouseEvent).detail === 0) void act();
      },
    },
    text,
  );
  return button;
}
