// Actions on the same object, done one after another: each one finds the result of the one before.

export class TaskQueues {
  private readonly last = new Map<string, Promise<unknown>>();

  /** Does `act` after all earlier actions for this name have ended, with or without an error. */
  accept<T>(name: string, act: () => Promise<T>): Promise<T> {
    const done = (this.last.get(name) ?? Promise.resolve()).then(act, act);
    const forget = () => {
      if (this.last.get(name) === done) this.last.delete(name);
    };
    this.last.set(name, done);
    void done.then(forget, forget);
    return done;
  }
}
