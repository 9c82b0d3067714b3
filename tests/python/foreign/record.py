#!/usr/bin/env python3
"""Writes how well the programs that are installed agree: tests/data/foreign/PROGRAM.json, for the book's table.

cargo xtask export --lang numpy --out target/export/numpy
python3 tests/python/foreign/record.py
"""

from __future__ import annotations

import sys
from importlib.metadata import version

from agreement import record_file, write
from export import Export
from programs import PROGRAMS, Absent, load

for ours in PROGRAMS:
    try:
        program = load(ours)
    except Absent as absent:
        print(f"left as it is: {absent}", file=sys.stderr)
        continue
    measured = [(comparison, comparison.measure(Export(), comparison.count)) for comparison in program.comparisons()]
    write(program.NAME, version(program.PACKAGE), measured)
    print(f"wrote {record_file(program.NAME)}")
