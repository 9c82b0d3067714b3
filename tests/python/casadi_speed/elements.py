#!/usr/bin/env python3
"""Time of every exported element in C beside Rust's, and beside the C that CasADi makes of the same element.

CasADi gets what tests/python/check_elements.py states: residuals, free motions and the law of friction. It derives rows,
forces and matrices, and its results are compared with ours before anything is timed. All three compute residuals, rows,
forces, stiffness, the derivative with respect to the multipliers, and the state, at the valid golden cases. C is compiled
with every compiler that is here, with -O2 and -O3, and the fastest counts; Rust is `Parameters::newton` in a release build.
Rust and C take turns, and the median of the rounds counts. ISL22A has no C by CasADi: its closest point is a search.

examples:
  python3 tests/python/casadi_speed/elements.py
  python3 tests/python/casadi_speed/elements.py --filter 'slot*' --rounds 5
"""

from __future__ import annotations

import argparse
import ctypes
import fnmatch
import json
import subprocess
import sys
from pathlib import Path
from statistics import geometric_mean, median
from types import SimpleNamespace

import casadi as ca
import numpy as np
import symbols
from compiled import FLAGS, LEVELS, LOOP, Compiled, Timed, compilers, nanoseconds
from golden import READER, ROOT
from ours import run
from symbols import Number, plain

#: Of the values of a part, beside its largest.
CLOSE = 1e-6


def definitions():
    """The definitions of the elements, on expressions."""
    sys.modules["mpmath"] = symbols.stand_in()
    sys.path.insert(0, str(ROOT / "tests/python"))
    import check_elements

    check_elements.mp.nint = lambda x: Number(ca.floor(plain(x) + 0.5))
    return check_elements


DEFINED = definitions()


def chosen(numbers) -> ca.SX:
    """A list of numbers that compares, as one column of expressions chosen by `if_else`."""
    return symbols.joined(SimpleNamespace(outputs=["all"]), lambda: dict(all=numbers()), {}, [])


class Joint:
    """Friction, which compares, as numbers chosen by `if_else`."""

    def friction(self, nodes, multipliers):
        whole = super().friction
        if not self.rubs:
            return [], {}

        def all():
            frictions, after = whole(nodes, multipliers)
            return [*frictions, *(after[name] for name in self.state)]

        found = [Number(x) for x in ca.vertsplit(chosen(all))]
        count = len(found) - len(self.state)
        return found[:count], dict(zip(self.state, found[count:], strict=True))


class OnLine:
    """What touches at one slave node likewise: at all of them at once there are too many ways."""

    def touched(self, nodes):
        whole, points, given = super().touched, self.points, self.given
        found = []
        for k in range(len(points(nodes))):
            self.points = lambda nodes, k=k: [points(nodes)[k]]
            self.given = given | {name: [given[name][k]] for name in self.state if self.rubs}
            found.append(tuple(map(Number, ca.vertsplit(chosen(lambda: list(whole(nodes)[0]))))))
        del self.points
        self.given = given
        return found


