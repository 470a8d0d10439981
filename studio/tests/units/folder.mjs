// Served folder: conflicts between saves, reads and changes by other programs.

import assert from "node:assert/strict";

export const modules = ["core/folder", "core/history", "core/documents", "core/task_queues", "core/store", "core/path_editing", "texts"];

const bytesOf = (text) => new TextEncoder().encode(text);
const textOf = (bytes) => new TextDecoder().decode(bytes);
const untilSettled = () => new Promise((done) => setTimeout(done, 0));

/** Tags say which content a file has. */
const tagOf = (text) => `tag of ${text}`;

/**
 * Creates a server in place of gsim-studio: `files` is the disk; tell() reports a change. Each request awaits
 * `before`.
 */
function fakeServer(disk) {
  const server = {
    files: new Map(Object.entries(disk)),
    writes: [],
    before: async () => {},
    most: Infinity,
    list: async () => ({
      files: [...server.files].slice(0, server.most).map(([name, text]) => ({ name, bytes: text.length, tag: tagOf(text) })),
      cut: server.files.size > server.most,
    }),
    async read(name) {
      await server.before("read", name);
      const text = server.files.get(name);
      return text === undefined ? null : { bytes: bytesOf(text), tag: tagOf(text) };
    },
    async write(name, bytes, tag) {
      await server.before("write", name);
      const there = server.files.get(name);
      const present = there === undefined ? null : tagOf(there);
      server.writes.push([name, textOf(bytes)]);
      if (present !== tag) return { ok: false, tag: present };
      server.files.set(name, textOf(bytes));
      return { ok: true, tag: tagOf(textOf(bytes)) };
    },
    follow(begun, changed) {
      server.begun = () => (begun(), untilSettled());
      server.tell = (name, text) => (changed({ name, tag: text === undefined ? null : tagOf(text) }), untilSettled());
      return new Promise(() => {});
    },
    /** As another program does. */
    async change(name, text) {
      server.files.set(name, text);
      await server.tell(name, text);
    },
  };
  return server;
}

/** A gate that requests wait at. */
function gate(server, kind) {
  let go;
  const open = new Promise((resolve) => (go = resolve));
  server.before = (asked) => (asked === kind ? open : Promise.resolve());
  return async () => {
    server.before = async () => {};
    go();
    await untilSettled();
  };
}

/** A folder with these files, all read, and a page about it; `editor.kept` is what was typed and not handed on. */
async function opened({ Folder, History, Documents, Store, initialState }, disk, setup = {}, server = fakeServer(disk)) {
  const documents = new Documents(new Map([["samples/wheel.nc", "G21\n"]]), true);
  const notices = [];
  const store = new Store(initialState());
  store.on("notice", (notice) => notices.push(notice));
  const session = {
    documents,
    setup: { program: "", ...setup },
    change: (part) => (session.setup = { ...session.setup, ...part }),
    on: () => {},
    changed: () => false,
    store,
  };
  const history = (session.history = new History(documents, session));
  const editor = { kept: null };
  history.onStep(() => {
    if (!editor.kept) return;
    const [name, text] = editor.kept;
    editor.kept = null;
    type(name, text);
  });
  const type = (name, text) => {
    const before = { documents: { [name]: documents.own(name) ?? null } };
    documents.put(name, text);
    history.recordChange(`typing in ${name}`, before);
  };
  const folder = new Folder(server, session);
  await folder.open();
  void folder.follow();
  await untilSettled();
  return { server, documents, session, history, folder, editor, notices, store, type };
}

