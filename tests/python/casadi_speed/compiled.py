"""The C that CasADi writes, compiled in every way that might be the fastest, and called."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path
from statistics import median

import casadi as ca
import numpy as np
from symbols import function

COMPILERS, LEVELS = ("gcc", "clang"), ("-O2", "-O3")
FLAGS = ("-fPIC", "-shared", "-fno-semantic-interposition")
#: As `report` does: points whose results are looked at, so that no call is left out.
LOOP = r"""
#include <time.h>
#define N {inputs}
#define M {results}

/* What this is, the compiler cannot tell, as of a function in another file. */
static int (*volatile called)(const casadi_real **, casadi_real **, casadi_int *, casadi_real *, int) = {name};

static inline void one(const double *x, double *both)
{{
    const double *arguments[1] = {{x}};
    double *results[2] = {{both, both + {outputs}}};
    {call}(arguments, results, 0, 0, 0);
}}

void evaluate(const double *x, double *both) {{ one(x, both); }}

/* Turn by turn the results lie at another place within a line of the cache and a page, as those of `report` do. */
double nanoseconds(const double *x, long points, long calls, long turn)
{{
    struct timespec start, end;
    double room[M + 8 * 66], *both = room + 66 * (turn % 8);
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (long call = 0; call < calls; ++call)
        for (long k = 0; k < points; ++k) {{
            const double *point = x + k * N;
            __asm__ volatile("" : "+r"(point) : : "memory");
            one(point, both);
            __asm__ volatile("" : : "r"(both) : "memory");
        }}
    clock_gettime(CLOCK_MONOTONIC, &end);
    return ((end.tv_sec - start.tv_sec) * 1e9 + (end.tv_nsec - start.tv_nsec)) / (double)(points * calls);
}}
"""


def compilers(wanted: tuple[str, ...] = COMPILERS) -> list[str]:
    """Those of them that are here."""
    return [compiler for compiler in wanted if shutil.which(compiler)]


@dataclass
class Compiled:
    """One formula, compiled in one way."""

    flags: str
    library: ctypes.CDLL
    outputs: int
    results: int

    def evaluate(self, x: np.ndarray) -> np.ndarray:
        """Outputs and Jacobian in a row."""
        both = np.empty(self.results)
        self.library.evaluate(pointer(x), pointer(both))
        return both


class Timed:
    """One formula over some points, which takes turns with others."""

    def __init__(self, compiled: Compiled, points: np.ndarray, turn_ns: float = 1e5):
        self.loop, self.points = compiled.library.nanoseconds, points
        self.loop.restype = ctypes.c_double
        self.loop.argtypes = (ctypes.c_void_p, *[ctypes.c_long] * 3)
        once = min(self.turn(turn, calls=2) for turn in range(3))
        self.calls = max(1, int(turn_ns / (once * len(points))))

    def turn(self, turn: int, calls: int) -> float:
        """Nanoseconds an evaluation in the n-th turn."""
        return self.loop(pointer(self.points), len(self.points), calls, turn)

    def warm_turn(self, turn: int) -> float:
        """As in `report`, a pass before it brings back what others pushed out of the caches."""
        self.turn(turn, calls=1)
        return self.turn(turn, self.calls)


def nanoseconds(timed: list[Timed], turns: int) -> list[float]:
    """Nanoseconds an evaluation of each, the median of its turns: all take turns, so that a slow moment falls on all alike."""
    rounds = [[one.warm_turn(turn) for one in timed] for turn in range(turns)]
    return [median(samples) for samples in zip(*rounds)]


def pointer(x: np.ndarray):
    return x.ctypes.data_as(ctypes.c_void_p)


def compiled(id: str, folder: Path, by: list[str], called: bool) -> list[Compiled]:
    """A formula by these compilers, at every level; called, or compiled in place if that is faster."""
    generated = function(id)
    name, outputs, entries = generated.name(), generated.numel_out(0), generated.numel_out(1)
    generator = ca.CodeGenerator(f"{name}.c")
    generator.add(generated)
    sizes = {"inputs": generated.numel_in(0), "outputs": outputs, "results": outputs + entries}
    loop = LOOP.format(name=name, call="called" if called else name, **sizes)
    source = folder / f"{name}.c"
    # Within one file, so that the call may be inlined, as Rust's is; CasADi itself writes a file that is called.
    source.write_text(generator.dump() + loop)
    found = []
    for compiler in by:
        for level in LEVELS:
            library = folder / f"{name}{level}-{compiler}.so"
            command = [compiler, "-std=gnu99", level, *FLAGS, "-o", library, source, "-lm"]
            subprocess.run(command, check=True)
            found.append(Compiled(f"{compiler} {level}", ctypes.CDLL(str(library)), outputs, outputs + entries))
    return found
