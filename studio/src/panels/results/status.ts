// Result of a run as a message, with the source locations of its errors.

import { element } from "../../core/dom";
import { goTo } from "../../core/navigation";
import type { Store } from "../../core/store";
import { countText, timeText } from "../../core/units";
import type { Report } from "../../run/report";
import type { Run, EngineDiagnostic } from "../../run/run";
import { texts } from "../../texts";
import { runContext } from "./context";
import { itemList, type Item } from "./mark_list";

const words = texts.panels;

const diagnosticItem = (diagnostic: EngineDiagnostic, store: Store): Item => ({
  kind: diagnostic.severity,
  text: diagnostic.hint ? `${diagnostic.text}. ${diagnostic.hint}` : diagnostic.text,
  title: diagnostic.file,
  place: diagnostic.line > 0 ? texts.run.line(diagnostic.line) : words.severities[diagnostic.severity],
  choose: () => goTo(store, { file: diagnostic.file || null, line: diagnostic.line || null }, null),
});

/** "No contact" means little if nothing was checked. */
function contactText({ cell }: Report): string {
  const pairs = (cell?.checked?.pairs ?? 0) + (cell?.checked?.with_robots ?? 0);
  return pairs > 0 ? words.touchesNothing(pairs) : words.notLooked;
}

/** Returns the message and its severity. */
function statusText(run: Run, report: Report | null): [text: string, severity: string] {
  if (run.error) return [words.refused(run.error.message), "error"];
  const status = run.report?.status;
  if (!report || !status) return [words.nothing, ""];
  const alarm = report.alarm ?? run.report?.alarm;
  if (status === "alarm") return [words.has_alarm(alarm?.message ?? ""), "error"];
  if (status === "stopped") {
    const isPageLimit = alarm?.code === "run-limit" && /--max-blocks/.test(alarm.message) && run.storageKey === "";
    return [words.stopped(alarm?.message ?? "") + (isPageLimit ? ` ${words.longerRuns}` : ""), "error"];
  }
  const violations = report.violation_count ?? 0;
  const contacts = report.collisions?.length ?? 0;
  const said = [violations > 0 ? words.violated(violations) : words.completed];
  said.push(contacts > 0 ? words.collided(contacts) : contactText(report));
  if (report.valid_until_s != null) said.push(words.validUntil(timeText(report.valid_until_s, 1)));
  return [said.join(" "), violations + contacts > 0 ? "error" : "good"];
}

export function createStatus(store: Store): HTMLElement {
  const bar = element("progress", { "aria-label": words.running });
  const done = element("span", { class: "done" });
  const running = element("div", { class: "running", role: "status" }, words.running, bar, done);
  const sentence = element("p", { class: "sentence", role: "status" });
  const of = element("p", { class: "of" });
  const places = element("div", { class: "places" });

  store.watch(["running"], () => {
    const state = store.get("running");
    running.hidden = !state;
    if (!state) return;
    if (state.total > 0) {
      bar.max = state.total;
      bar.value = state.done;
    } else {
      bar.removeAttribute("value");
    }
    done.textContent = words.runningBlocks(countText(state.done), state.total > 0 ? countText(state.total) : "");
  });
  store.watch(["run", "robot"], () => {
    const context = runContext(store);
    const [text, severity] = context ? statusText(context.run, context.report) : [words.nothing, ""];
    sentence.textContent = text;
    const report = context?.run.report;
    of.textContent = report?.program ? words.ofProgram(report.program, context?.robot?.scene.machine ?? "") : "";
    sentence.className = `sentence ${severity}`;
    const diagnostics = context?.run.diagnostics ?? [];
    const items = diagnostics.map((one) => diagnosticItem(one, store));
    places.replaceChildren(...(items.length > 0 ? [itemList(words.messages, items, 20)] : []));
  });
  return element("div", { class: "status" }, running, of, sentence, places);
}
