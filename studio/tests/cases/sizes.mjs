// Sizes of pages in transfer: the cause of growth must be visible at once.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { gzipSync } from "node:zlib";

const MOST_BYTES = { "view.html": 400_000 };

export default Object.fromEntries(
  Object.entries(MOST_BYTES).map(([name, most]) => [
    `${name} has at most ${most} bytes with gzip`,
    (places) => {
      const bytes = gzipSync(readFileSync(join(dirname(places.studio), name)), { level: 9 }).length;
      assert.ok(bytes <= most, `${name} has ${bytes} bytes with gzip, ${bytes - most} more than it may have`);
    },
  ]),
);
