// Frames of the engine, complete and broken; surfaces as STL.

import assert from "node:assert/strict";

export const modules = ["core/message", "core/engine", "core/worker_engine", "core/debounced", "view/marks/stl"];

const padded = (size) => (size + 7) & ~7;

/** A frame with a column of two numbers. */
function frame(content = { is: "segments", columns: [["start_s", "f64", 2], ["kind", "u8", 3]] }) {
  const text = new TextEncoder().encode(JSON.stringify({ format: 1, ...content }));
  const bytes = new Uint8Array(padded(8 + text.length) + 24);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, bytes.length, true);
  view.setUint32(4, text.length, true);
  bytes.set(text, 8);
  view.setFloat64(bytes.length - 24, 1.5, true);
  view.setFloat64(bytes.length - 16, -2, true);
  bytes.set([7, 8, 9], bytes.length - 8);
  return bytes;
}

function together(...parts) {
  const bytes = new Uint8Array(parts.reduce((size, part) => size + part.length, 0));
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

const triangle = [0, 0, 0, 1, 0, 0, 0, 1, 0];

function binaryStl(triangles) {
  const bytes = new Uint8Array(84 + 50 * triangles.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(80, triangles.length, true);
  triangles.forEach((corners, i) => corners.forEach((x, k) => view.setFloat32(84 + 50 * i + 12 + 4 * k, x, true)));
  return bytes;
}

const textStl = (...corners) => new TextEncoder().encode(`solid a\n${corners.map((corner) => `vertex ${corner}`).join("\n")}\nendsolid`);

/** Creates an engine with a worker that responds with `bytes`. */
function engineThatSays(WorkerEngine, bytes) {
  const worker = { terminate() {}, postMessage: ({ kind, id }) => kind === "ask" && setTimeout(() => worker.onmessage({ data: { id, bytes } })) };
  return new WorkerEngine(() => worker, Promise.resolve(null));
}

export default {
  "a frame's columns lie where they stand": ({ readMessage }) => {
    const { is, columns } = readMessage(frame());
    assert.equal(is, "segments");
    assert.deepEqual([...columns.get("start_s")], [1.5, -2]);
    assert.deepEqual([...columns.get("kind")], [7, 8, 9]);
  },

  "frames are taken apart one by one": ({ splitFrames, readMessage }) => {
    const frames = [...splitFrames(together(frame(), frame({ is: "done" })))];
    assert.deepEqual(frames.map((bytes) => readMessage(bytes.slice()).is), ["segments", "done"]);
    assert.deepEqual([...splitFrames(new Uint8Array())], []);
  },

  "broken frames are refused, and end": ({ splitFrames, readMessage, InvalidMessage }) => {
    const whole = frame();
    const sized = (size) => {
      const bytes = whole.slice();
      new DataView(bytes.buffer).setUint32(0, size, true);
      return bytes;
    };
    for (const size of [0, 1, 7, whole.length + 8, 0xffffffff]) {
      assert.throws(() => [...splitFrames(sized(size))], InvalidMessage, String(size));
    }
    for (let end = 1; end < 8; ++end) assert.throws(() => [...splitFrames(whole.slice(0, end))], InvalidMessage);
    for (const end of [0, 7, 12, whole.length - 8]) assert.throws(() => readMessage(whole.slice(0, end)), InvalidMessage);
    assert.throws(() => readMessage(frame({ is: "x", columns: [["a", "f16", 1]] })), InvalidMessage);
    assert.throws(() => readMessage(frame({ format: 2, is: "done" })), /messages of format 2, and this page reads format 1/);
    assert.throws(() => readMessage(frame({ is: "x", columns: [["a", "f64", 1e6]] })), InvalidMessage);
  },

  "a question is answered by its last message": async ({ WorkerEngine }) => {
    const told = [];
    const response = await engineThatSays(WorkerEngine, frame({ is: "done" })).ask({}, new Map(), ({ is }) => told.push(is));
    assert.deepEqual([response.ok, told], [true, ["done"]]);
    const failed = await engineThatSays(WorkerEngine, frame({ is: "failed", code: "c", message: "m" })).ask({}, new Map(), () => {});
    assert.deepEqual(failed, { ok: false, code: "c", message: "m" });
  },

  "a broken message ends the question, and does not hang": async ({ WorkerEngine }) => {
    const { ok, code } = await engineThatSays(WorkerEngine, new Uint8Array(5)).ask({}, new Map(), () => {});
    assert.deepEqual([ok, code], [false, "internal"]);
  },

  "a page without an engine says so": async ({ noEngine }) => {
    assert.equal(noEngine.available, false);
    assert.equal((await noEngine.ask({}, new Map(), () => {})).code, "unavailable");
  },

  "what is debounced is done once, at once, or not at all": async ({ Debounced }) => {
    let done = 0;
    const action = new Debounced(() => ++done);
    action.flush();
    assert.equal(done, 0, "nothing was due");
    action.after(1);
    action.after(2);
    await new Promise((go) => setTimeout(go, 20));
    assert.equal(done, 1);
    action.after(1000);
    action.flush();
    assert.equal(done, 2);
    action.after(1);
    action.cancel();
    await new Promise((go) => setTimeout(go, 20));
    assert.equal(done, 2);
  },

  "STL is read as bytes and as text": ({ stlTriangles }) => {
    assert.deepEqual([...stlTriangles(binaryStl([triangle, triangle.map((x) => x + 2)]))], [...triangle, ...triangle.map((x) => x + 2)]);
    assert.deepEqual([...stlTriangles(textStl("0 0 0", "1 0 0", "0\t1e0 -0.0"))], [0, 0, 0, 1, 0, 0, 0, 1, -0]);
    // Binary file that begins with the keyword of text files.
    const named = binaryStl([triangle]);
    named.set(new TextEncoder().encode("solid of bytes"));
    assert.deepEqual([...stlTriangles(named)], triangle);
  },

  "broken STL has the triangles that are whole": ({ stlTriangles }) => {
    for (const bytes of [new Uint8Array(), new Uint8Array(84), new Uint8Array(100), binaryStl([triangle]).slice(0, 120)]) {
      assert.equal(stlTriangles(bytes).length, 0);
    }
    assert.deepEqual([...stlTriangles(textStl("0 0 0", "1 0 0", "0 1 0", "5 5 5", "6 6 6"))], triangle);
    assert.deepEqual([...stlTriangles(textStl("0 0 zero", "1 0 0", "0 1 0", "0 0 0", "1 0 0", "0 1 0"))], triangle);
  },
};
