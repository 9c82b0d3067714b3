#!/usr/bin/env python3
"""Check proved bounds of rounding errors: that the steps of every certificate add up to its bound. Standard library alone.

  cargo xtask prove --graphs target/graphs
  python check_bounds.py target/graphs           the certificates of ../../golden/bounds
  python check_bounds.py target/graphs FOLDER    those of another folder

Parts are compared modulo a prime, at points where inputs look random. A sign is known up to 1 (not below 0) and 2 (not above 0).
"""

from __future__ import annotations

import hashlib
import json
import math
import random
import struct
import sys
from collections import defaultdict
from fractions import Fraction
from pathlib import Path

PRIME, POINTS, SMALL, TURNED = 2**127 - 1, 8, 2**40, (0, 2, 1, 3)
RHO = {"add": 1, "subtract": 1, "multiply": 1, "divide": 1, "root": 1, "multiply and add": 1, "exact sum": 2, "sine": 2, "cosine": 2,
       "exponential": 2, "exponential minus one": 2, "arc sine": Fraction(13, 5), "angle": 4, "number": 1}  # fmt: skip
RATIONAL = {"add": Fraction.__add__, "subtract": Fraction.__sub__, "multiply": Fraction.__mul__, "divide": Fraction.__truediv__,
            "negative": Fraction.__neg__, "absolute": Fraction.__abs__}  # fmt: skip
FIRST = {"add": (0, 1), "subtract": (0, 1), "multiply and add": (0, 2), "exact sum": range(0, 400, 4), "norm": range(400)}


class Refused(Exception):
    """A certificate does not prove what it says."""


def demand(holds, why: str) -> None:
    if not holds:
        raise Refused(why)


