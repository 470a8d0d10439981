#!/usr/bin/env python3
"""Prints the declarations of engine/gsim.h as cffi accepts them: without comments, directives, old names and the parts for C++.
Usage: cdef.py GSIM_H"""

import re
import sys
from pathlib import Path

text = re.sub(r"/\*.*?\*/", "", Path(sys.argv[1]).read_text(encoding="utf-8"), flags=re.S)
text = re.sub(r"#ifdef __cplusplus\n.*?#endif\n", "", text, flags=re.S)
text = re.sub(r"#ifndef GSIM_NO_OLD_NAMES\n.*?#endif\n", "", text, flags=re.S)
text = re.sub(r"union \{\s*(\w+ \w+;)[^}]*\};", r"\1", text)
constants = dict(re.findall(r"^#define (GSIM_\w+) (\d+)\s*$", text, flags=re.M))
lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
text = "\n".join(lines) + "\n"
for name, value in constants.items():
    text = text.replace(f"[{name}]", f"[{value}]")
print(text, end="")