def function(file: dict, rubs: bool) -> ca.Function:
    """From all inputs in a row to all results."""
    shapes = lambda kind: {f["name"]: f["shape"][0] if f["shape"] else None for f in file[kind]}  # noqa: E731
    kinds = ["nodes", "multipliers", "start", *(("contact", "state") if rubs else ())]
    x, first, given = ca.SX.sym("x", sum(n or 1 for kind in kinds for n in shapes(kind).values())), 0, {}
    for name, length in (pair for kind in kinds for pair in shapes(kind).items()):
        parts = [Number(x[first + k]) for k in range(length or 1)]
        given[name] = parts if length else parts[0]
        first += length or 1
    definition = DEFINED.ELEMENTS[file["element"]]
    is_line = issubclass(definition, DEFINED.Isl)
    element = object.__new__(type("Element", (OnLine if is_line else Joint, definition), {}))
    element.given, element.rubs, element.state = given, rubs, shapes("state")
    element.unknowns = [(name, k) for name, length in shapes("unknowns").items() for k in range(length or 1)]
    element.multipliers = list(shapes("multipliers"))
    nodes, held = {name: given[name] for name in shapes("nodes")}, [given[name] for name in element.multipliers]

    def moved(nodes, by):
        for k, unknown in enumerate(element.unknowns):
            nodes = DEFINED.moved(nodes, unknown, Number(by[k]))
        return nodes

    q, r = (ca.SX.sym(name, len(element.unknowns)) for name in "qr")
    at_rest = lambda y, s: ca.substitute(y, s, ca.SX.zeros(*s.shape))  # noqa: E731
    column = lambda numbers: ca.vertcat(*map(plain, numbers))  # noqa: E731
    there = moved(nodes, q)
    derived = lambda of: at_rest(ca.jacobian(chosen(lambda: of(moved(there, r))), r), r)  # noqa: E731
    after = {}
    if is_line:
        forces = column(element.forces(there, held))
        after = element.friction(nodes, held)[1] if rubs else {}
    else:
        own = type(element).all_rows is not DEFINED.Element.all_rows
        rows = ca.vertcat(*(column(row).T for row in element.all_rows(there))) if own else derived(element.residual)
        forces = rows.T @ column(held)
        if rubs:
            frictions, _ = element.friction(there, held)
            forces -= derived(element.motions).T @ column(frictions)
            after = element.friction(nodes, held)[1]
    residuals, still = chosen(lambda: element.residual(there)), at_rest(forces, q)
    rows = rows if not is_line and own else ca.jacobian(residuals, q)
    parts = [at_rest(residuals, q), at_rest(rows, q).T, still, at_rest(ca.jacobian(forces, q), q).T]
    parts += [ca.jacobian(still, column(held)).T] if held else []
    state = [x for value in after.values() for x in (value if isinstance(value, list) else [value])]
    # Matrices of CasADi go column by column.
    results = ca.vertcat(*(ca.vec(ca.densify(part)) for part in parts), column(state))
    return ca.Function("by_casadi", [x], ca.cse([results]))


def ours(file: dict, form: str) -> tuple[str, int, int]:
    """A call of the exported function as the loop has it, and how many numbers go in and come out."""
    rubs = form == "rubbing"
    kinds = ["nodes", "multipliers", "start", *(("contact", "state") if rubs else ())]
    lengths = [(f["shape"] or [0])[0] for kind in kinds for f in file[kind]]
    size = lambda kind: sum((f["shape"] or [1])[0] for f in file[kind])  # noqa: E731
    n, m, held = size("unknowns"), size("residuals"), size("multipliers")
    outs = [m, m * n, n, n * n, n * held, size("state") if rubs else 0]
    arguments, at = [], 0
    for length in lengths:
        arguments.append(f"x + {at}" if length else f"x[{at}]")
        at += length or 1
    inputs, at = at, 0
    for out in outs:
        arguments += [f"both + {at}"] if out else []
        at += out
    return f"jp_element_{file['element']}_{form}_step({', '.join(arguments)})", inputs, at


def built(folder: Path, stem: str, text: str, sizes: tuple[int, int]) -> list[Compiled]:
    """A text with a function `one(x, both)` by every compiler, at every level."""
    loop = LOOP.split("void evaluate")[1].replace("{{", "{").replace("}}", "}")
    inputs, results = sizes
    head = f"#include <time.h>\n#define N {inputs}\n#define M {results}\n"
    source = folder / f"{stem}.c"
    source.write_text(f"{text}\n{head}\nvoid evaluate{loop}")
    found = []
    for compiler in compilers():
        for level in LEVELS:
            library = folder / f"{stem}{level}-{compiler}.so"
            flags = ["-std=gnu99", level, "-ffp-contract=off", *FLAGS]
            subprocess.run([compiler, *flags, "-o", library, source, "-lm"], check=True)
            found.append(Compiled(f"{compiler} {level}", ctypes.CDLL(str(library)), results, results))
    return found


def c_of_ours(file: dict, form: str, folder: Path) -> list[Compiled]:
    call, *sizes = ours(file, form)
    stem = f"jp_element_{file['element']}_{form}"
    parts = [f'#include "{path.name}"' for path in sorted(folder.glob(f"{stem}*.c"))]
    one = f"static inline void one(const double *x, double *both)\n{{\n    {call};\n}}\n"
    return built(folder, f"ours_{stem}", "\n".join(parts) + "\n" + one, sizes)


def c_of_casadi(file: dict, form: str, folder: Path) -> list[Compiled]:
    generated = function(file, form == "rubbing")
    generator = ca.CodeGenerator("by_casadi.c")
    generator.add(generated)
    one = """static inline void one(const double *x, double *both)
{
    const double *arguments[1] = {x};
    double *results[1] = {both};
    by_casadi(arguments, results, 0, 0, 0);
}
"""
    sizes = generated.numel_in(0), generated.numel_out(0)
    return built(folder, f"casadi_{file['element']}_{form}", generator.dump() + one, sizes)


