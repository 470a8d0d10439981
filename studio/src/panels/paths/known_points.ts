// Fixed and reference points of the setup's machine data, as in the data tab.

import type { Session } from "../../core/session";
import { noPoints, type KnownPoint, type KnownPoints } from "../../run/path/machine_points";
import { askData, type Entry } from "../data/asked";

const pointsOf = (entries: readonly Entry[] | undefined): KnownPoint[] =>
  (entries ?? []).map(({ id, NAME }) => ({ number: Number(id), name: String(NAME ?? "") }));

export class KnownPointsOfSetup {
  private known: KnownPoints | null = noPoints;
  private isShown = false;
  private question = 0;
  private asked = "";

  constructor(
    private readonly session: Session,
    private readonly changed: () => void,
  ) {
    session.on(() => this.renew(this.asked));
    session.documents.on((name) => {
      const { machine_data, machine, cell } = session.setup;
      if ([machine_data, machine, cell].includes(name)) this.renew();
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

  shown(): void {
    this.isShown = true;
    this.renew();
  }

  hidden(): void {
    this.isShown = false;
  }

  /** Requests the points again, unless the last request was the same. */
  private renew(last = ""): void {
    const { machine_data, machine, cell } = this.session.setup;
    const asked = [machine_data, machine, cell].join("\n");
    if (!this.isShown || asked === last) return;
    this.asked = asked;
    void this.ask();
  }

  private async ask(): Promise<void> {
    const question = ++this.question;
    const { file } = this;
    const data = file ? (await askData(this.session, file, [])).data : null;
    // A later request has the later points.
    if (question !== this.question) return;
    const found = data && { fixed: pointsOf(data.entries.FIXED), reference: pointsOf(data.entries.REFERENCE) };
    this.known = file ? found : noPoints;
    this.changed();
  }
}
