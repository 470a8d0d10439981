#!/usr/bin/env python3
"""Compares the programs of a native build with those of WebAssembly under node, byte for byte: translations and reports of the golden programs
and of the samples, on all sample machines and with all sample controllers. The numbers in paths of drawings, which are written to the last
bit, are compared to 12 digits, because the two C libraries round sin() or atan2() differently. Prints each difference, and what is left
out and why; closes with "N passed, N failed". These are failures, too: a file of the samples that no run reads, a name of a missing
file, an expected output of a program that is not compared, and a run that fails natively (two failures are equal whatever the programs do).
Usage: wasm-compare.py [NATIVE [WASM]] (build/bin/gsim, build-wasm/bin/gsim.js)"""

import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent.parent
GOLDEN = HERE / "tests/golden"
SAMPLES = HERE / "samples"
SECONDS = 120
OUTPUT = "a file of this run"  # with emscripten node has no separate stream for standard output
REFUSED = 2  # the status after wrong options and missing files

NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
TOLERANCE = 1e-12  # relative; near 0 absolute (mm, degrees)

# Samples that no run of gsim reads.
LEFT_OUT_SAMPLES = {
    "batch/wheel-placement.toml": "is a plan of gsim-optimise",
    "batch/wheel-study.toml": "is a plan of gsim-batch",
    "engine/plot_wheel.py": "loads libgsim into Python",
    "engine/run.c": "is compiled and linked with libgsim",
    "parts/bracket.step": "starts gsim-solid",
    "parts/frustum.step": "starts gsim-solid",
    "parts/wheel.step": "starts gsim-solid",
    **{f"engine/{file.name}": "is compiled and linked with libgsim" for file in (SAMPLES / "engine").glob("[0-9]*.cpp")},
    **{f"engine/{file.name}": "is the output of an example" for file in (SAMPLES / "engine").glob("*.out")},
}

# Options that need a process or a loaded module, which the WebAssembly build does not have.
LEFT_OUT = {
    "gsim run --rcs MODULE": "loads a shared library (tests/controller, which no golden program or sample names)",
    "gsim run --plot FILE": "starts gnuplot; what it is given to draw are the moves of the reports that are compared",
    "gsim path PART.step, PART.iges": "starts gsim-solid",
}


@dataclass(frozen=True)
class Run:
    """The arguments of a program, in a folder. Its inputs are each Input among the arguments and further_inputs."""

    folder: Path
    arguments: tuple
    further_inputs: tuple = ()
    to_last_bits: bool = True

    def inputs(self):
        return {(self.folder / word).resolve() for word in self.arguments + self.further_inputs if isinstance(word, Input)}

    def __str__(self):
        return f"{self.folder.relative_to(HERE)}: gsim {' '.join(self.arguments)}"


class Input(str):
    """The name of a file that a run reads, relative to the run's folder."""


def files(folder, *patterns):
    return [Input(file.relative_to(folder)) for file in sorted(file for pattern in patterns for file in folder.glob(pattern))]


def programs(folder):
    """Returns each part program of a folder, with its language."""
    dialects = {"nc": "ab9", "ngc": "rs274ngc", "gcode": "klipper"}
    for name in files(folder, "*.nc", "*.ngc", "*.gcode"):
        yield name, dialects[name.rsplit(".", 1)[1]]


def golden_runs():
    for program, dialect in programs(GOLDEN):
        yield Run(GOLDEN, ("translate", program, "--dialect", dialect, "--output", OUTPUT))
        machine = ("--machine", str(SAMPLES / "machines/klipper-fast-ext.toml")) if dialect == "klipper" else ()
        yield Run(GOLDEN, ("run", program, "--dialect", dialect, "--json", *machine, "--machine-data", Input("conditions/data.txt"), "--setup",
                           Input(f"conditions/{dialect}.lua"), "--max-blocks", "2000", "--max-steps", "200000"))