def points(file: dict, form: str) -> np.ndarray:
    """The valid golden cases."""
    flat = lambda x: [z for y in x for z in flat(y)] if isinstance(x, list) else [x]  # noqa: E731
    cases = [case for case in file["cases"] if "out" in case and ("mu" in case["in"]) == (form == "rubbing")]
    return np.array([flat([READER.numbers(x) for x in case["in"].values()]) for case in cases])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--filter", default="*", metavar="GLOB", help="only the elements that match")
    parser.add_argument("--rounds", type=int, default=5, help="how often all are timed (5)")
    parser.add_argument("--turns", type=int, default=21, help="turns of C a round, whose median counts (21)")
    parser.add_argument("--xtask", default="cargo xtask", metavar="COMMAND", help="runs export (cargo xtask)")
    parser.add_argument("--out", type=Path, default=Path("target/casadi/elements"), metavar="FOLDER")
    options = parser.parse_args()
    folder = options.out.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    rust = ["cargo", "build", "--quiet", "--release", "--manifest-path", str(Path(__file__).with_name("rust") / "Cargo.toml")]
    subprocess.run([*rust, "--target-dir", str(folder / "rust")], check=True)
    files = [json.loads(path.read_text(encoding="utf-8")) for path in sorted((ROOT / "golden/elements").glob("*.json"))]
    files = [file for file in files if "element" in file and fnmatch.fnmatch(file["element"], options.filter)]
    c: dict[str, list[Timed]] = {}
    by_casadi: dict[str, list[Timed]] = {}
    for file in files:
        run(options.xtask, "export", "--lang", "c", "--element", file["element"], "--out", folder)
        for form in ("smooth", "rubbing") if file["contact"] else ("smooth",):
            name, x = f"{file['element']}_{form}", points(file, form)
            x.astype("<f8").tofile(folder / f"{name}.f64")
            mine, other = c_of_ours(file, form, folder), []
            if not file["element"].startswith("isl22a"):
                other = c_of_casadi(file, form, folder)
                if wrong := [at for at in x if not are_close(mine[0].evaluate(at), other[0].evaluate(at))]:
                    print(f"{name}: CasADi has another result at {len(wrong)} of {len(x)} points", file=sys.stderr)
            c[name], by_casadi[name] = ([Timed(one, x) for one in some] for some in (mine, other))
            print(f"compiled {name}", file=sys.stderr)
    samples: dict[str, list[tuple[float, ...]]] = {name: [] for name in c}
    for round in range(options.rounds):
        ran = subprocess.run([folder / "rust/release/element-speed", folder], check=True, capture_output=True, text=True)
        of_rust = {name: float(time) for name, time in (line.split() for line in ran.stdout.splitlines())}
        for name in c:
            found = nanoseconds([*c[name], *by_casadi[name]], options.turns)
            of_c, of_casadi = found[: len(c[name])], found[len(c[name]) :]
            samples[name].append((min(of_c), of_rust[name], min(of_casadi, default=np.nan)))
        print(f"round {round + 1} of {options.rounds}", file=sys.stderr)
    print(f"{'':28} {'C, ns':>9} {'Rust, ns':>9} {'CasADi':>9}  C/Rust  C/CasADi")
    ratios = []
    for name, rounds in samples.items():
        times = [median(of) for of in zip(*rounds)]
        ratios.append([median(c / other[k] for c, *other in rounds) for k in (0, 1)])
        print(f"{name:28} {times[0]:9.1f} {times[1]:9.1f} {times[2]:9.1f}  {ratios[-1][0]:6.2f}  {ratios[-1][1]:8.2f}")
    to_rust, to_casadi = ([x for x in some if x == x] for some in zip(*ratios))
    print(f"C is at most {max(to_rust):.2f} times Rust, geometric mean {geometric_mean(to_rust):.2f};", end=" ")
    if to_casadi:
        print(f"{max(to_casadi):.2f} times CasADi's C at most, geometric mean {geometric_mean(to_casadi):.2f}", end="")
    print()
    return 0


def are_close(mine: np.ndarray, other: np.ndarray) -> bool:
    return bool(np.abs(mine - other).max() <= CLOSE * np.abs(mine).max())


if __name__ == "__main__":
    sys.exit(main())
