// Undo and redo: the previous state comes back, regardless of the source of the change.

import assert from "node:assert/strict";

export const modules = ["core/history", "core/documents"];

/** Returns a history with its own documents and setup, and all its notifications. */
function made({ History, Documents }, samples = {}, mostCharacters = undefined) {
  const documents = new Documents(new Map(Object.entries(samples)));
  const session = { setup: { program: "a.nc", machine: "" }, change: (part) => (session.setup = { ...session.setup, ...part }) };
  const history = new History(documents, session, mostCharacters);
  const told = [];
  history.on((applied) => told.push(applied));
  /** As an editor does. */
  const type = (name, text, merge = "type") => {
    const before = { documents: { [name]: documents.own(name) ?? null } };
    documents.put(name, text);
    history.recordChange(`typing in ${name}`, before, merge);
  };
  return { documents, session, history, told, type };
}

/** Lets time pass without waiting. */
function at(t_ms, act) {
  const { now } = Date;
  Date.now = () => t_ms;
  try {
    return act();
  } finally {
    Date.now = now;
  }
}

export default {
  "documents and choices of one step go and come together": (page) => {
    const { documents, session, history, told } = made(page, { "m.toml": "sample" });
    const change = { documents: { "data.txt": "1", "m.toml": "own" }, setup: { machine: "m.toml" } };
    history.edit("both", change);
    assert.deepEqual([documents.own("data.txt"), documents.own("m.toml"), session.setup.machine], ["1", "own", "m.toml"]);
    assert.deepEqual([history.undoLabel, history.redoLabel], ["both", ""]);
    history.undo();
    assert.deepEqual([documents.get("data.txt"), documents.get("m.toml"), session.setup.machine], [undefined, "sample", ""]);
    assert.deepEqual([history.undoLabel, history.redoLabel], ["", "both"]);
    history.redo();
    assert.deepEqual([documents.own("data.txt"), documents.own("m.toml"), session.setup], ["1", "own", { program: "a.nc", machine: "m.toml" }]);
    assert.deepEqual(told, [change, { documents: { "data.txt": null, "m.toml": null }, setup: { machine: "" } }, change]);
  },

  "a document that is taken away comes back": (page) => {
    const { documents, history } = made(page);
    history.edit("put", { documents: { "a.txt": "1" } });
    history.edit("taken away", { documents: { "a.txt": null } });
    assert.equal(documents.get("a.txt"), undefined);
    history.undo();
    assert.equal(documents.own("a.txt"), "1");
  },

  "steps go back one by one, and a new one ends what could be done again": (page) => {
    const { documents, history } = made(page);
    for (const text of ["1", "2", "3"]) history.edit(text, { documents: { "a.txt": text } });
    history.undo();
    history.undo();
    assert.equal(documents.own("a.txt"), "1");
    history.edit("4", { documents: { "a.txt": "4" } });
    assert.equal(history.redoLabel, "");
    history.redo();
    assert.equal(documents.own("a.txt"), "4");
    history.undo();
    history.undo();
    assert.equal(documents.own("a.txt"), undefined);
    history.undo();
    assert.equal(history.undoLabel, "");
  },

  "what changes nothing is no step, and nobody is told": (page) => {
    const { history, told, documents } = made(page);
    history.edit("none", { documents: {}, setup: { machine: "" } });
    documents.put("a.txt", "1");
    history.edit("none", { documents: { "a.txt": "1" } });
    history.recordChange("none", { documents: { "a.txt": "1" } });
    assert.deepEqual([history.undoLabel, told], ["", []]);
  },

  "typing is one step until a pause, and told as made already": (page) => {
    const { documents, history, told, type } = made(page, { "a.nc": "G0" });
    at(0, () => type("a.nc", "G0 X"));
    at(1400, () => type("a.nc", "G0 X1"));
    at(2800, () => type("a.nc", "G0 X12"));
    at(4400, () => type("a.nc", "G0 X12 Y"));
    assert.deepEqual(told, [null, null, null, null]);
    history.undo();
    assert.equal(documents.get("a.nc"), "G0 X12");
    history.undo();
    assert.equal(documents.get("a.nc"), "G0");
    assert.equal(history.undoLabel, "");
  },

  "edits of another kind, or of another document, are steps of their own": (page) => {
    const { documents, history, type } = made(page);
    at(0, () => {
      type("a.nc", "1", "type a.nc");
      type("a.nc", "", "delete a.nc");
      type("b.nc", "2", "type b.nc");
      type("b.nc", "3", "");
      type("b.nc", "4", "");
    });
    const back = () => (history.undo(), [documents.own("a.nc"), documents.own("b.nc")]);
    assert.deepEqual([back(), back(), back(), back()], [["", "3"], ["", "2"], ["", undefined], ["1", undefined]]);
  },

  "what is merged knows of each document and choice what was there first": (page) => {
    const { documents, session, history } = made(page);
    at(0, () => {
      history.edit("drag", { documents: { "a.txt": "1" } }, "drag");
      history.edit("drag", { documents: { "a.txt": "2", "b.txt": "1" }, setup: { machine: "m" } }, "drag");
      history.edit("drag", { setup: { machine: "n" } }, "drag");
    });
    history.undo();
    assert.deepEqual([documents.userFileNames(), session.setup.machine, history.undoLabel], [[], "", ""]);
    history.redo();
    assert.deepEqual([documents.own("a.txt"), documents.own("b.txt"), session.setup.machine], ["2", "1", "n"]);
  },

  "what was done again is not typed on": (page) => {
    const { documents, history, type } = made(page);
    at(0, () => {
      type("a.nc", "1");
      history.undo();
      history.redo();
      type("a.nc", "12");
    });
    history.undo();
    assert.equal(documents.own("a.nc"), "1");
  },

  "an editor's own undo is a step, too: what it took away comes back": (page) => {
    const { documents, history, type } = made(page, { "a.nc": "old" });
    at(0, () => {
      type("a.nc", "typed", "input.type a.nc");
      type("a.nc", "old", "undo a.nc");
    });
    history.undo();
    assert.equal(documents.get("a.nc"), "typed");
    history.undo();
    assert.equal(documents.get("a.nc"), "old");
    history.redo();
    history.redo();
    assert.equal(documents.get("a.nc"), "old");
  },

  "what was changed without a step comes back with redo": (page) => {
    const { documents, session, history } = made(page);
    history.edit("one", { documents: { "a.txt": "1" }, setup: { machine: "m" } });
    documents.put("a.txt", "from elsewhere");
    session.change({ machine: "n" });
    history.undo();
    assert.deepEqual([documents.own("a.txt"), session.setup.machine], [undefined, ""]);
    history.redo();
    assert.deepEqual([documents.own("a.txt"), session.setup.machine], ["from elsewhere", "n"]);
  },

  "what is typed and not handed over is a step before anything is taken back": (page) => {
    const { documents, history, type } = made(page);
    type("a.nc", "1", "");
    let waiting = "12";
    history.onStep(() => {
      if (waiting) type("a.nc", waiting, "");
      waiting = "";
    });
    history.undo();
    assert.equal(documents.own("a.nc"), "1");
    history.redo();
    assert.equal(documents.own("a.nc"), "12");
  },

  "of texts that are too large together the oldest go, and the last stays": (page) => {
    const { documents, history } = made(page, {}, 25);
    for (const text of ["a", "b", "c", "d"]) history.edit(text, { documents: { "a.txt": text.repeat(10) } });
    history.undo();
    history.undo();
    assert.deepEqual([documents.own("a.txt")[0], history.undoLabel], ["b", ""]);
    history.redo();
    history.redo();
    assert.equal(documents.own("a.txt")[0], "d");
    history.edit("long", { documents: { "a.txt": "e".repeat(99) } });
    history.edit("short", { documents: { "a.txt": "f" } });
    history.undo();
    assert.equal(documents.own("a.txt").length, 99);
  },
};