def bodies_left_out(program, machine):
    """Returns the option to leave bodies out in one run: the wheel's letters are not those of this machine, so its head moves into its
    tank. The time of a contact is known only to 1e-6 mm of the path, so the two reports could differ in the last digit."""
    return ("--no-collisions",) if (program, machine) == ("wheel.nc", "machines/af5-table-letters.toml") else ()


def is_variant(machine):
    """Returns True for machines that differ from another one only in values of their controller, as recorded."""
    return re.match(r"machines/(grblhal|klipper|linuxcnc-2\.10)-[a-z0-9]+-.", str(machine)) is not None


def program_runs():
    for program, dialect in programs(SAMPLES):
        yield Run(SAMPLES, ("translate", program, "--dialect", dialect, "--output", OUTPUT))
        for machine in files(SAMPLES, "machines/*.toml"):
            # One program is enough for a variant: the one with its special words.
            if is_variant(machine) and dialect != "rs274ngc":
                continue
            yield Run(SAMPLES, ("run", program, "--dialect", dialect, "--json", "--machine", machine, *bodies_left_out(program, machine)))
    yield Run(SAMPLES / "cell", ("run", Input("cell.lua"), "--robots", Input("robots.toml"), "--json"))
    yield Run(SAMPLES / "cell", ("run", Input("slides.lua"), "--robots", Input("slides.toml"), "--json"), (Input("slide.toml"),))
    yield Run(SAMPLES, ("run", Input("mill/dome.nc"), "--machine", Input("machines/mill-head-table.toml"), "--json"))
    yield Run(SAMPLES, ("run", Input("mill/turntable.nc"), "--machine", Input("machines/mill-table-table.toml"), "--json"))
    yield Run(SAMPLES, ("run", Input("cell/seam.lua"), "--machine", Input("machines/arm6-cell.toml"), "--json"))
    yield Run(SAMPLES, ("run", Input("wheel.nc"), "--cell", Input("cell/wheel.toml"), "--json"), (Input("cell/wheel.obj"),))
    for program in ("left.nc", "clamp.nc"):
        yield Run(SAMPLES / "cell", ("run", Input(program), "--cell", Input("table.toml"), "--json"), (Input("mould.stl"),))


def controller_runs(scratch):
    """Returns runs of one machine with each controller, because a machine file names its controller."""
    machine = (SAMPLES / "machines/router3.toml").read_text(encoding="utf-8")
    for controller in files(SAMPLES, "controllers/*.toml"):
        own = scratch / Path(controller).name
        own.write_text(f'{machine}\n[controller]\nmodel = "{SAMPLES / controller}"\n', encoding="utf-8")
        yield Run(SAMPLES, ("run", Input("wheel.nc"), "--json", "--machine", str(own)), (controller,))


def path_runs():
    for path in files(SAMPLES, "*.path.json", "*.path.lua"):
        yield Run(SAMPLES, ("write", path, "--output", OUTPUT))
    for post in files(SAMPLES, "posts/*.toml"):
        yield Run(SAMPLES, ("write", Input("wheel.path.json"), "--dialect", post, "--machine", Input("machines/unlimited.toml"), "--continue-on-unknown",
                            "--output", OUTPUT))
    for drawing in files(SAMPLES, "*.dxf", "*.svg"):
        yield Run(SAMPLES, ("path", drawing, "--speed", "400", "--kerf", "1", "--output", OUTPUT), to_last_bits=False)
        yield Run(SAMPLES, ("path", drawing, "--materials", Input("materials.toml"), "--material", "aluminum", "--thickness", "12", "--output",
                            OUTPUT), to_last_bits=False)


def data_runs():
    for command in ("list", "check", "convert"):
        yield Run(SAMPLES, ("data", Input("jet.txt"), command, "--json"))


