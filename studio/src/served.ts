// Initial contents of a page that gsim-studio serves: the requested files, or else a program of the folder.

import { samples, sampleSetup } from "./bar/gallery";
import { dialectOfName, namesOfKind } from "./core/file_kinds";
import type { Folder } from "./core/folder";
import type { Session } from "./core/session";
import { emptySetup } from "./core/setup";
import type { ServedFolder } from "./embedded";
import { texts } from "./texts";

/** Returns the first program by name; upper folders come before those below. */
function firstProgram({ documents }: Session, folder: Folder): string {
  const depth = (name: string) => name.split("/").length;
  const programs = namesOfKind("program", documents).filter((name) => folder.has(name));
  return programs.sort((a, b) => depth(a) - depth(b) || a.localeCompare(b))[0] ?? "";
}

export async function openServedFolder(session: Session, folder: Folder, { name, setup }: ServedFolder): Promise<void> {
  document.title = texts.folder.title(name);
  session.setVersionSource(() => folder.versions());
  try {
    await folder.open();
  } catch (error) {
    session.store.set("notice", texts.folder.unread(name, String(error)));
  }
  const program = setup.program || firstProgram(session, folder);
  const given = Object.fromEntries(Object.entries({ ...setup, program }).filter(([, value]) => value !== ""));
  await folder.readAll(Object.values(given));
  void folder.follow();
  session.change(program ? { ...emptySetup(), dialect: dialectOfName(program), ...given } : sampleSetup(samples[0]));
  await session.run();
}
