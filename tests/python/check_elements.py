#!/usr/bin/env python3
"""Recompute every number of the golden files of elements from residuals, free motions and the law of friction alone.

Rows are differences of residuals, forces are Rows^T lambda and friction against its motions, and matrices are differences of
forces, with hundreds of digits: nothing is derived by hand. SLIDER's rows are those of the oracle, since they are the
derivative of its residuals on the line only. On a slide line there are no multipliers: forces are area times pressure and
shear at each closest point.

examples:
  python check_elements.py                   all files of ../../golden/elements
  python check_elements.py --filter 'slot*'  some of them
"""

from __future__ import annotations

import argparse
import fnmatch
import json
import multiprocessing
import sys
from pathlib import Path
from typing import Any, Callable

from check_golden import flatten, number
from mpmath import mp, mpf
from oracle import CATALOG
from oracle.contact import nodal_forces
from oracle.core import bits_of, cross, dot, norm, scale, sub, to_double
from oracle.slide_line import at, closest, derivative, gauss_legendre_5, normal, parabolic

GOLDEN = Path(__file__).resolve().parents[2] / "golden/elements"
DIGITS = 420
#: Steps of differences of residuals, and of forces, which are differences themselves.
FINE, COARSE = mpf(10) ** -120, mpf(10) ** -60
#: What is this part of the largest scale beside it, or less, is zero: differences leave nothing smaller.
NOTHING = mpf(10) ** -90
SHOWN = 10

Values = dict[str, Any]


def call(id: str, values: Values) -> Values:
    entry = CATALOG[id]
    return entry.function(**{name: values[name] for name in entry.inputs})


def numbers(values: Values) -> list:
    return [leaf for value in values.values() for _, leaf in flatten(value)]


def moved(nodes: Values, unknown: tuple[str, int], step) -> Values:
    """The nodes after a small motion: a translation, or a spin of a triad."""
    (name, component), found = unknown, dict(nodes)
    kind, node = name[0], name[1:]
    if kind == "u":
        x = list(nodes[f"x{node}"])
        x[component] += step
        return found | {f"x{node}": x}
    for axis in ("e1", "e2", "e3"):
        e = nodes.get(axis + node)
        if e is None:
            continue
        if len(e) == 2:
            found[axis + node] = [e[0] - step * e[1], e[1] + step * e[0]]
        else:
            spin = [step if k == component else mpf(0) for k in range(3)]
            found[axis + node] = [x + y for x, y in zip(e, cross(spin, e), strict=True)]
    return found


def nearest(angle, to):
    return angle + 2 * mp.pi * mp.nint((to - angle) / (2 * mp.pi))


def slid(du, f_before, k_stick, mu, fn):
    """The friction after an increment of motion."""
    return call("coulomb.response", dict(du=du, f_before=f_before, k_stick=k_stick, mu=mu, fn=fn))["f"]


class Element:
    """An element at a case: its residuals, and what rubs."""

    residuals: str
    rows: str | None = None

    def __init__(self, file: dict, case: dict):
        exact = lambda value: [exact(x) for x in value] if isinstance(value, list) else mpf(number(value))  # noqa: E731
        self.given = {name: exact(value) for name, value in case["in"].items()}
        components = lambda fields: [(f["name"], k) for f in fields for k in range(f["shape"][0] if f["shape"] else 1)]  # noqa: E731
        self.unknowns = components(file["unknowns"])
        self.multipliers = [field["name"] for field in file["multipliers"]]
        self.nodes = {field["name"]: self.given[field["name"]] for field in file["nodes"]}
        self.rubs = "mu" in self.given

    def residual(self, nodes: Values) -> list:
        return numbers(call(self.residuals, self.given | nodes))

    def motions(self, nodes: Values) -> list:
        """The free motions that rub."""
        return []

    def friction(self, nodes: Values, multipliers: list) -> tuple[list, Values]:
        """What works against each of them, and the state after."""
        return [], {}

    def by_unknowns(self, of: Callable[[Values], list], nodes: Values, step) -> list[list]:
        """The derivative of every number by the degrees of freedom."""
        columns = []
        for unknown in self.unknowns:
            ahead, behind = (of(moved(nodes, unknown, sign * step)) for sign in (1, -1))
            columns.append([(x - y) / (2 * step) for x, y in zip(ahead, behind, strict=True)])
        return [list(row) for row in zip(*columns, strict=True)]

    def all_rows(self, nodes: Values) -> list[list]:
        return self.by_unknowns(self.residual, nodes, FINE)

    def forces(self, nodes: Values, multipliers: list) -> list:
        rows, forces = self.all_rows(nodes), [mpf(0)] * len(self.unknowns)
        for row, multiplier in zip(rows, multipliers, strict=True):
            forces = [f + multiplier * x for f, x in zip(forces, row, strict=True)]
        if self.rubs:
            frictions, _ = self.friction(nodes, multipliers)
            for row, friction in zip(self.by_unknowns(self.motions, nodes, FINE), frictions, strict=True):
                forces = [f - friction * x for f, x in zip(forces, row, strict=True)]
        return forces

    def out(self) -> Values:
        held = [self.given[name] for name in self.multipliers]
        columns = []
        for k in range(len(held)):
            ahead, behind = (
                self.forces(self.nodes, [x + sign * COARSE * (j == k) for j, x in enumerate(held)]) for sign in (1, -1)
            )
            columns.append([(x - y) / (2 * COARSE) for x, y in zip(ahead, behind, strict=True)])
        found = dict(
            residuals=self.residual(self.nodes),
            rows=self.all_rows(self.nodes),
            forces=self.forces(self.nodes, held),
            stiffness=self.by_unknowns(lambda nodes: self.forces(nodes, held), self.nodes, COARSE),
            by_multipliers=[list(row) for row in zip(*columns, strict=True)],
        )
        return found | ({"after": self.friction(self.nodes, held)[1]} if self.rubs else {})


