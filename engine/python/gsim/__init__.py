"""gsim from Python: what a part program does on a machine, with its moves and its trajectory as numpy arrays.

    import gsim
    run = gsim.run("part.nc", machine="mine.toml", step_s=0.01)
    run.report["cycle_time_s"], run.moves["length_mm"].sum(), run.samples["axes"][:, 0].max()

Lengths are mm, angles deg, times s. It calls libgsim by its C interface (gsim.h)."""

import json
import os
from pathlib import Path

import cffi
import numpy

__all__ = ["Error", "MOVE", "ProgramError", "Run", "SAMPLE", "run", "translate", "version"]

_API = 1
_AXES = 16

#: The fields of Run.moves: a row for each move, as gsim_move. "jet_on" is the name of "process_on" in version 0.1, until 0.3.
MOVE = numpy.dtype([
    ("n", "u8"), ("start_s", "f8"), ("end_s", "f8"), ("length_mm", "f8"), ("feed_per_min", "f8"), ("deviation_mm", "f8"),
    ("end", "f8", _AXES), ("center_mm", "f8", 3), ("axis", "f8", 3), ("radius_mm", "f8"), ("sweep_rad", "f8"),
    ("kind", "i4"), (("jet_on", "process_on"), "i4"), ("line", "u4"), ("file", "u4")])
#: What Run.samples has: an instant each.
SAMPLE = numpy.dtype([("t_s", "f8"), ("speed_mm_s", "f8"), ("axes", "f8", _AXES), ("line", "u4"), ("reserved", "u4")])

_NUMBERS = frozenset((
    "machine_s", "cpu_s", "blocks", "steps", "memory_bytes", "passes", "feed_override_percent", "rapid_override_percent",
    "spindle_override_percent", "stop_at_first", "collisions", "block_delete", "optional_stop", "explain"))
_OUTCOMES = ("completed", "violations", "stopped", "alarm")
_SEVERITIES = ("error", "warning", "note")

_ffi = cffi.FFI()
_ffi.cdef((Path(__file__).parent / "gsim.cdef").read_text(encoding="utf-8"))
_lib = _ffi.dlopen(os.environ.get("GSIM_LIBRARY", "libgsim.so.0"))
if _lib.gsim_api_version() < _API:
    raise ImportError(f"libgsim speaks version {_lib.gsim_api_version()} of its interface; this module needs {_API}")


class Error(Exception):
    """A file that cannot be read, an argument that does not fit; `diagnostics` is what was told."""

    def __init__(self, message, diagnostics=()):
        super().__init__(message)
        self.diagnostics = list(diagnostics)


class ProgramError(Error):
    """The program has errors; `diagnostics` lists them."""


class Run:
    """What a run did: `report` (docs/report.md), `moves`, `samples`, `files` (of the moves' numbers), `axes` (letters),
    `outcome` and `diagnostics`."""

    def __init__(self, report, text, moves, samples, files, axes, outcome, diagnostics):
        self.report, self.text, self.moves, self.samples = report, text, moves, samples
        self.files, self.axes, self.outcome, self.diagnostics = files, axes, outcome, diagnostics


def version():
    """The version of the library."""
    return _ffi.string(_lib.gsim_version()).decode()


def _diagnostic(told):
    return {"severity": _SEVERITIES[told.severity], "code": _text(told.code), "file": _text(told.file), "line": told.line,
            "column": told.column, "text": _text(told.text), "hint": _text(told.hint)}


def _text(pointer):
    return _ffi.string(pointer).decode("utf-8", "replace") if pointer != _ffi.NULL else ""


