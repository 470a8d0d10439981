// Fixed and reference points of the setup's machine data, as in the data tab.

import type { Session } from "../../core/session";
import { noPoints, type KnownPoint, type KnownPoints } from "../../run/path/machine_points";
import { requestData, type Entry } from "../data/data_request";

const toKnownPoints = (entries: readonly Entry[] | undefined): KnownPoint[] =>
  (entries ?? []).map(({ id, NAME }) => ({ number: Number(id), name: String(NAME ?? "") }));

export class SetupPoints {
  private known: KnownPoints | null = noPoints;
  private isVisible = false;
  private requestNumber = 0;
  private asked = "";

  constructor(
    private readonly session: Session,
    private readonly changed: () => void,
  ) {
    session.on(() => this.refresh(this.asked));
    session.documents.on((name) => {
      const { machine_data, machine, cell } = session.setup;
      if ([machine_data, machine, cell].includes(name)) this.refresh();
    });
  }

  /** Returns null if the data cannot be read. */
  get points(): KnownPoints | null {
    return this.known;
  }

  /** Returns the file of the points; empty: none. */
  get file(): string {
    return this.session.setup.machine_data;
  }

  onDisplayed(): void {
    this.isVisible = true;
    this.refresh();
  }

  onHidden(): void {
    this.isVisible = false;
  }

  /** Requests the points again, unless the last request was the same. */
  private refresh(last = ""): void {
    const { machine_data, machine, cell } = this.session.setup;
    const asked = [machine_data, machine, cell].join("\n");
    if (!this.isVisible || asked === last) return;
    this.asked = asked;
    void this.ask();
  }

  private async ask(): Promise<void> {
    const requestNumber = ++this.requestNumber;
    const { file } = this;
    const data = file ? (await requestData(this.session, file, [])).data : null;
    // A later request has the later points.
    if (requestNumber !== this.requestNumber) return;
    const found = data && { fixed: toKnownPoints(data.entries.FIXED), reference: toKnownPoints(data.entries.REFERENCE) };
    this.known = file ? found : noPoints;
    this.changed();
  }
}