class Join(Element):
    residuals = "join.constraint"


class Align(Element):
    residuals = "align.constraint"


class Universal(Element):
    residuals = "universal.constraint"


class Slot(Element):
    residuals = "slot.constraint"

    def motions(self, nodes: Values) -> list:
        return [dot(nodes["e1a"], sub(nodes["xb"], nodes["xa"])) - self.given["x0"]]

    def loads(self, nodes: Values, multipliers: list) -> Values:
        return dict(zip(self.multipliers, multipliers, strict=True))

    normal = "slot.friction"

    def friction(self, nodes: Values, multipliers: list) -> tuple[list, Values]:
        u1, given = self.motions(nodes)[0], self.given
        normal = call(self.normal, given | dict(f1=mpf(0), f3=mpf(0)) | self.loads(nodes, multipliers))["fn"]
        f1 = slid(u1 - given["u1"], given["f1"], given["k_stick"], given["mu"], normal)
        return [f1], dict(u1=u1, f1=f1)


class Slot2d(Slot):
    residuals = "slot.constraint_2d"

    def motions(self, nodes: Values) -> list:
        x, y = nodes["e2a"]
        return [dot([y, -x], sub(nodes["xb"], nodes["xa"])) - self.given["x0"]]


class Translator(Slot):
    residuals = "translator.constraint"
    normal = "translator.friction"

    def loads(self, nodes: Values, multipliers: list) -> Values:
        """About e1a is the first multiplier of ALIGN; about the others, what all three do on b."""
        f2, f3, *aligning = multipliers
        given = self.given | nodes | dict(zip(self.multipliers[2:], aligning, strict=True))
        moment = call("align.nodal_moments", given)["mb"]
        return dict(f2=f2, f3=f3, m1=aligning[0], m2=dot(nodes["e2a"], moment), m3=dot(nodes["e3a"], moment))


class UJoint(Element):
    residuals = "ujoint.constraint"

    def motions(self, nodes: Values) -> list:
        alpha, gamma = call("universal.angles", self.given | nodes).values()
        return [
            nearest(alpha - self.given["alpha0"], self.given["ur1"]),
            nearest(gamma - self.given["gamma0"], self.given["ur3"]),
        ]

    def friction(self, nodes: Values, multipliers: list) -> tuple[list, Values]:
        """The twisting moment is conjugate to the second angle, the multiplier to its sine."""
        f1, f2, f3, lambda_rot = multipliers
        sine = dot(nodes["e1a"], nodes["e3b"])
        ur1, ur3 = self.motions(nodes)
        loads = dict(f1=f1, f2=f2, f3=f3, m2=lambda_rot * mp.sqrt(1 - sine**2))
        given = self.given | nodes | loads
        normal = call("ujoint.normal_moments", given | call("ujoint.contact_moments", given))
        m1, m3 = (
            slid(turn - given[f"ur{k}"], given[f"m{k}"], given[f"k_stick{k}"], given["mu"], normal[f"mn{k}"])
            for k, turn in ((1, ur1), (3, ur3))
        )
        return [m1, m3], dict(ur1=ur1, ur3=ur3, m1=m1, m3=m3)