export default {
  "two saves of one file at once are one behind the other": async (page) => {
    const { server, documents, folder, type } = await opened(page, { "a.nc": "1" });
    const open = gate(server, "write");
    type("a.nc", "12");
    const first = folder.save("a.nc");
    await untilSettled();
    type("a.nc", "123");
    const second = folder.save("a.nc");
    await open();
    assert.deepEqual([(await first).kind, (await second).kind], ["saved", "saved"]);
    assert.deepEqual(server.writes, [["a.nc", "12"], ["a.nc", "123"]]);
    assert.deepEqual([documents.isUnsaved("a.nc"), folder.markFor("a.nc")], [false, ""]);
  },

  "a file that a list leaves out as it is cut is not gone, one that a whole list has no more is": async (page) => {
    const { server, documents } = await opened(page, { "a.nc": "1", "b.nc": "2" });
    server.most = 1;
    await server.begun();
    assert.equal(documents.text("b.nc"), "2");
    server.most = Infinity;
    server.files.delete("b.nc");
    await server.begun();
    assert.ok(!documents.names().includes("b.nc"));
  },

  "a path file that is chosen before it was read is shown as soon as it is, one that goes is chosen no longer": async (page) => {
    const path = JSON.stringify({ paths: [{ name: "P", targets: [{ motion: "linear", position_mm: [1, 2, 3] }] }] });
    const server = fakeServer({ "a.path.json": path, "b.variants.json": "{}" });
    const open = gate(server, "read");
    const { store, session, documents } = await opened(page, {}, {}, server);
    page.watchPath(store, session);
    store.set("pathFile", "a.path.json");
    assert.deepEqual([store.get("pathFile"), store.get("path"), documents.exists("b.variants.json")], ["a.path.json", null, true]);
    await open();
    assert.deepEqual([store.get("path")?.name, store.get("path")?.error], ["a.path.json", ""]);
    server.files.delete("a.path.json");
    await server.tell("a.path.json", undefined);
    assert.deepEqual([store.get("pathFile"), store.get("path")], ["", null]);
  },

  "turns of one name wait for each other, whatever became of those before": async ({ TaskQueues }) => {
    const taskQueues = new TaskQueues();
    const done = [];
    let open;
    const fails = taskQueues.accept("a", () => new Promise((_, fail) => (open = () => fail(new Error("first")))));
    const behind = taskQueues.accept("a", async () => done.push("second of a"));
    await taskQueues.accept("b", async () => done.push("b"));
    assert.deepEqual(done, ["b"]);
    open();
    await assert.rejects(fails, /first/);
    await behind;
    assert.deepEqual(done, ["b", "second of a"]);
  },

  "what was saved here before is told late, and is no version of another program": async (page) => {
    const { server, folder, history, type } = await opened(page, { "a.nc": "1" });
    for (const text of ["12", "123"]) {
      type("a.nc", text);
      await folder.save("a.nc");
    }
    type("a.nc", "1234");
    void server.tell("a.nc", "12");
    assert.equal((await folder.save("a.nc")).kind, "saved");
    await server.tell("a.nc", "123");
    assert.deepEqual([folder.markFor("a.nc"), server.files.get("a.nc"), history.undoLabel], ["", "1234", "typing in a.nc"]);
  },

  "a save waits for a version of another program that is being read": async (page) => {
    const { server, documents, folder } = await opened(page, { "a.nc": "1" });
    const open = gate(server, "read");
    await server.change("a.nc", "theirs");
    const saved = folder.save("a.nc");
    await open();
    await saved;
    assert.deepEqual([server.files.get("a.nc"), documents.text("a.nc")], ["theirs", "theirs"]);
  },

  "a version of another program that could not be read is not written over": async (page) => {
    const { server, folder, notices } = await opened(page, { "a.nc": "1" });
    server.before = () => Promise.reject(new Error("no network"));
    await server.change("a.nc", "theirs");
    server.before = async () => {};
    assert.match(notices.at(-1), /a\.nc could not be read/);
    assert.equal((await folder.save("a.nc")).kind, "conflict");
    assert.deepEqual([server.files.get("a.nc"), server.writes], ["theirs", []]);
  },

  "what is typed and not handed on is saved, too": async (page) => {
    const { server, documents, folder, editor } = await opened(page, { "a.nc": "1" });
    editor.kept = ["a.nc", "12"];
    await folder.save("a.nc");
    assert.deepEqual([server.files.get("a.nc"), documents.text("a.nc")], ["12", "12"]);
  },

  "what is typed while a save is under way is unsaved behind it": async (page) => {
    const { server, documents, folder, editor, type } = await opened(page, { "a.nc": "1" });
    const open = gate(server, "write");
    type("a.nc", "12");
    const saved = folder.save("a.nc");
    await untilSettled();
    editor.kept = ["a.nc", "123"];
    await open();
    await saved;
    assert.deepEqual([server.files.get("a.nc"), documents.text("a.nc"), folder.markFor("a.nc")], ["12", "123", "unsaved"]);
  },

  "what is typed while another version is read makes two of it": async (page) => {
    const { server, documents, folder, editor } = await opened(page, { "a.nc": "1" });
    const open = gate(server, "read");
    await server.change("a.nc", "theirs");
    editor.kept = ["a.nc", "12"];
    await open();
    assert.deepEqual([documents.text("a.nc"), folder.markFor("a.nc")], ["12", "conflict"]);
  },

  "what is typed into a file that is taken away stays": async (page) => {
    const { server, documents, folder, editor } = await opened(page, { "a.nc": "1" });
    editor.kept = ["a.nc", "12"];
    server.files.delete("a.nc");
    await server.tell("a.nc", undefined);
    assert.deepEqual([documents.text("a.nc"), folder.markFor("a.nc")], ["12", "gone"]);
  },

  "what is typed while theirs is taken comes back by undo": async (page) => {
    const { server, documents, folder, editor, history, type } = await opened(page, { "a.nc": "1" });
    type("a.nc", "12");
    await server.change("a.nc", "theirs");
    const open = gate(server, "read");
    const taken = folder.loadDiskVersion("a.nc");
    await untilSettled();
    editor.kept = ["a.nc", "123"];
    await open();
    await taken;
    assert.equal(documents.text("a.nc"), "theirs");
    history.undo();
    assert.equal(documents.text("a.nc"), "123");
  },

  "a decision that the server does not hear is said": async (page) => {
    const { server, folder, notices, type } = await opened(page, { "a.nc": "1" });
    type("a.nc", "12");
    await server.change("a.nc", "theirs");
    server.before = () => Promise.reject(new Error("no network"));
    assert.equal((await folder.keepMine("a.nc")).kind, "failed");
    await folder.loadDiskVersion("a.nc");
    assert.match(notices.at(-1), /a\.nc could not be read/);
  },

  "undo of a new file that was saved leaves the one of the folder": async (page) => {
    const { server, documents, folder, history, session } = await opened(page, { "a.nc": "1" }, { program: "a.nc" });
    history.edit("new", { documents: { "new.nc": "2" }, setup: { program: "new.nc" } });
    await folder.save("new.nc");
    history.undo();
    await untilSettled();
    assert.deepEqual([session.setup.program, documents.text("new.nc"), folder.markFor("new.nc")], ["a.nc", "2", ""]);
    history.redo();
    assert.deepEqual([session.setup.program, documents.text("new.nc"), folder.markFor("new.nc")], ["new.nc", "2", ""]);
    history.undo();
    await server.change("new.nc", "theirs");
    assert.equal(documents.text("new.nc"), "theirs");
  },

  "what another program changes is a step of its own": async (page) => {
    const { server, documents, folder, history, type } = await opened(page, { "a.nc": "1" });
    type("a.nc", "12");
    await folder.save("a.nc");
    await server.change("a.nc", "12, theirs");
    assert.equal(history.undoLabel, page.texts.folder.replaced("a.nc"));
    history.undo();
    assert.deepEqual([documents.text("a.nc"), folder.markFor("a.nc"), history.undoLabel], ["12", "unsaved", "typing in a.nc"]);
    history.redo();
    assert.deepEqual([documents.text("a.nc"), folder.markFor("a.nc")], ["12, theirs", ""]);
  },

  "a file is not saved under the name of another one that is unsaved": async (page) => {
    const { server, documents, folder } = await opened(page, { "a.nc": "1" });
    documents.put("samples/wheel.nc", "G20\n");
    documents.put("mine.nc", "typed");
    const saved = await folder.saveAs("samples/wheel.nc", "mine.nc");
    assert.deepEqual([saved.kind, saved.why], ["failed", page.texts.folder.exists]);
    assert.deepEqual([documents.text("mine.nc"), server.writes], ["typed", []]);
  },

  "what is typed while a file is saved under another name is there, unsaved": async (page) => {
    const { server, documents, folder, editor, session, history } = await opened(page, {}, { program: "samples/wheel.nc" });
    documents.put("samples/wheel.nc", "G21\nG1\n");
    const open = gate(server, "write");
    const saved = folder.saveAs("samples/wheel.nc", "mine.nc");
    await untilSettled();
    editor.kept = ["samples/wheel.nc", "G21\nG1 X1\n"];
    await open();
    assert.equal((await saved).kind, "saved");
    assert.deepEqual([server.files.get("mine.nc"), documents.text("mine.nc")], ["G21\nG1\n", "G21\nG1 X1\n"]);
    assert.deepEqual([session.setup.program, folder.markFor("mine.nc")], ["mine.nc", "unsaved"]);
    assert.equal(documents.isUserFile("samples/wheel.nc"), false);
    history.undo();
    assert.equal(documents.text("samples/wheel.nc"), "G21\nG1 X1\n");
  },

  "who chose another program while a file was saved under another name keeps it": async (page) => {
    const { server, documents, folder, session } = await opened(page, { "a.nc": "1" }, { program: "samples/wheel.nc" });
    documents.put("samples/wheel.nc", "G21\nG1\n");
    const open = gate(server, "write");
    const saved = folder.saveAs("samples/wheel.nc", "mine.nc");
    await untilSettled();
    session.change({ program: "a.nc" });
    await open();
    await saved;
    assert.equal(session.setup.program, "a.nc");
  },
};
