#!/usr/bin/env python3
"""Tests gsim-batch and gsim-optimise on a real Slurm of this machine: the rows are the same as without it, even if processes are killed.
Usage: slurm_test.py GSIM-BATCH [CLASS]: all tests, or Batches or Losses, each with its own cluster. In the environment: SLURM_NEEDED=1
(a missing Slurm is a failure; without it the test is skipped: status 77)."""

import json
import os
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
CLUSTER = HERE / "cluster.sh"
SKIPPED = 77
GSIM_BATCH = str(Path(sys.argv[1]).resolve())
GSIM_OPTIMISE = str(Path(GSIM_BATCH).with_name("gsim-optimise"))

MACHINE = """[machine]
name = "slide"
[program]
dialect = "rs274ngc"
[[axis]]
letter = "X"
kind = "linear"
max_mm = 1000.0
max_speed_mm_s = 100.0
max_acceleration_mm_s2 = 1000.0
direction = "x"
"""
# One program exceeds a limit, one has an error: they have rows like all others.
PROGRAMS = {"line.ngc": "G21 F600\nG1 X30\nM2\n", "far.ngc": "G21 F600\nG1 X3000\nM2\n", "wrong.ngc": "G1 X[\n",
            "loop.ngc": "G21 F600\no1 repeat [200]\nG1 X10\nG1 X0\no1 endrepeat\nM2\n"}
# Columns that differ between runs of a program, or depend on the process that ran it.
OWN = {"ran_at", "cpu_s", "id", "reused"}


def is_there():
    path = os.environ["PATH"] + ":/usr/sbin:/sbin"
    return all(shutil.which(name, path=path) for name in ("slurmctld", "slurmd", "munged", "sbatch", "squeue", "scontrol"))


def rows(file):
    """Returns all runs of the latest batch, by their jobs."""
    with sqlite3.connect(file, timeout=20) as results:
        results.row_factory = sqlite3.Row
        return {row["job"]: {key: row[key] for key in row.keys() if key not in OWN}
                for row in results.execute("SELECT * FROM latest")}


def number(file, query):
    with sqlite3.connect(file, timeout=20) as results:
        return results.execute(query).fetchone()[0]