def bits(x: Fraction) -> float:
    """The significant bits of a double; infinite for other numbers."""
    n = abs(x.numerator)
    return (n // (n & -n)).bit_length() if n and x.denominator & (x.denominator - 1) == 0 else math.inf if n else 0


def inverse(x: int) -> int:
    return pow(x % PRIME, -1, PRIME)


def fraction(x: int) -> Fraction | None:
    """The quotient of small numbers that this is modulo the prime."""
    (a, b), (c, d) = (PRIME, 0), (x, 1)
    while c >= SMALL:
        (a, b), (c, d) = (c, d), (a % c, b - a // c * d)
    return Fraction(c, d) if 0 < abs(d) < SMALL else None


def are_all(ways: list[dict]) -> bool:
    """Whether one of these ways is taken however comparisons come out."""
    if not ways or not all(ways):
        return bool(ways)
    at = next(iter(ways[0]))
    return all(are_all([{k: v for k, v in way.items() if k != at} for way in ways if way.get(at, it) == it]) for it in (False, True))


class Way:
    """A way through the branches of a graph: numbers at points, their derivatives, and what is known of signs and sizes."""

    def __init__(self, ops: list[list], way: dict[int, bool], results: list[int]):
        self.ops, self.way, self.exact, self.less = ops, way, {}, []
        for by, answer in way.items():
            name, x, y = ops[by]
            try:
                x, y = map(self.resolved, (y, x) if name == "maximum" else (x, y))
                self.needed([x, y])
            except Refused:
                continue
            pairs = [(x, y, by), (y, x, by)]
            self.less += pairs if name == "equal" and answer else [] if name == "equal" else pairs[:1] if answer else pairs[1:]
        self.nodes = self.needed([self.resolved(n) for n in results] + [x for pair in self.less for x in pair[:2]])
        points = [self.point(k) for k in range(POINTS)]
        self.value, self.slopes = ({n: [point[of][n] for point in points] for n in self.nodes} for of in (0, 1))
        self.sign, said = {}, defaultdict(int)
        for _ in range(4):
            for n in self.nodes:
                self.sign[n] = self.sign_of(n) | said[n]
            self.bounded = self.ends()
            for x, y, by in self.less:
                said[y] |= self.sign[x] & 1
                said[x] |= self.sign[y] & 2
                pairs = [(x, y)] * (self.sign[x] & 1) + [(y, x)] * (self.sign[y] >> 1)
                for x, y in [tuple(map(self.bare, pair)) for pair in pairs]:
                    if all(self.value[y]):
                        sign = product(self.sign[x], self.sign[y])
                        z = times(self.value[x], [inverse(v) for v in self.value[y]])
                        self.bounded.append((z, Fraction((sign & 1) - 1), Fraction(1 - sign // 2), by))
            for n in self.nodes:
                for k, sign in enumerate(self.terms(n)):
                    term = times(self.value[self.operands(n)[k]], [-1 if k and self.ops[n][0] == "subtract" else 1] * POINTS)
                    for ratio in (between(self.value[n], term, it) for it in self.bounded if sign):
                        said[n] |= product(sign, (ratio[0] >= 0) | 2 * (ratio[1] <= 0)) if ratio else 0

    def ends(self) -> list[tuple]:
        """The numbers that domains, and comparisons with constants, bound by others than 0: values, both ends, and which it is."""
        low, high = ({n: Fraction(x) for n in self.nodes if self.ops[n][0] == "input" and (x := self.ops[n][k]) is not None} for k in (2, 3))
        for x, y, _ in self.less:
            if self.exact[x] is not None:
                low[y] = max(self.exact[x], low.get(y, self.exact[x]))
            if self.exact[y] is not None:
                high[x] = min(self.exact[y], high.get(x, self.exact[y]))
        some = [n for n in self.nodes if (low.get(n) or high.get(n)) and self.exact[n] is None]
        return [(self.value[n], low.get(n), high.get(n), n) for n in some]

    def resolved(self, node: int) -> int:
        while (name := self.ops[node][0]) in ("select", "maximum"):
            node = self.ops[node][-2 if self.holds(node if name == "maximum" else self.ops[node][1]) else -1]
        return node

    def holds(self, node: int) -> bool:
        while self.ops[node][0] == "select":
            node = self.ops[node][2 if self.holds(self.ops[node][1]) else 3]
        demand(node in self.way, f"the way does not say how {node} comes out")
        return self.way[node]

    def operands(self, node: int) -> list[int]:
        name, *operands = self.ops[node]
        return [] if name in ("input", "number", "power of two", "nearest integer") else [self.resolved(x) for x in operands]

    def needed(self, open_: list[int]) -> list[int]:
        found = set()
        while open_:
            found.add(node := open_.pop())
            open_ += [x for x in self.operands(node) if x not in found]
        for node in sorted(found):
            self.exact[node] = self.constant(node)
        return sorted(found)

    def constant(self, n: int) -> Fraction | None:
        """A literal of at most twenty bits, and what is made of such ones without rounding; others may stand for numbers without end."""
        name, known = self.ops[n][0], [self.exact[x] for x in self.operands(n)]
        if name == "number":
            x = struct.unpack(">d", bytes.fromhex(self.ops[n][1]))[0]
            return Fraction(x) if math.isfinite(x) and bits(Fraction(x)) <= 20 else None
        if name not in RATIONAL or None in known or name == "divide" and not known[1]:
            return None
        return value if bits(value := RATIONAL[name](*known)) <= 53 else None

    def scales(self, n: int) -> bool:
        """Whether it is a power of two."""
        if self.ops[n][0] in ("negative", "absolute", "multiply", "divide"):
            return all(map(self.scales, self.operands(n)))
        return self.ops[n][0] == "power of two" or self.exact[n] is not None and bits(self.exact[n]) == 1

    def rho(self, n: int) -> Fraction | int:
        name, x = self.ops[n][0], self.operands(n)
        zero, scales = [self.exact[k] == 0 for k in x], [self.scales(k) for k in x]
        exact = {"add": zero, "subtract": zero, "multiply": zero + scales, "divide": zero[:1] + scales[1:]}.get(name, [])
        return 0 if self.exact[n] is not None or any(exact) else Fraction(len(x) + 2, 2) if name == "norm" else RHO.get(name, 0)

    def point(self, k: int) -> tuple[dict, dict]:
        """Numbers at a point, and the derivatives of the result with respect to the uses of each, of later operations first."""
        for trial in range(4096):
            value, slopes, uses = {}, {}, defaultdict(list)
            for n in self.nodes:
                name, x = self.ops[n][0], [value[m] for m in self.operands(n)]
                t = symbol = random.Random(f"{k} {trial} {n}").randrange(1, PRIME)
                d = [symbol + 1]
                if self.exact[n] is not None:
                    t = self.exact[n].numerator * inverse(self.exact[n].denominator)
                if name == "negative":
                    t, d = -x[0], [-1]
                elif name == "absolute":
                    t, d = x[0] * symbol, [symbol]
                elif name in ("add", "subtract"):
                    d = [1, 1 if name == "add" else -1]
                    t = x[0] + d[1] * x[1]
                elif name == "multiply":
                    t, d = x[0] * x[1], x[::-1]
                elif name == "divide":
                    t, d = x[0] * inverse(x[1]), [inverse(x[1]), -x[0] * inverse(x[1]) ** 2]
                elif name in ("multiply and add", "exact sum"):
                    products = [x[:2], x[2:]] if name == "multiply and add" else [x[j : j + 4] for j in range(0, len(x), 4)]
                    t = sum(map(math.prod, products))
                    d = [math.prod(p[:j] + p[j + 1 :]) for p in products for j in range(len(p))]
                elif name in ("root", "norm"):
                    square = x[0] if name == "root" else sum(y * y for y in x)
                    t = pow(square, (PRIME + 1) // 4, PRIME) * (-1) ** (symbol & 1)
                    if not square % PRIME or (t * t - square) % PRIME:
                        break
                    d = [inverse(2 * t)] if name == "root" else [y * inverse(t) for y in x]
                elif name == "angle":
                    d = [y * inverse(x[0] ** 2 + x[1] ** 2) for y in (x[1], -x[0])]
                elif name == "exponential":
                    d = [t]
                value[n], slopes[n] = t % PRIME, d
            else:
                return value, slopes
        raise Refused("no point has all roots")

    def bare(self, n: int) -> int:
        return self.bare(self.operands(n)[0]) if self.ops[n][0] in ("absolute", "negative") else n

    def terms(self, n: int) -> list[int]:
        """The signs of the terms of a sum of two."""
        s = [self.sign[x] for x in self.operands(n)]
        return s if self.ops[n][0] == "add" else [s[0], TURNED[s[1]]] if self.ops[n][0] == "subtract" else []

    def sign_of(self, n: int) -> int:
        name, *x = self.ops[n]
        s = [self.sign[k] for k in self.operands(n)]
        if name == "number":
            return (self.exact[n] >= 0) | 2 * (self.exact[n] <= 0) if self.exact[n] is not None else 2 if int(x[0], 16) >> 63 else 1
        if name == "input":
            return (x[1] is not None and x[1] >= 0) | 2 * (x[2] is not None and x[2] <= 0)
        if name in ("norm", "absolute", "root", "exponential", "power of two") or name == "multiply" and len(set(self.operands(n))) == 1:
            return 1
        if name in ("multiply", "divide"):
            return product(*s)
        if name in ("add", "subtract"):
            a, b = self.operands(n)
            order = {(x, y) for x, y, _ in self.less} if name == "subtract" else ()
            return ((b, a) in order) | 2 * ((a, b) in order) | self.terms(n)[0] & self.terms(n)[1]
        return TURNED[s[0]] if name == "negative" else s[0] if name in ("exponential minus one", "arc sine", "angle") else 0


def times(x: list, y: list) -> tuple:
    return tuple(a * b % PRIME for a, b in zip(x, y))


def product(x: int, y: int) -> int:
    """The sign of a product."""
    return bool(x & y) | 2 * bool(TURNED[x] & y)


def between(x: list, y: list, bounded: tuple) -> tuple | None:
    """The bounds of x/y if it is (a + b z) / (c + d z), with small fractions, for a number z within bounds."""
    z, low, high, _ = bounded
    rows = [(q, t * q, -p, -t * p) for p, q, t in zip(x, y, z)]
    found = []
    for j in range(4):
        (a, b, c), (d, e, f), (g, h, i) = ([row[m] for m in range(4) if m != j] for row in rows[:3])
        found.append((-1) ** j * (a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)) % PRIME)
    if any(sum(map(int.__mul__, row, found)) % PRIME for row in rows) or not (unit := found[2] or found[3]):
        return None
    if None in (small := [fraction(x * inverse(unit) % PRIME) for x in found]):
        return None
    ends = []
    for end, infinity in ((low, -1), (high, 1)):
        k, l = (u + v * end if end is not None else v * infinity if small[1] or small[3] else u for u, v in (small[:2], small[2:]))
        ends.append((k, l))
    if ends[0][1] * ends[1][1] <= 0:
        return None
    return tuple(sorted(Fraction(k) / l for k, l in ends))


class Parts:
    """The parts of a result on a way, up to factors."""

    def __init__(self, way: Way, result: int):
        self.way, self.known, self.uses = way, defaultdict(list), defaultdict(list)
        self.left, self.room = defaultdict(Fraction), defaultdict(Fraction)
        result = way.resolved(result)
        self.uses[result].append((1,) * POINTS)
        for n in reversed(way.needed([result])):
            by = self.derivative(n, 0)
            for k, m in enumerate(way.operands(n)):
                slope = times(by, [d[k] for d in way.slopes[n]])
                self.uses[m] += [slope] * any(slope)
            for factor, atom in self.atom(times(way.value[n], by)):
                self.left[atom] += way.rho(n) * abs(factor)
                self.room[atom] += abs(factor) * ((way.ops[n][0] == "input") + (n == result))

    def derivative(self, n: int, form: int) -> tuple:
        """With respect to a number, or to one of its uses."""
        demand(0 <= form <= len(self.uses[n]), f"{n} has no derivative {form}")
        return self.uses[n][form - 1] if form else tuple(sum(use) % PRIME for use in zip(*self.uses[n])) or (0,) * POINTS

    def atom(self, part: tuple) -> list[tuple]:
        """A factor and what it is a multiple of; nothing if the part is 0."""
        if not part[0]:
            return []
        per_first = inverse(part[0])
        known = self.known[times(part[1:], [per_first] * POINTS)]
        for first in known:
            if (factor := fraction(part[0] * inverse(first) % PRIME)) is not None:
                return [(factor, first)]
        known.append(part[0])
        return [(Fraction(1), part[0])]

    def equation(self, n: int, form: int | None) -> list[tuple]:
        """The parts of an operation, those of the result with the opposite sign first, which add up to 0."""
        way, by = self.way, self.derivative(n, form or 0)
        whole = times(way.value[n], [-x for x in by])
        if form is None:
            return [whole] + [times(way.value[n], use) for use in self.uses[n]]
        demand(way.ops[n][0] in FIRST, f"{n} is no sum")
        x = way.operands(n)
        return [whole] + [times(times(by, [d[k] for d in way.slopes[n]]), way.value[x[k]]) for k in FIRST[way.ops[n][0]] if k < len(x)]

    def use(self, rule: str, n: int, *places, amount: Fraction) -> None:
        """Moves what a rule moves."""
        way, (factors, right) = self.way, (defaultdict(Fraction), [])
        if rule == "angle":
            demand(way.ops[n][0] == "angle", f"{n} is no angle")
            by = self.derivative(n, 0)
            left = self.atom(times(times(by, [d[0] for d in way.slopes[n]]), way.value[way.operands(n)[0]]))
            right = self.atom(times(way.value[n], by))
        else:
            parts = self.equation(n, None if rule == "uses" else places[0])
            terms = [self.atom(part) for part in parts]
            if rule in ("uses", "sum"):
                for factor, atom in sum(terms, []):
                    factors[atom] += factor
                atom = terms[places[-1]][0][1]
                left, right = [(factors.pop(atom), atom)], [(factor, atom) for atom, factor in factors.items()]
            elif rule == "parts":
                signs = way.terms(n)
                demand(way.ops[n][0] == "norm" or signs and signs[0] & signs[1], f"{n} may cancel")
                left, right = sum(terms[1:], []), terms[0]
            else:
                _, k, other, by = places
                ratios = [between(parts[k], parts[other], it) for it in self.way.bounded if it[3] == by]
                most = [max(high, -low) for low, high in filter(None, ratios)]
                demand(rule == "range" and most, f"the bounds of {by} say nothing of {n}")
                left, right = terms[k], [(min(most) * f, atom) for f, atom in terms[other]]
        for factor, atom in left:
            self.left[atom] -= abs(factor) * amount
        for factor, atom in right:
            self.left[atom] += abs(factor) * amount

    def bound(self) -> Fraction:
        demand(all(self.room[atom] for atom, left in self.left.items() if left > 0), "something is left that no input carries")
        return max((left / self.room[atom] for atom, left in self.left.items() if left > 0), default=Fraction(0))


def check(certificates: str, graph: bytes) -> tuple[int, int]:
    """The numbers of certificates and of open results in a file; Refused if one does not hold."""
    head, *lines = map(json.loads, certificates.splitlines())
    demand(head["graph"] == hashlib.sha256(graph).hexdigest(), "it is about another graph")
    *ops, value, jacobian = map(json.loads, graph.decode().splitlines())
    by_result, by_way = defaultdict(list), defaultdict(list)
    for line in lines:
        by_result[line["result"]].append(line)
        by_way[tuple(map(tuple, line.get("way", ())))].append(line)
    demand(set(by_result) == set(value[1:] + jacobian[1:]), "something is said of other results, or not of all")
    for result, of in by_result.items():
        demand(are_all([dict(line["way"]) for line in of]) if "way" in of[0] else len(of) == 1, f"{result}: not on every way")
    for answers, of in by_way.items():
        of = [line for line in of if "open" not in line]
        way = Way(ops, dict(answers), [line["result"] for line in of])
        for line in of:
            parts = Parts(way, line["result"])
            for *step, amount in line["steps"]:
                demand(Fraction(amount) >= 0, "a negative amount")
                parts.use(*step, amount=Fraction(amount))
            demand(parts.bound() <= Fraction(line["bound"]), f"{line['result']}: {parts.bound()} is proved, not {line['bound']}")
    return sum("steps" in line for line in lines), sum("open" in line for line in lines)


def main(graphs: Path, bounds: Path) -> int:
    files, proved, failed = sorted(bounds.glob("*.jsonl")), 0, 0
    for file in files:
        try:
            proved += check(file.read_text(), (graphs / file.name).read_bytes())[0]
        except (Refused, KeyError, IndexError, TypeError, ValueError, OSError) as error:
            failed += 1
            print(f"{file.stem}: {error}")
    print(f"{len(files)} formulas, {proved} certificates add up, {failed} formulas off")
    return 1 if failed or not files else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), Path(*sys.argv[2:]) if sys.argv[2:] else Path(__file__).parents[2] / "golden/bounds"))