class Hinge(Element):
    residuals = "hinge.constraint"

    def motions(self, nodes: Values) -> list:
        alpha = call("revolute.angle", self.given | nodes)["alpha"]
        return [nearest(alpha - self.given["alpha0"], self.given["ur1"])]

    def friction(self, nodes: Values, multipliers: list) -> tuple[list, Values]:
        """The documented moments are the components of what the multipliers of REVOLUTE do on b."""
        f1, f2, f3, lambda2, lambda3 = multipliers
        e1a, (ur1,) = nodes["e1a"], self.motions(nodes)
        on_b = [
            lambda2 * x + lambda3 * y for x, y in zip(cross(nodes["e2b"], e1a), cross(nodes["e3b"], e1a), strict=True)
        ]
        loads = dict(f1=f1, f2=f2, f3=f3, m1=mpf(0), m2=dot(nodes["e2a"], on_b), m3=dot(nodes["e3a"], on_b))
        normal = call("hinge.friction", self.given | loads)["mn"]
        m1 = slid(ur1 - self.given["ur1"], self.given["m1"], self.given["k_stick"], self.given["mu"], normal)
        return [m1], dict(ur1=ur1, m1=m1)


class Isl(Element):
    """Slave nodes against their segments; what is reported with its derivative is the torque."""

    shape = "linear"

    def points(self, nodes: Values) -> list[tuple[list, list[list]]]:
        """Every slave node with the nodes of its segment."""
        numbers = range(1, 3 if self.shape == "linear" else 4)
        return [(nodes[f"xs{s}"], [nodes[f"x{s}{k}"] for k in numbers]) for s in numbers]

    def foot(self, xs: list, segment: list[list]) -> tuple:
        """Coordinate and separation, and whether the slave node is between the ends."""
        x1, x2 = segment
        along = sub(x2, x1)
        length = norm(*along)
        g = 2 * dot(sub(xs, x1), along) / length**2 - 1
        return g, dot(sub(xs, x1), normal(scale(1 / length, along))), -1 <= g <= 1

    def path(self, segment: list[list], before, g):
        """From one point of the segment to another, along it."""
        return (g - before) / 2 * norm(*sub(segment[1], segment[0]))

    def pressure(self, h):
        law = self.given | dict(h=h)
        return call("interaction.pressure_linear" if "k" in law else "interaction.pressure_exponential", law)["p"]

    def touched(self, nodes: Values) -> list[tuple]:
        """Coordinate, pressure and shear stress of every slave node."""
        found = []
        for slave, (xs, segment) in enumerate(self.points(nodes)):
            g, separation, inside = self.foot(xs, segment)
            s11, s12 = self.pressure(-separation) if inside else mpf(0), mpf(0)
            if self.rubs and s11 > 0:
                slip = self.path(segment, self.given["g"][slave], g)
                s12 = slid(slip, self.given["s12"][slave], self.given["k_stick"], self.given["mu"], s11)
            found.append((g, s11, s12))
        return found

    def slaves(self, nodes: Values) -> Values:
        return {f"x{k}": xs for k, (xs, _) in enumerate(self.points(nodes), 1)}

    def residual(self, nodes: Values) -> list:
        pressures = {f"p{k}": s11 for k, (_, s11, _) in enumerate(self.touched(nodes), 1)}
        return [call(f"slide_line.torque_{self.shape}", self.slaves(nodes) | pressures)["t"]]

    def forces(self, nodes: Values, multipliers: list) -> list:
        areas = call(f"slide_line.contact_area_{self.shape}", self.slaves(nodes)).values()
        on_slaves, on_line = [], []
        for (g, s11, s12), area, (_, segment) in zip(self.touched(nodes), areas, self.points(nodes), strict=True):
            found = list(nodal_forces(segment, g, area, s11, s12).values())
            on_slaves += found[0]
            on_line += [x for force in found[1:] for x in force]
        return on_slaves + on_line

    def friction(self, nodes: Values, multipliers: list) -> tuple[list, Values]:
        touched = self.touched(nodes)
        return [], dict(g=[g for g, _, _ in touched], s12=[s12 for _, _, s12 in touched])