class OnSlurm(unittest.TestCase):
    """A cluster with two nodes, and the results of the batch without it."""

    @classmethod
    def setUpClass(cls):
        # The path of a socket must be short, so the folder is.
        cls.root = Path(tempfile.mkdtemp(prefix="gsim-slurm-", dir="/tmp"))
        cls.cluster("start", "2")
        cls.work = cls.root / "work"
        cls.work.mkdir()
        for name, text in PROGRAMS.items():
            (cls.work / name).write_text(text)
        (cls.work / "m.toml").write_text(MACHINE)
        cls.plan("plan.toml", 400)
        cls.batch("plan.toml", "--results", "local.sqlite", "-q")
        cls.wanted = rows(cls.work / "local.sqlite")

    def setUp(self):
        self.put_back = {}

    @classmethod
    def tearDownClass(cls):
        cls.cluster("stop")
        shutil.rmtree(cls.root, ignore_errors=True)

    @classmethod
    def plan(cls, name, steps):
        (cls.work / name).write_text('programs = ["*.ngc"]\nmachines = ["m.toml"]\n[[setting]]\nkey = "machine.axis.X.max_speed_mm_s"\n'
                                     f"from = 20\nto = 100\nsteps = {steps}\n")

    @classmethod
    def cluster(cls, action, *words):
        # Daemons keep inherited files open.
        with (cls.root / "cluster.log").open("a") as log:
            subprocess.run([CLUSTER, action, cls.root / "slurm", *words], check=True, stdin=subprocess.DEVNULL, stdout=log, stderr=log)

    @classmethod
    def environment(cls):
        return {**os.environ, "SLURM_CONF": str(cls.root / "slurm" / "slurm.conf")}

    @classmethod
    def batch(cls, *words):
        done = subprocess.run([GSIM_BATCH, *words], cwd=cls.work, env=cls.environment(), capture_output=True, text=True, timeout=300)
        return done.returncode, done.stdout + done.stderr

    @classmethod
    def optimise(cls, *words):
        done = subprocess.run([GSIM_OPTIMISE, *words], cwd=cls.work, env=cls.environment(), capture_output=True, text=True, timeout=300)
        return done.returncode, done.stdout + done.stderr

    def slurm(self, *words):
        return subprocess.run(words, env=self.environment(), capture_output=True, text=True, check=True, timeout=60).stdout

    def until(self, what, patience_s=90):
        for _ in range(patience_s * 10):
            if what():
                return
            time.sleep(0.1)
        self.fail(f"not within {patience_s} s: {self.batch('--status', '--results', 'r.sqlite')}\n{self.slurm('squeue')}")

    def over(self, results):
        """Waits until the batch is no longer in the queue."""
        self.until(lambda: self.hurry() and " 0 running, 0 waiting" in self.batch("--status", "--results", results)[1])

    def hurry(self):
        """Starts requeued tasks, which would wait for two minutes, and releases held tasks, which a lost node could not begin.
        If a task begins in the second in which it was requeued, a node rejects its credential as revoked, and the task fails."""
        waiting = {}
        for line in self.slurm("squeue", "--noheader", "--array", "--states=PENDING", "--format=%i|%r").splitlines():
            job, reason = line.strip().split("|")
            command = ["release", job] if "held" in reason else None
            if reason == "BeginTime":
                waiting[job] = self.put_back.get(job, time.monotonic())
                command = ["update", "JobId=" + job, "StartTime=now"] if time.monotonic() - waiting[job] > 1.5 else None
            if command:
                subprocess.run(["scontrol", *command], env=self.environment(), capture_output=True, check=False, timeout=60)
        self.put_back = waiting
        return True

    def logs(self, results):
        """Returns the output of the tasks of a batch."""
        return "\n".join(f"{file.name}:\n{file.read_text()}" for file in sorted((self.work / (results + ".slurm")).glob("*.log")))

    def check(self, results):
        found = rows(self.work / results)
        self.assertEqual(sorted(found), sorted(self.wanted), self.logs(results))
        for job, row in self.wanted.items():
            self.assertEqual(found[job], row)
        self.assertEqual(number(self.work / results, "SELECT count(*) - count(DISTINCT key) FROM run"), 0, "a run is there twice")
        self.assertEqual(number(self.work / results, "SELECT complete FROM batch ORDER BY id DESC LIMIT 1"), 1)

    def submit(self, results, shard_runs=100):
        status, said = self.batch("plan.toml", "--slurm", "--results", results, "--shard-runs", str(shard_runs))
        self.assertEqual(status, 0, said)
        return said

    def task_processes(self, results):
        """Returns processes of tasks, by their shards."""
        found = {}
        for entry in Path("/proc").iterdir():
            try:
                words = (entry / "cmdline").read_bytes().split(b"\0")
            except (OSError, ValueError):
                continue
            if len(words) > 3 and words[1] == b"--shard" and words[2].endswith(results.encode() + b".slurm"):
                found[int(words[3])] = int(entry.name)
        return found


class Batches(OnSlurm):
    def test_rows_are_those_of_a_local_run(self):
        status, said = self.batch("plan.toml", "--slurm", "--results", "a.sqlite", "--shard-runs", "250", "--wait", "-q", "--csv", "a.csv")
        self.assertEqual(status, 1, said)  # two of the programs have errors
        self.assertIn("; merged", said)
        self.assertEqual(len((self.work / "a.csv").read_text().splitlines()), len(self.wanted) + 1)
        self.check("a.sqlite")
        status, said = self.batch("plan.toml", "--slurm", "--results", "a.sqlite")
        self.assertIn("no runs are pending", said)
        self.assertIn("0 run in", self.batch("plan.toml", "--results", "a.sqlite")[1])

    def test_a_batch_that_is_cancelled_keeps_what_it_has(self):
        self.submit("e.sqlite")
        self.until(lambda: self.task_processes("e.sqlite"))
        status, said = self.batch("plan.toml", "--slurm", "--results", "e.sqlite")
        self.assertEqual(status, 2)
        self.assertIn("is running", said)
        status, said = self.batch("plan.toml", "--results", "e.sqlite")
        self.assertEqual(status, 2)
        self.assertIn("on a cluster", said)
        status, said = self.batch("--cancel", "--results", "e.sqlite")
        self.assertIn(" 0 running, 0 waiting", said)
        had = len(rows(self.work / "e.sqlite"))
        self.assertGreater(had, 0)
        self.submit("e.sqlite")
        self.over("e.sqlite")
        self.check("e.sqlite")

    def test_tasks_that_are_put_back_go_on(self):
        self.submit("c.sqlite", 400)
        self.until(lambda: self.task_processes("c.sqlite"))
        job = self.slurm("squeue", "--noheader", "--array", "--states=RUNNING", "--name=gsim-batch", "--format=%i").split()[0]
        self.slurm("scontrol", "requeue", job)
        self.over("c.sqlite")
        self.check("c.sqlite")

    def test_what_the_cluster_does_not_allow_is_refused(self):
        for words, why in ((("--partition", "none"), "has no partition 'none'"), (("--memory-mb", "9000"), "has 1000 MB")):
            status, said = self.batch("plan.toml", "--slurm", "--results", "f.sqlite", *words)
            self.assertEqual(status, 2, said)
            self.assertIn(why, said)


