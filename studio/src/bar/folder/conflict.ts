// Two versions of a file, one typed here and one written by another program: the user decides between them.

import type { Documents } from "../../core/documents";
import { element } from "../../core/dom";
import type { Folder } from "../../core/folder";
import { texts } from "../../texts";
import { showDialog } from "../dialog";

export type ConflictChoice = "mine" | "theirs" | "other" | "later";

const words = texts.folder;
const MAX_LINE_LENGTH = 120;

const linesOf = (text: string): string[] => text.split(/\r?\n/);

/** Returns the first difference between two texts. */
function difference(mine: string, theirs: string): Node[] {
  const [here, theirLines] = [linesOf(mine), linesOf(theirs)];
  const most = Math.max(here.length, theirLines.length);
  let i = 0;
  while (i < most && here[i] === theirLines[i]) ++i;
  if (i === most) return [element("p", {}, words.noDifference)];
  const row = (label: string, line: string | undefined) =>
    element("div", {}, element("dt", {}, label), element("dd", {}, line === undefined ? words.noLine : line.slice(0, MAX_LINE_LENGTH)));
  return [
    element("p", {}, words.firstDifference(i + 1)),
    element("dl", { class: "versions" }, row(words.here, here[i]), row(words.onDisk, theirLines[i])),
  ];
}

export async function resolveConflict(name: string, folder: Folder, documents: Documents): Promise<ConflictChoice> {
  const theirs = await folder.readDiskVersion(name).catch(() => null);
  const mine = documents.get(name);
  const displayed = typeof mine === "string" && typeof theirs?.content === "string" ? difference(mine, theirs.content) : [];
  return new Promise((resolve) => {
    let decision: ConflictChoice = "later";
    const button = (what: ConflictChoice, text: string, title: string) =>
      element(
        "button",
        {
          title,
          onclick: () => {
            decision = what;
            dialog.close();
          },
        },
        text,
      );
    const buttons = element(
      "div",
      { class: "answers" },
      button("mine", words.keepMine, words.keepMineTitle),
      button("theirs", words.loadDiskVersion, words.loadDiskVersionTitle),
      button("other", words.saveOther, words.saveOther),
      button("later", words.later, words.later),
    );
    const dialog = showDialog(words.conflictTitle(name), [element("p", {}, words.conflictText), ...displayed, buttons], () =>
      resolve(decision),
    );
  });
}