class IslParabolic(Isl):
    shape = "parabolic"

    def foot(self, xs: list, segment: list[list]) -> tuple:
        g, separation = closest(xs, parabolic(*segment), -1, 1)
        return g, separation, -1 < g < 1

    def path(self, segment: list[list], before, g):
        """By Gauss's rule with five points, as the element has it."""
        velocity = [derivative(p) for p in parabolic(*segment)]
        middle, reach = (g + before) / 2, (g - before) / 2
        return sum(w * reach * norm(*at(velocity, middle + reach * x)) for x, w in gauss_legendre_5())


class Slider(Element):
    residuals = "slider.constraint"

    def all_rows(self, nodes: Values) -> list[list]:
        found = call("slider.rows", self.given | nodes)
        return [[x for motion in ("u1", "un", "um") for x in found[f"{g}_{motion}"]] for g in ("g1", "g2")]


class Slider2d(Element):
    residuals = "slider.constraint_2d"

    def all_rows(self, nodes: Values) -> list[list]:
        found = call("slider.rows_2d", self.given | nodes)
        return [[x for motion in ("u1", "un", "um") for x in found[f"g_{motion}"]]]


ELEMENTS: dict[str, type[Element]] = dict(
    slot=Slot,
    slot_2d=Slot2d,
    align=Align,
    translator=Translator,
    join=Join,
    universal=Universal,
    ujoint=UJoint,
    hinge=Hinge,
    slider=Slider,
    slider_2d=Slider2d,
    isl21a_linear=Isl,
    isl21a_exponential=Isl,
    isl22a_linear=IslParabolic,
    isl22a_exponential=IslParabolic,
)


def check_case(job: tuple[dict, dict]) -> tuple[int, list[str]]:
    """How many numbers are right, and what is wrong."""
    file, case = job
    mp.dps = DIGITS
    found = ELEMENTS[file["element"]](file, case).out()
    right, wrong = 0, []
    for part, written in case["out"].items():
        exact = found[part]
        lists = (written, exact, case["out_scale"][part])
        fields = {f"after.{name}": [x[name] for x in lists] for name in written} if part == "after" else {part: lists}
        pairs = [
            (name + path, x, y, size)
            for name, lists in fields.items()
            for (path, x), (_, y), (_, size) in zip(*map(flatten, lists), strict=True)
        ]
        largest = max((mpf(size) for *_, size in pairs), default=mpf(0))
        for name, golden, true, _ in pairs:
            if abs(true) <= NOTHING * largest:
                true = mpf(0)
            have, want = number(golden), to_double(true)
            if bits_of(have) == bits_of(want) or have == want == 0:
                right += 1
            else:
                wrong.append(f"{file['element']}: case {case['id']}: {name}: golden {have!r}, oracle {want!r}")
    return right, wrong


def check(file: dict, workers: multiprocessing.pool.Pool) -> tuple[int, int, list[str]]:
    """Valid cases, numbers that are right, and what is wrong."""
    if file["element"] not in ELEMENTS:
        return 0, 0, [f"{file['element']}: no such element here"]
    jobs = [(file | {"cases": []}, case) for case in file["cases"] if "out" in case]
    results = workers.map(check_case, jobs, chunksize=1)
    return len(jobs), sum(right for right, _ in results), [line for _, wrong in results for line in wrong]


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--golden", type=Path, default=GOLDEN, help="directory of the files")
    parser.add_argument("--filter", default="*", help="pattern of identifiers")
    options = parser.parse_args(arguments)
    paths = [path for path in sorted(options.golden.glob("*.json")) if path.stem != "schema"]
    paths = [path for path in paths if fnmatch.fnmatch(path.stem, options.filter)]
    if not paths:
        print(f"no element matches {options.filter!r} in {options.golden}", file=sys.stderr)
        return 2
    all_right, all_wrong = 0, 0
    with multiprocessing.Pool() as workers:
        for path in paths:
            cases, right, wrong = check(json.loads(path.read_text(encoding="utf-8")), workers)
            all_right, all_wrong = all_right + right, all_wrong + len(wrong)
            print(f"{'ok ' if not wrong else 'off'} {path.stem}: {cases} cases, {right} numbers", flush=True)
            print("".join(f"    {line}\n" for line in wrong[:SHOWN]), end="")
    print(f"{len(paths)} elements, {all_right} numbers correctly rounded, {all_wrong} off")
    return 1 if all_wrong else 0


if __name__ == "__main__":
    sys.exit(main())