class Losses(OnSlurm):
    def test_a_killed_task_loses_its_own_runs_and_they_alone_are_submitted_again(self):
        self.submit("b.sqlite")
        self.until(lambda: self.task_processes("b.sqlite"))
        shard, process = next(iter(self.task_processes("b.sqlite").items()))
        os.kill(process, signal.SIGKILL)
        self.over("b.sqlite")
        status, said = self.batch("--status", "--results", "b.sqlite")
        self.assertEqual(status, 1, said)
        self.assertIn("1 lost", said)
        missing = len(self.wanted) - len(rows(self.work / "b.sqlite"))
        self.assertGreater(missing, 0, shard)
        self.assertLessEqual(missing, 100)
        said = self.submit("b.sqlite")
        self.assertIn(f"{len(self.wanted) - missing} reused", said)
        self.over("b.sqlite")
        self.check("b.sqlite")

    def test_daemons_may_be_killed(self):
        self.submit("d.sqlite")
        self.until(lambda: self.task_processes("d.sqlite"))
        self.cluster("kill-controller")
        time.sleep(1)
        self.cluster("start-controller")
        self.cluster("kill-node", "node0")
        time.sleep(1)
        self.cluster("start-node", "node0")
        self.over("d.sqlite")
        if len(rows(self.work / "d.sqlite")) < len(self.wanted):
            self.submit("d.sqlite")
            self.over("d.sqlite")
        self.check("d.sqlite")

    def test_a_search_tries_what_it_tries_by_itself_whatever_is_killed(self):
        (self.work / "search.toml").write_text(
            'programs = ["loop.ngc", "line.ngc"]\nmachines = ["m.toml"]\n[objective]\ncycle_time_s = 1\n[search]\n'
            'variants = 60\nfirst = 20\npopulation = 20\n[[setting]]\nkey = "option.feed_override_percent"\nfrom = 50\nto = 150\n')
        status, said = self.optimise("search.toml", "--results", "alone.sqlite", "-q")
        self.assertEqual(status, 0, said)
        words = [GSIM_OPTIMISE, "search.toml", "--slurm", "--results", "f.sqlite", "--shard-runs", "10", "-q", "--json", "f.json"]
        with subprocess.Popen(words, cwd=self.work, env=self.environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as search:
            self.until(lambda: self.task_processes("f.sqlite"))
            os.kill(next(iter(self.task_processes("f.sqlite").values())), signal.SIGKILL)
            said, _ = search.communicate(timeout=240)
        self.assertEqual(search.returncode, 0, said)
        trials = "SELECT group_concat(number || ' ' || generation || ' ' || value || ' ' || violation, '; ') FROM search_run"
        self.assertEqual(number(self.work / "f.sqlite", trials), number(self.work / "alone.sqlite", trials))
        self.assertEqual(number(self.work / "f.sqlite", "SELECT count(*) - count(DISTINCT key) FROM run"), 0, "a run is there twice")
        self.assertLess(json.loads((self.work / "f.json").read_text())["best"]["value"], 560)


if __name__ == "__main__":
    if not is_there():
        print("skipped: there is no Slurm here; scripts/setup.sh slurm installs it")
        sys.exit(1 if os.environ.get("SLURM_NEEDED") else SKIPPED)
    sys.argv = sys.argv[:1] + sys.argv[2:]
    unittest.main(verbosity=2)
