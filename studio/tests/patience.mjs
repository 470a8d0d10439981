// What does not come in time fails: a case that waits without end would hold up all others.

/** Fails where `wanted` does not come in time, with the words that `tell` returns then, at once or later. */
export function within(time_ms, wanted, tell) {
  let patience;
  const late = new Promise((_, fail) => {
    patience = setTimeout(async () => fail(new Error(await tell())), time_ms);
  });
  return Promise.race([wanted, late]).finally(() => clearTimeout(patience));
}