def missing_inputs(runs):
    """Returns messages about samples that no run reads, missing inputs, and expected outputs of no program."""
    read = set().union(*(run.inputs() for run in runs), (SAMPLES / name for name in LEFT_OUT_SAMPLES))
    for file in sorted(set(file for file in SAMPLES.rglob("*") if file.is_file()) - read):
        yield f"{file.relative_to(HERE)}: no run reads it, and LEFT_OUT_SAMPLES does not say why"
    for file in sorted(file for file in read if not file.is_file()):
        yield f"{file.relative_to(HERE)}: it is not there"
    stems = {file.stem for file in read if file.suffix in (".nc", ".ngc", ".gcode")}
    for file in files(GOLDEN, "*.lua", "*.json", "*.err"):
        if Path(file).stem not in stems:
            yield f"tests/golden/{file}: its program is not compared"


def answer(command, folder):
    """Returns the status, standard output, standard error, and the output file."""
    with tempfile.TemporaryDirectory() as own:
        output = Path(own) / "output"
        command = [str(output) if word == OUTPUT else word for word in command]
        try:
            run = subprocess.run(command, cwd=folder, capture_output=True, timeout=SECONDS, check=False)
        except subprocess.TimeoutExpired:
            return f"no end after {SECONDS} s", b"", b"", b""
        written = output.read_bytes() if output.exists() else b""
    return run.returncode, run.stdout, run.stderr, written


def first_difference(a, b):
    if not isinstance(a, bytes):
        return f"{a} and {b}"
    for one, other in zip(a.splitlines(), b.splitlines()):
        if one != other:
            return f"{one[:160]!r} and {other[:160]!r}"
    return f"{len(a)} and {len(b)} bytes"


def nearly_same(a, b):
    """Returns True if the texts are equal except for numbers that differ by rounding."""
    if NUMBER.sub(b"#", a) != NUMBER.sub(b"#", b):
        return False
    pairs = zip(NUMBER.findall(a), NUMBER.findall(b))
    return all(math.isclose(float(one), float(other), rel_tol=TOLERANCE, abs_tol=TOLERANCE) for one, other in pairs)


def same(a, b, to_last_bits):
    return a == b or (not to_last_bits and isinstance(a, bytes) and nearly_same(a, b))


def faults(native, wasm, to_last_bits):
    """Returns the differences between the two results of one run; none if they are equal."""
    if not isinstance(native[0], int) or native[0] < 0 or native[0] >= REFUSED:
        last = native[2].decode(errors="replace").strip().splitlines()[-1:]
        return [f"natively it is no run: {native[0]} {' '.join(last)}"]
    return [f"{what}: {first_difference(a, b)}" for what, a, b in zip(("status", "output", "messages", "file"), native, wasm)
            if not same(a, b, to_last_bits)]


def compare(runs, native, wasm):
    """Returns how many runs differ, and prints each of them."""

    def both(run):
        answers = (answer([*program, *run.arguments], run.folder) for program in ([native], ["node", wasm]))
        return run, faults(*answers, run.to_last_bits)

    failed = 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for run, found in pool.map(both, runs):
            if found:
                failed += 1
                print(f"FAILED {run}", *found, sep="\n  ")
    return failed


def main():
    native = Path(sys.argv[1] if len(sys.argv) > 1 else HERE / "build/bin/gsim").resolve()
    wasm = Path(sys.argv[2] if len(sys.argv) > 2 else HERE / "build-wasm/bin/gsim.js").resolve()
    lacking = [str(file) for file in (native, wasm) if not file.is_file()] + ([] if shutil.which("node") else ["node"])
    if lacking:
        print(f"wasm-compare: there is no {', no '.join(lacking)}", "0 passed, 1 failed", sep="\n")
        return 1
    with tempfile.TemporaryDirectory() as scratch:
        runs = [*golden_runs(), *program_runs(), *controller_runs(Path(scratch)), *path_runs(), *data_runs()]
        missing = list(missing_inputs(runs))
        different = compare(runs, str(native), str(wasm))
    for sentence in missing:
        print(f"FAILED {sentence}")
    for run in runs:
        if not run.to_last_bits:
            print(f"figures to 12 digits: {run}")
    for what, why in [*((f"samples/{name}", why) for name, why in LEFT_OUT_SAMPLES.items()), *LEFT_OUT.items()]:
        print(f"left out: {what}: {why}")
    failed = different + len(missing)
    print(f"{len(runs) - different} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
