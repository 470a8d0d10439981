// Time limit: a case that waits without end would block all others.

/** Fails if `wanted` does not come in time, with the message that `tell` returns then, at once or later. */
export function within(time_ms, expectedValue, tell) {
  let patience;
  const late = new Promise((_, fail) => {
    patience = setTimeout(async () => fail(new Error(await tell())), time_ms);
  });
  return Promise.race([expectedValue, late]).finally(() => clearTimeout(patience));
}
