// The files that a person has opened, beside the samples: programs, machines, cells, tools, meshes.

import type { Files } from "./engine";

export type FileContent = string | Uint8Array;

/** Files by name; who listens is told the name of each that changes. */
export class Documents {
  private readonly own = new Map<string, FileContent>();
  private readonly listeners = new Set<(name: string) => void>();

  constructor(readonly samples: ReadonlyMap<string, FileContent>) {}

  get(name: string): FileContent | undefined {
    return this.own.get(name) ?? this.samples.get(name);
  }

  text(name: string): string {
    const content = this.get(name);
    if (content === undefined) return "";
    return typeof content === "string" ? content : new TextDecoder().decode(content);
  }

  /** Puts a file; samples of that name are left as they are beneath it. */
  put(name: string, content: FileContent): void {
    this.own.set(name, content);
    for (const listener of this.listeners) listener(name);
  }

  /** Whether a person has opened or changed it. */
  isOwn(name: string): boolean {
    return this.own.has(name);
  }

  ownNames(): string[] {
    return [...this.own.keys()];
  }

  on(listener: (name: string) => void): void {
    this.listeners.add(listener);
  }

  /** All that the engine may ask for. */
  files(): Files {
    return new Map([...this.samples, ...this.own]);
  }
}
