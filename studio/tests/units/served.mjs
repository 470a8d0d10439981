// Communication between a page and gsim-studio: partial frames, responses with errors, and the files that are
// sent along.

import assert from "node:assert/strict";
import { createServer } from "node:http";

export const modules = ["core/frame_splitter", "core/message", "core/remote_engine", "core/server", "core/documents", "core/affects_run", "core/file_kinds", "core/setup"];

const bytesOf = (text) => new TextEncoder().encode(text);

function frame(header, more = 0) {
  const text = bytesOf(JSON.stringify({ format: 1, ...header }));
  const bytes = new Uint8Array(((8 + text.length + 7) & ~7) + more);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, bytes.length, true);
  view.setUint32(4, text.length, true);
  bytes.set(text, 8);
  return bytes;
}

const numbers = () => {
  const bytes = frame({ is: "segments", columns: [["start_s", "f64", 2]] }, 16);
  new Float64Array(bytes.buffer, bytes.length - 16).set([1.5, -2]);
  return bytes;
};
const done = () => frame({ is: "done" });

/** Sends requests to an engine with a server that responds by `respond`. */
async function withServer(respond, test) {
  const server = createServer((request, response) => void respond(request, response));
  await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  try {
    return await test(new URL(`http://127.0.0.1:${server.address().port}/token/`));
  } finally {
    server.closeAllConnections();
    server.close();
  }
}

const engineAt = (page, address) => new page.RemoteEngine(new page.Server(address));
const asked = async (request) => JSON.parse(Buffer.concat(await request.toArray()).toString());

