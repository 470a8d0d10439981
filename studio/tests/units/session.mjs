// Order of the page's own program and variants: a run that they end is made after them.

import assert from "node:assert/strict";

export const modules = ["core/session", "core/store", "core/documents", "core/setup", "panels/variants/data/runner"];

/** Time longer than the delay after changes before the program runs again. */
const SOON_MS = 600;
const pause = (ms) => new Promise((go) => setTimeout(go, ms));

/**
 * Returns a session with an engine that responds on command; `asked` has the programs of its runs, in order.
 */
function made({ Session, Store, initialState, Documents, emptySetup, Runner }) {
  const asked = [];
  let tell = () => {};
  const engine = {
    available: true,
    runStorage: null,
    ask: ({ program }) =>
      new Promise((done) => {
        asked.push(program);
        tell = done;
      }),
    cancel: () => tell({ ok: false, code: "cancelled", message: "" }),
  };
  const store = new Store(initialState());
  const session = new Session(store, new Documents(new Map([["page.nc", ""]])), engine, engine);
  session.change({ ...emptySetup(), program: "page.nc" });
  const response = async (ok = true) => {
    tell(ok ? { ok } : { ok, code: "program", message: "no" });
    await pause(0);
  };
  const runner = new Runner(session, { accept: () => {} }, () => {});
  const variant = (name) => ({ name, setup: { ...emptySetup(), program: name }, from: null });
  return { session, store, asked, response, runner, run: (...names) => runner.run(names.map(variant)) };
}

export default {
  "a run of the page that variants end is made behind the last of them, once": async (page) => {
    const { session, store, asked, response, run } = made(page);
    void session.run();
    const all = run("one.nc", "two.nc");
    assert.equal(store.get("running"), null);
    await response();
    await response();
    await all;
    assert.deepEqual(asked, ["page.nc", "one.nc", "two.nc"]);
    await pause(SOON_MS);
    assert.deepEqual(asked.slice(3), ["page.nc"]);
    await response();
    assert.equal(store.get("running"), null);
    await pause(SOON_MS);
    assert.equal(asked.length, 4);
  },

  "so is one that was due, where a variant fails": async (page) => {
    const { session, asked, response, run } = made(page);
    session.runSoon();
    const all = run("one.nc");
    await pause(SOON_MS);
    assert.deepEqual(asked, ["one.nc"]);
    await response(false);
    await all;
    await pause(SOON_MS);
    assert.deepEqual(asked, ["one.nc", "page.nc"]);
  },

  "and where variants are cancelled, or others are run in their place": async (page) => {
    const { session, asked, run, runner } = made(page);
    void session.run();
    void run("one.nc");
    void run("two.nc");
    await pause(SOON_MS);
    runner.cancel();
    assert.deepEqual(asked, ["page.nc", "one.nc", "two.nc"]);
    await pause(SOON_MS);
    assert.deepEqual(asked.slice(3), ["page.nc"]);
    // Due while they run.
    void run("three.nc");
    session.runSoon();
    runner.cancel();
    await pause(SOON_MS);
    assert.deepEqual(asked.slice(4), ["three.nc", "page.nc"]);
  },

  "where none was due, or one has been made meanwhile, none follows": async (page) => {
    const { session, asked, response, run } = made(page);
    const alone = run("one.nc");
    await response();
    await alone;
    session.runSoon();
    const ended = run("two.nc");
    void session.run();
    await ended;
    await response();
    await pause(SOON_MS);
    assert.deepEqual(asked, ["one.nc", "two.nc", "page.nc"]);
  },
};
