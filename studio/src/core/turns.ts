// What is done to a thing is done one behind the other: each finds what the one before has left.

export class Turns {
  private readonly last = new Map<string, Promise<unknown>>();

  /** Does it when all that was begun for this name before has ended, be it in a fault. */
  take<T>(name: string, act: () => Promise<T>): Promise<T> {
    const done = (this.last.get(name) ?? Promise.resolve()).then(act, act);
    const forget = () => {
      if (this.last.get(name) === done) this.last.delete(name);
    };
    this.last.set(name, done);
    void done.then(forget, forget);
    return done;
  }
}
