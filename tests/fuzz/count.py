#!/usr/bin/env python3
"""Prints the results of a run of libFuzzer from its log; with RECORD it adds them to the table in RESULTS.md.
Usage: count.py LOG TARGET FUZZ-FOLDER RECORD"""

import fcntl
import os
import re
import sys

HEAD = "| target | CPU hours | executions | edges | features | findings |"


def figures_of(log):
    """Returns CPU seconds, executions, edges and features of a run."""
    def last(pattern):
        found = re.findall(pattern, log)
        return found[-1] if found else 0

    times = re.findall(r"^cpu_s ([\d.]+) ([\d.]+)$", log, re.M)
    cpu_s = sum(float(part) for part in times[-1]) if times else 0.0
    executions = last(r"stat::number_of_executed_units: (\d+)") or last(r"^#(\d+)\s")
    return cpu_s, int(executions), int(last(r" cov: (\d+)")), int(last(r" ft: (\d+)"))


def findings_of(folder, target):
    path = os.path.join(folder, "findings", target)
    return sum(not name.startswith(".") for name in os.listdir(path)) if os.path.isdir(path) else 0


def rows_of(text):
    """Returns the rows of the table as lists of words, by target."""
    rows = {}
    for line in text.splitlines():
        words = [word.strip() for word in line.strip("|").split("|")]
        if len(words) == HEAD.count("|") - 1 and re.fullmatch(r"[\d.]+", words[1]):
            rows[words[0]] = words
    return rows


def record(path, target, run):
    """Adds a run to the table. Hours and executions are sums; edges and features are the maximum of all runs."""
    cpu_s, executions, edges, features, findings = run
    with open(path, "r+", encoding="utf-8") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        text = file.read()
        rows = rows_of(text)
        before = rows.get(target, [target, "0", "0", "0", "0", "0"])
        rows[target] = [target, f"{float(before[1]) + cpu_s / 3600:.3f}", str(int(before[2]) + executions),
                        str(max(int(before[3]), edges)), str(max(int(before[4]), features)), str(findings)]
        top = text[:text.index(HEAD)]
        table = [HEAD, "| --- |" + " ---: |" * (HEAD.count("|") - 2)]
        table += ["| " + " | ".join(row) + " |" for row in sorted(rows.values()) if row[0] != "all"]
        file.seek(0)
        file.truncate()
        file.write(top + "\n".join(table) + "\n")


def main():
    log_name, target, folder, wanted = sys.argv[1:5]
    with open(log_name, encoding="utf-8", errors="replace") as file:
        run = figures_of(file.read())
    findings = findings_of(folder, target)
    cpu_s, executions, edges, features = run
    print(f"{target}: {cpu_s:.0f} s of CPU, {executions} executions, {edges} edges, {features} features, "
          f"{findings} findings kept")
    if wanted:
        record(os.path.join(folder, "RESULTS.md"), target, (*run, findings))
    return 0 if executions > 0 else 1


sys.exit(main())