class _Request:
    """The request of C with what it calls, which must live as long as it is used."""

    def __init__(self, program, text, files, options):
        self.failure = None
        self.diagnostics = []
        self.handle = _ffi.gc(_lib.gsim_request_create(), _lib.gsim_request_destroy)
        self.tell = _ffi.callback("gsim_on_diagnostic", lambda _, told: self.diagnostics.append(_diagnostic(told)))
        self._set_text("program", os.fspath(program))
        if text is not None:
            data = text.encode() if isinstance(text, str) else bytes(text)
            _lib.gsim_request_set_program(self.handle, data, len(data), os.fspath(program).encode())
        if files is not None:
            self.read = _ffi.callback("gsim_read_file", self._reader(files))
            _lib.gsim_request_set_files(self.handle, self.read, _ffi.NULL)
        for key, value in options.items():
            if key in _NUMBERS:
                if _lib.gsim_request_set_number(self.handle, key.encode(), float(value)) != 0:
                    raise Error(f"{key} cannot be {value!r}")
            else:
                self._set_text(key, os.fspath(value))

    def _set_text(self, key, value):
        if _lib.gsim_request_set_text(self.handle, key.encode(), value.encode()) != 0:
            raise TypeError(f"there is no option {key!r}")

    def _reader(self, files):
        give = files if callable(files) else files.get

        def read(_, name, out):
            try:
                data = give(_text(name))
            except Exception as error:  # goes on to who has called
                self.failure = error
                return 0
            if data is None:
                return 0
            data = data.encode() if isinstance(data, str) else bytes(data)
            return 1 if _lib.gsim_bytes_append(out, data, len(data)) == 0 else 0

        return read

    def refuse(self, status, sentence):
        if self.failure is not None:
            raise self.failure
        raise (ProgramError if status == 1 else Error)(sentence, self.diagnostics)


class _Rows:
    """Rows of a structure that come in chunks."""

    def __init__(self, kind, dtype):
        self.chunks, self.dtype = [], dtype
        assert _ffi.sizeof(kind) == dtype.itemsize, kind
        self.take = _ffi.callback(f"void(void*, const {kind}*, size_t)", self._take)

    def _take(self, _, rows, count):
        self.chunks.append(bytes(_ffi.buffer(rows, count * self.dtype.itemsize)))

    def array(self):
        return numpy.frombuffer(b"".join(self.chunks), dtype=self.dtype)


def run(program, text=None, *, step_s=None, files=None, progress=None, robot=0, **options):
    """Runs a part program or a script. `text`: the program itself, named `program`; `step_s`: the time between samples,
    none without it; `files`: a mapping or a function from name to bytes, in place of the system's files; `progress`: a
    function of done and total; a true value from it cancels the run. Options are the keys of gsim_request_set_text() and
    gsim_request_set_number(): machine="router3.toml", dialect="rs274ngc", collisions=False, ..."""
    request = _Request(program, text, files, options)
    handle = _ffi.gc(_lib.gsim_run_open(request.handle, request.tell, _ffi.NULL), _lib.gsim_run_destroy)
    moves, samples = _Rows("gsim_move", MOVE), _Rows("gsim_sample", SAMPLE)

    def done(status):
        if status != 0:
            request.refuse(status, _text(_lib.gsim_run_error(handle)))

    def show(_, finished, total):
        try:
            if progress(finished, total):
                _lib.gsim_run_cancel(handle)
        except BaseException as error:  # Ctrl-C among them
            request.failure = error
            _lib.gsim_run_cancel(handle)

    done(_lib.gsim_run_status(handle))
    done(_lib.gsim_run_on_moves(handle, robot, moves.take, _ffi.NULL))
    if step_s is not None:
        done(_lib.gsim_run_on_samples(handle, robot, step_s, samples.take, _ffi.NULL))
    if progress is not None:
        shown = _ffi.callback("gsim_on_progress", show)
        done(_lib.gsim_run_on_progress(handle, shown, _ffi.NULL))
    done(_lib.gsim_run_go(handle))
    if request.failure is not None:
        raise request.failure
    rows = moves.array()
    files_of = [_text(_lib.gsim_run_file(handle, i)) for i in range(int(rows["file"].max()) + 1 if len(rows) else 0)]
    letters = "".join(letter.decode() for letter in
                      (_lib.gsim_run_axis(handle, robot, i) for i in range(_AXES)) if letter != b"\0")
    return Run(json.loads(_text(_lib.gsim_run_report_json(handle))), _text(_lib.gsim_run_report_text(handle)), rows,
               samples.array(), files_of, letters, _OUTCOMES[_lib.gsim_run_outcome(handle)], request.diagnostics)


def translate(program, text=None, *, files=None, **options):
    """A part program as a script in Lua."""
    request = _Request(program, text, files, options)
    pieces = []
    take = _ffi.callback("gsim_write_text",
                         lambda _, data, size: 1 if pieces.append(bytes(_ffi.buffer(data, size))) is None else 0)
    status = _lib.gsim_translate(request.handle, request.tell, _ffi.NULL, take, _ffi.NULL)
    if status != 0:
        told = request.diagnostics
        request.refuse(status, told[0]["text"] if told else "it cannot be translated")
    return b"".join(pieces).decode()
