// Memory of processes, as reported by Linux.

import { readFileSync, readdirSync } from "node:fs";

/**
 * Returns for all processes: parent, name, and bytes of memory that they share with no file (current, and the
 * peak including shared memory).
 */
function processes() {
  const all = new Map();
  for (const pid of readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
    try {
      const status = readFileSync(`/proc/${pid}/status`, "utf8");
      const bytes = (name) => 1024 * Number(status.match(new RegExp(`${name}:\\s+(\\d+)`))?.[1] ?? 0);
      const command = readFileSync(`/proc/${pid}/cmdline`, "utf8").replaceAll("\0", " ");
      all.set(pid, { pid, parent: status.match(/PPid:\s+(\d+)/)[1], command, own: bytes("RssAnon"), shared: bytes("RssShmem"), peak: bytes("VmHWM") });
    } catch {
      // It has ended meanwhile.
    }
  }
  return all;
}

/** Returns processes below this one with these words in their command line, the largest first. */
export function ours(words) {
  const all = processes();
  const isOurs = ({ parent }) => {
    for (let at = parent; at && at !== "0"; at = all.get(at)?.parent) if (at === String(process.pid)) return true;
    return false;
  };
  return [...all.values()].filter((each) => each.command.includes(words) && isOurs(each)).sort((a, b) => b.own - a.own);
}

/** What the largest process of the browser holds, but for what it shares with others, in bytes. */
export const memoryOfBrowser = () => ours("chromium")[0]?.own ?? 0;