export default {
  "frames come out whole and aligned however the bytes come": ({ FrameSplitter, readMessage }) => {
    const all = Buffer.concat([numbers(), frame({ is: "diagnostic", text: "a" }), numbers(), done()]);
    for (const size of [1, 2, 3, 5, 7, 8, 13, 64, all.length]) {
      const found = [];
      const cutter = new FrameSplitter();
      for (let at = 0; at < all.length; at += size) {
        cutter.push(all.subarray(at, at + size), (bytes) => {
          assert.equal(bytes.byteOffset % 8, 0);
          found.push(readMessage(bytes));
        });
      }
      assert.deepEqual(found.map(({ is }) => is), ["segments", "diagnostic", "segments", "done"], `pieces of ${size}`);
      assert.deepEqual([...found[2].columns.get("start_s")], [1.5, -2]);
    }
  },

  "a frame of less than its head is refused": ({ FrameSplitter, InvalidMessage }) => {
    for (const size of [0, 7]) assert.throws(() => new FrameSplitter().push(Uint8Array.of(size, 0, 0, 0), () => {}), InvalidMessage);
  },

  "an answer is taken as it comes, and files go along": (page) =>
    withServer(
      async (request, response) => {
        assert.equal(request.url, "/token/ask");
        const { request: sendRequest, files, binary } = await asked(request);
        assert.deepEqual([sendRequest, files, binary], [{ do: "run" }, { "a.nc": "G0 \ufffd" }, { "m.stl": "AP8=" }]);
        const bytes = numbers();
        response.write(bytes.subarray(0, 9));
        setTimeout(() => response.end(Buffer.concat([bytes.subarray(9), done()])), 5);
      },
      async (address) => {
        const told = [];
        const files = new Map([["a.nc", "G0 \ud800"], ["m.stl", Uint8Array.of(0, 255)]]);
        const result = await engineAt(page, address).ask({ do: "run" }, files, ({ is }) => told.push(is));
        assert.deepEqual([result.ok, told], [true, ["segments", "done"]]);
      },
    ),

  "answers that fail say why": async (page) => {
    const fails = async (respond, expectedValue) => {
      const { ok, message } = await withServer(respond, (address) => engineAt(page, address).ask({}, new Map(), () => {}));
      assert.equal(ok, false);
      assert.match(message, expectedValue);
    };
    await fails((_, response) => response.writeHead(403).end('{"error": "another page"}'), /^another page$/);
    await fails((_, response) => response.writeHead(500).end("oh"), /status 500/);
    await fails((_, response) => response.end(numbers()), /ended prematurely/);
    await fails((_, response) => response.end(numbers().subarray(0, 20)), /ended prematurely/);
    await fails((_, response) => response.end(Uint8Array.of(1, 0, 0, 0)), /1 bytes/);
    await fails((_, response) => response.end(frame({ is: "failed", message: "no such axis" })), /^no such axis$/);
    await fails((_, response) => response.destroy(), /does not respond/);
  },

  "questions wait for each other, and end together": (page) => {
    let [open, most] = [0, 0];
    return withServer(
      async (request, response) => {
        most = Math.max(most, ++open);
        response.on("close", () => --open);
        const { request: sendRequest } = await asked(request);
        if (sendRequest.do !== "endless") setTimeout(() => response.end(done()), 10);
        else response.write(numbers());
      },
      async (address) => {
        const engine = engineAt(page, address);
        const ask = (what, accept = () => {}) => engine.ask({ do: what }, new Map(), accept);
        const answers = await Promise.all([ask("a"), ask("b"), ask("c")]);
        assert.deepEqual([answers.map(({ ok }) => ok), most], [[true, true, true], 1]);
        const cancelled = ask("endless", () => engine.cancel());
        const waiting = ask("never");
        assert.deepEqual([(await cancelled).code, (await waiting).code], ["cancelled", "cancelled"]);
        assert.equal((await ask("after")).ok, true);
      },
    );
  },

  "changes are asked for since the last answer, until there is none": (page) => {
    const answers = {
      "/token/changes": { at: 3, again: true, changed: [] },
      "/token/changes?since=3": { at: 5, again: false, changed: [{ name: "a.nc", tag: "1" }, { name: "b.nc", tag: null }] },
      "/token/changes?since=5": { at: 9, again: true, changed: [] },
    };
    return withServer(
      (request, response) => {
        const result = answers[request.url];
        if (!result) return response.writeHead(403).end();
        return response.end(JSON.stringify(result));
      },
      async (address) => {
        const told = [];
        await new page.Server(address).follow(() => told.push("all"), ({ name, tag }) => told.push(name, tag));
        assert.deepEqual(told, ["all", "a.nc", "1", "b.nc", null, "all"]);
      },
    );
  },

  "a file is written in place of the version that was read": (page) =>
    withServer(
      async (request, response) => {
        assert.equal(request.url, "/token/file/a%20b/%C3%A4%23.nc");
        const condition = [request.headers["if-match"], request.headers["if-none-match"]].join();
        if (condition === '"old",') return response.writeHead(412).end('{"error": "x", "tag": "other"}');
        return response.end(JSON.stringify({ tag: condition === ",*" ? "new" : "?" }));
      },
      async (address) => {
        const server = new page.Server(address);
        assert.deepEqual(await server.write("a b/ä#.nc", bytesOf("x"), null), { ok: true, tag: "new" });
        assert.deepEqual(await server.write("a b/ä#.nc", bytesOf("x"), "old"), { ok: false, tag: "other" });
      },
    ),

  "the engine is given what it cannot read by itself": ({ Documents }) => {
    const documents = new Documents(new Map([["samples/a.nc", "G0"]]), true);
    documents.list("far.nc", 1e9);
    const drop = (name, bytes) => documents.put(name, documents.read(name, bytes));
    documents.storeFolderFile("part.nc", bytesOf("G1\r\n"));
    drop("dropped.nc", bytesOf("G2"));
    assert.deepEqual([...documents.files().keys()], ["dropped.nc"]);
    documents.put("part.nc", "G1\n"); // as an editor has lines
    assert.deepEqual([documents.isUnsaved("part.nc"), documents.files().size], [false, 1]);
    documents.put("part.nc", "G1 X1\n");
    drop("far.nc", bytesOf("G3"));
    assert.deepEqual(documents.unsavedNames(), ["part.nc", "far.nc"], "what lies over a file of the folder is an edit");
    assert.deepEqual([...documents.files()], [["part.nc", "G1 X1\n"], ["dropped.nc", "G2"], ["far.nc", "G3"]]);
    documents.saved("part.nc", "G1 X1\n", bytesOf("G1 X1\r\n"));
    assert.equal(documents.isUnsaved("part.nc"), false);
    documents.removeFolderFile("part.nc");
    assert.equal(documents.files().has("part.nc"), true, "what is gone from the folder");
  },

  "a run is another one by what it reads": ({ affectsRun, kindOfFile, emptySetup }) => {
    const setup = { ...emptySetup(), program: "a.nc", machine: "m.toml" };
    const ran = { robots: [{ files: ["a.nc", "sub.nc"] }], diagnostics: [{ file: "broken.nc" }] };
    const axis = "[[axis]]\n";
    const of = (name, content = "G1", given = setup) => affectsRun(name, kindOfFile(name, content), given, ran);
    assert.deepEqual(["a.nc", "sub.nc", "broken.nc", "other.nc"].map((name) => of(name)), [true, true, true, false]);
    assert.deepEqual([of("m.toml", axis), of("n.toml", axis), of("n.toml", axis, { ...setup, cell: "c.toml" })], [true, false, true]);
    assert.deepEqual([of("control.toml", "[controller]\n"), of("path.json", "{}"), of("body.stl", undefined)], [true, false, true]);
    assert.equal(affectsRun("", "program", emptySetup(), null), false);
  },
};
