// Requests the check after changes of the files: automatically while it is quick, else on demand.

import { Debounced } from "../../../core/debounced";
import { element } from "../../../core/dom";
import { texts } from "../../../texts";
import { checkMachine, type CheckResponse } from "../file/model";
import type { Context } from "../form/context";
import { CheckResult } from "./check";

const PAUSE_MS = 300;
const MAX_AUTO_CHECK_MS = 2000;

export class CheckRunner {
  private readonly button = element("button", { type: "button", hidden: true, onclick: () => void this.check() }, texts.machine.check.again);
  readonly result = new CheckResult(this.button);
  private readonly updateTimer = new Debounced(() => void this.check());
  private asked = 0;
  private duration_ms = 0;
  private checked = "";

  constructor(
    private readonly context: Context,
    private readonly onChecked: (checked: CheckResponse) => void,
  ) {
    // The check of unreadable files is quick, so the reason is shown at once.
    context.store.on("run", (run) => {
      if (run?.error && !this.button.hidden) void this.check();
    });
  }

  /** Called after the files have been read again. */
  refresh(): void {
    const now = this.currentTexts();
    if (now === this.checked) return;
    this.checked = now;
    const isQuick = this.duration_ms < MAX_AUTO_CHECK_MS;
    this.button.hidden = isQuick;
    if (isQuick) this.updateTimer.after(PAUSE_MS);
  }

  private currentTexts(): string {
    const { model, session } = this.context;
    return [...model.parts].map(([part, { file }]) => `${part} ${file}\n${session.documents.text(file)}`).join("\n");
  }

  private async check(): Promise<void> {
    const { model, session } = this.context;
    const asked = ++this.asked;
    this.button.hidden = true;
    const start_ms = performance.now();
    this.result.wait();
    const checked = await checkMachine(session, model.file("machine"), model.file("cell"));
    this.duration_ms = performance.now() - start_ms;
    if (asked !== this.asked) return;
    this.result.show(checked);
    this.onChecked(checked);
  }
}
