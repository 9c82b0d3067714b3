#!/usr/bin/env python3
"""Check proved bounds of rounding errors: that the steps of every certificate add up to its bound. Standard library alone.

  cargo xtask prove --graphs target/graphs
  python check_bounds.py target/graphs [FOLDER]     the certificates of ../../golden/bounds, or of another folder

Parts are compared modulo a prime, at points where inputs look random. Signs are sets: 1 is not below 0, 2 is not above 0.
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

PRIME, POINTS, TURNED = 2**127 - 1, range(8), (0, 2, 1, 3)
ROUNDINGS = {"add": 1, "subtract": 1, "multiply": 1, "divide": 1, "root": 1, "multiply and add": 1, "exact sum": 2, "sine": 2, "cosine": 2,
             "exponential": 2, "exponential minus one": 2, "arc sine": Fraction(13, 5), "angle": 4, "number": 1}  # fmt: skip
FOLDED = {"add": Fraction.__add__, "subtract": Fraction.__sub__, "multiply": Fraction.__mul__, "divide": Fraction.__truediv__,
          "negative": Fraction.__neg__, "absolute": Fraction.__abs__}  # fmt: skip
KEEPS_ZERO = ("add", "subtract", "multiply", "negative", "absolute", "maximum", "norm")


class Refused(Exception):
    """A certificate does not prove what it says."""


def demand(holds, why: str):
    if not holds:
        raise Refused(why)


def bits(x: Fraction) -> float:
    """The significant bits of a double; infinite for other numbers."""
    n = abs(x.numerator)
    return (n // (n & -n)).bit_length() if n and x.denominator & (x.denominator - 1) == 0 else math.inf if n else 0


def inverse(x: int) -> int:
    return pow(x, -1, PRIME)


def modular(x: Fraction) -> int:
    return x.numerator * inverse(x.denominator)


def fraction(x: int):
    """The quotient of numbers below 2^40 that this is modulo the prime, if it is one."""
    (a, b), (c, d) = (PRIME, 0), (x % PRIME, 1)
    while c >> 40:
        (a, b), (c, d) = (c, d), (a % c, b - a // c * d)
    return Fraction(c, d) if 0 < abs(d) < 2**40 else None


def times(*factors: list) -> tuple:
    return tuple(math.prod(at_point) % PRIME for at_point in zip(*factors))


def are_all(ways: list, possible=lambda given: True, given: dict = {}) -> bool:
    """Whether one of these ways is taken however comparisons come out, unless they contradict each other."""
    if not ways or not all(ways):
        return bool(ways) or not possible(given)
    at = next(iter(ways[0]))
    consistent = lambda it: [{k: v for k, v in way.items() if k != at} for way in ways if way.get(at, it) == it]
    return all(are_all(consistent(it), possible, {**given, at: it}) for it in (False, True))


def computed(name: str, x: list, t: int, slope: int) -> tuple:
    """A number modulo the prime, and its derivatives with respect to its operands; those that are not known are t and the slope."""
    if name in ("add", "subtract"):
        return x[0] + x[1] * (sign := 1 if name == "add" else -1), [1, sign]
    if name in ("multiply", "multiply and add", "exact sum"):
        products = [x[k : k + 4] for k in range(0, len(x), 4)] if name == "exact sum" else [x[:2], x[2:]][: len(x) - 1]
        return sum(map(math.prod, products)), [math.prod(p[:k] + p[k + 1 :]) for p in products for k in range(len(p))]
    if name in ("negative", "absolute"):  # A sign may be any number.
        return x[0] * (sign := -1 if name == "negative" else t), [sign]
    if name == "divide":
        return x[0] * inverse(x[1]), [inverse(x[1]), -x[0] * inverse(x[1]) ** 2]
    if name in ("root", "norm"):
        square = x[0] if name == "root" else sum(y * y for y in x)
        root = pow(square, (PRIME + 1) // 4, PRIME) * (-1) ** (t & 1)
        if (root * root - square) % PRIME:
            raise ArithmeticError("no root at this point")
        return root, [inverse(2 * root)] if name == "root" else [y * inverse(root) for y in x]
    if name == "angle":
        return t, [y * inverse(x[0] ** 2 + x[1] ** 2) for y in (x[1], -x[0])]
    return t, [{"exponential": t, "exponential minus one": t + 1}.get(name, slope)]


class Branches:
    """A graph, and how some comparisons come out."""

    def __init__(self, ops: list, answers: dict):
        self.ops, self.answers = ops, answers

    def resolved(self, n: int) -> int:
        while self.ops[n][0] in ("select", "maximum"):
            *condition, yes, no = self.ops[n][1:]
            at = self.resolved(condition[0]) if condition else n
            demand(at in self.answers, f"the way does not say how {at} comes out")
            n = yes if self.answers[at] else no
        return n

    def literal(self, n: int):
        return struct.unpack(">d", bytes.fromhex(self.ops[n][1]))[0] if self.ops[n][0] == "number" else None

    def vanishing(self, n: int) -> set:
        """The numbers that are 0 if this one is; if it is chosen by a comparison that is not known, on either side."""
        try:
            name, *x = self.ops[n := self.resolved(n)]
        except Refused:
            return set.intersection(*map(self.vanishing, self.ops[n][-2:]))
        x = x if name in ("norm", "negative", "absolute") else [x[1 - k] for k in (0, 1) if self.literal(x[k])] if name == "multiply" else []
        return {n}.union(*map(self.vanishing, x))

    def possible(self) -> bool:
        """Whether no number that is not 0 vanishes with others. What is below all normal numbers is 0, and nothing is infinite."""
        zeros, others = set(), []
        for name, x, y, answer in ((*self.ops[by], answer) for by, answer in self.answers.items() if self.ops[by][0] != "maximum"):
            low, high = self.literal(x), self.literal(y)
            if name == "equal" and high == 0:
                zeros, others = (zeros | self.vanishing(x), others) if answer else (zeros, [*others, x])
            elif name == "less" and high == math.inf and not answer:
                return False
            elif name != "equal" and answer and low and low > 0:
                others.append(y)
            elif name == "less or equal" and not answer and low == sys.float_info.min:
                zeros |= self.vanishing(y)
        known = dict.fromkeys(zeros, True)
        return not any(self.vanishes(x, known) for x in others)

    def vanishes(self, n: int, known: dict) -> bool:
        """Whether a number is 0 since others are."""
        name, *x = self.ops[n := self.same(n)]
        if n not in known:
            some = any if name == "multiply" else all
            x = {"divide": x[:1], "select": x[1:]}.get(name, x if name in KEEPS_ZERO else [])
            known[n] = self.literal(n) == 0 or bool(x) and some([self.vanishes(k, known) for k in x])
        return known[n]

    def same(self, n: int) -> int:
        try:
            return self.resolved(n)
        except Refused:
            return n


class Way(Branches):
    """The numbers of a way through the branches, at points, and what is known of their signs."""

    def __init__(self, ops: list, answers: dict, results: list):
        super().__init__(ops, answers)
        self.exact, self.less, self.sign = {}, [], defaultdict(int)
        for by, answer in answers.items():
            name, x, y = ops[by]
            try:
                self.needed(pair := [*map(self.resolved, (y, x) if name == "maximum" else (x, y))])
            except Refused:  # It depends on comparisons that are not on this way.
                continue
            orders = (answer, answer) if name == "equal" else (answer, not answer)
            self.less += [(*order, by) for holds, order in zip(orders, (pair, pair[::-1])) if holds]
        self.inputs = {op[1]: n for n, op in enumerate(ops) if op[0] == "input"}
        self.nodes = self.needed([*map(self.resolved, results), *self.inputs.values(), *(x for pair in self.less for x in pair[:2])])
        points = [self.point(k) for k in POINTS]
        self.value, self.slopes = ({n: [point[of][n] for point in points] for n in self.nodes} for of in (0, 1))
        learned = {0: 0}
        while learned:
            for n in self.nodes * 2:
                self.sign[n] |= self.sign_of(n)
            self.bounded = [*self.bounds()]
            learned = {n: sign for n in self.nodes if not self.sign[n] and (sign := self.sign_by_ratio(n))}
            self.sign.update(learned)

    def operands(self, n: int) -> list:
        name, *operands = self.ops[n]
        return [] if name in ("input", "number", "power of two", "nearest integer") else [*map(self.resolved, operands)]

    def needed(self, open_: list) -> list:
        found, open_ = set(), [*open_]
        while open_:
            found.add(n := open_.pop())
            open_ += [x for x in self.operands(n) if x not in found]
        for n in sorted(found):
            self.exact[n] = self.constant(n)
        return sorted(found)

    def constant(self, n: int):
        """A literal of at most twenty bits, and what is made of such ones without rounding; others may stand for numbers without end."""
        name, known = self.ops[n][0], [self.exact[x] for x in self.operands(n)]
        if name == "number":
            x = self.literal(n)
            return Fraction(x) if math.isfinite(x) and bits(Fraction(x)) <= 20 else None
        if name not in FOLDED or None in known or name == "divide" and not known[1]:
            return None
        return value if bits(value := FOLDED[name](*known)) <= 53 else None

    def scales(self, n: int) -> bool:
        """Whether it is a power of two."""
        if self.ops[n][0] in ("negative", "absolute", "multiply", "divide"):
            return all(map(self.scales, self.operands(n)))
        return self.ops[n][0] == "power of two" or self.exact[n] is not None and bits(self.exact[n]) == 1

    def roundings(self, n: int):
        name, x = self.ops[n][0], self.operands(n)
        zero, scales = [self.exact[k] == 0 for k in x], [self.scales(k) for k in x]
        exact = {"add": zero, "subtract": zero, "multiply": zero + scales, "divide": zero[:1] + scales[1:]}.get(name, [])
        return 0 if self.exact[n] is not None or any(exact) else Fraction(len(x) + 2, 2) if name == "norm" else ROUNDINGS.get(name, 0)

    def point(self, k: int) -> tuple:
        """The numbers at a point at which all roots exist, and their derivatives."""
        for trial in range(4096):
            value, slopes = {}, {}
            try:
                for n in self.nodes:
                    rng = random.Random(f"{k} {trial} {n}")
                    t, slope = rng.randrange(1, PRIME), rng.randrange(1, PRIME)
                    t, slopes[n] = computed(self.ops[n][0], [value[x] for x in self.operands(n)], t, slope)
                    value[n] = (t if self.exact[n] is None else modular(self.exact[n])) % PRIME
                return value, slopes
            except ArithmeticError:
                continue
        raise Refused("no point has all roots")

    def agree(self, n: int) -> int:
        """The sign that the terms of a sum of two, or of a norm, have in common."""
        name, s = self.ops[n][0], [self.sign[x] for x in self.operands(n)]
        return 1 if name == "norm" else s[0] & s[1] if name == "add" else s[0] & TURNED[s[1]] if name == "subtract" else 0

    def sign_of(self, n: int) -> int:
        name, *data = self.ops[n]
        x = self.operands(n)
        s = [self.sign[k] for k in x]
        known = self.agree(n)
        for less, more, _ in self.less:
            known |= (self.sign[less] & 1 if n == more else 0) | (self.sign[more] & 2 if n == less else 0)
            if name == "subtract" and set(x) == {less, more}:
                known |= 1 if x[0] == more else 2
        if name == "number":
            value = self.literal(n)
            return known | (value >= 0) | 2 * (value <= 0)
        if name == "input":
            return known | (data[1] is not None and data[1] >= 0) | 2 * (data[2] is not None and data[2] <= 0)
        if name in ("absolute", "root", "exponential", "power of two") or name == "multiply" and x[0] == x[1]:
            return known | 1
        if name in ("multiply", "divide"):
            return known | product(*s)
        return known | (TURNED[s[0]] if name == "negative" else s[0] if name in ("exponential minus one", "arc sine", "angle") else 0)

    def sign_by_ratio(self, n: int) -> int:
        """The sign of a sum of which the ratio to one of its terms has a sign."""
        for x in self.operands(n) if self.ops[n][0] in ("add", "subtract") else []:
            for *bounds, _ in self.bounded if self.sign[x] else []:
                low, high = between(self.value[n], self.value[x], *bounds) or (-1, 1)
                if low >= 0 or high <= 0:
                    return self.sign[x] if low >= 0 else TURNED[self.sign[x]]
        return 0

    def bounds(self):
        """The numbers that domains and comparisons bound: at the points, both ends, and what bounds them."""
        ends = {n: [[x] for x in self.ops[n][2:]] for n in self.nodes if self.ops[n][0] == "input"}
        for x, y, by in self.less:
            ends.setdefault(y, [[], []])[0].append(self.exact[x])
            ends.setdefault(x, [[], []])[1].append(self.exact[y])
            for x, y in [(x, y)] * (self.sign[x] & 1) + [(y, x)] * (self.sign[y] >> 1):
                if all(self.value[y := self.bare(y)]):
                    sign = product(self.sign[x := self.bare(x)], self.sign[y])
                    yield times(self.value[x], map(inverse, self.value[y])), (sign & 1) - 1, 1 - sign // 2, by
        for n, both in ends.items():
            low, high = ([Fraction(x) for x in some if x is not None] for some in both)
            if self.exact[n] is None and low + high:
                yield self.value[n], max(low, default=None), min(high, default=None), n

    def bare(self, n: int) -> int:
        return self.bare(self.operands(n)[0]) if self.ops[n][0] in ("absolute", "negative") else n


def product(x: int, y: int) -> int:
    """The sign of a product."""
    return bool(x & y) | 2 * bool(TURNED[x] & y)


def between(p: tuple, q: tuple, z: tuple, low, high):
    """The bounds of p/q if it is (a + b z) / (c + d z) with small fractions and z is between its ends."""
    rows, found = [(y, t * y, -x, -t * x) for x, y, t in zip(p, q, z)], []
    for j in range(4):
        (a, b, c), (d, e, f), (g, h, i) = (row[:j] + row[j + 1 :] for row in rows[:3])
        found.append((-1) ** j * (a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)) % PRIME)
    if any(sum(map(int.__mul__, row, found)) % PRIME for row in rows) or not (unit := found[2] or found[3]):
        return None
    if None in (small := [fraction(x * inverse(unit)) for x in found]):
        return None
    a, b, c, d = small
    ends = []
    for end, infinity in ((low, -1), (high, 1)):
        finite = end is not None or not (b or d)
        ends.append((a + b * (end or 0), c + d * (end or 0)) if finite else (b * infinity, d * infinity))
    (a, c), (b, d) = ends
    return sorted((Fraction(a) / c, Fraction(b) / d)) if c * d > 0 else None


class Parts:
    """The parts of a result on a way: what is loaded on them, and what they may carry for each unit of the bound."""

    def __init__(self, way: Way, result: int, beside=None, fields: list = []):
        self.way, self.firsts, self.sizes = way, defaultdict(list), {}
        self.load, self.room = defaultdict(Fraction), defaultdict(Fraction)
        self.forms = self.derivatives(result := way.resolved(result))
        for n, forms in self.forms.items():
            for factor, atom in self.atom(self.part(n, 0, 0)):
                self.load[atom] += way.roundings(n) * abs(factor)
                self.room[atom] += abs(factor) * ((way.ops[n][0] == "input") + (n == result)) * (beside is None)
        for weight, other in enumerate([] if beside is None else [result, *map(way.resolved, beside)]):
            by = self.derivatives(other)
            self.size(other, [1] * len(POINTS), (weight,))
            for field in fields:
                for row in (inputs := [way.inputs[k] for k in field if k in way.inputs]):
                    for column in inputs:
                        self.size(column, by[row][0] if row in by else [0] * len(POINTS), (weight, row), (weight, None, column))

    def derivatives(self, result: int) -> dict:
        """Those of a result with respect to every number, in all and, where there are several, for each use."""
        uses, forms = defaultdict(list, {result: [[1] * len(POINTS)]}), {}
        for n in reversed(self.way.needed([result])):
            total = [sum(at_point) % PRIME for at_point in zip(*uses[n])] or [0] * len(POINTS)
            forms[n] = [total, *uses[n]] if len(uses[n]) > 1 else [total]
            for k, x in enumerate(self.way.operands(n)):
                if any(use := times(total, [slopes[k] for slopes in self.way.slopes[n]])):
                    uses[x].append(use)
        return forms

    def size(self, n: int, by: list, *limits: tuple) -> None:
        """A part of the denominator of a normwise bound: what its row and its column carry, each counts once for each weight."""
        self.forms.setdefault(n, [[0] * len(POINTS)]).append(by)
        self.sizes[n, len(self.forms[n]) - 1] = limits
        self.room.update(dict.fromkeys(limits, Fraction(1)))

    def part(self, n: int, form: int, place: int) -> tuple:
        """A number times the derivative with respect to it; or of an operand, as far as this operation uses it."""
        demand(min(n, form, place) >= 0 and form < len(self.forms[n]), f"{n} has no derivative {form}")
        if place == 0:
            return times(self.way.value[n], self.forms[n][form])
        slope = [slopes[place - 1] for slopes in self.way.slopes[n]]
        return times(self.way.value[self.way.operands(n)[place - 1]], self.forms[n][form], slope)

    def atom(self, part: tuple) -> list:
        """A factor, and what the part is a multiple of; nothing if the part is 0."""
        if not part[0]:
            return []
        direction = times(part, [inverse(part[0])] * len(POINTS))
        for first in self.firsts[direction]:
            if (factor := fraction(part[0] * inverse(first))) is not None:
                return [(factor, (direction, first))]
        self.firsts[direction].append(part[0])
        return [(Fraction(1), (direction, part[0]))]

    def use(self, rule: str, amount: Fraction, *what) -> None:
        """Moves the load that a step moves."""
        left, right = defaultdict(Fraction), defaultdict(Fraction)
        if rule == "sum":
            terms = [(Fraction(factor), self.part(*part)) for factor, *part in what]
            demand(not any(sum(modular(factor) * part[k] for factor, part in terms) % PRIME for k in POINTS), "no sum of 0")
            for factor, part in terms:
                for ratio, atom in self.atom(part):
                    right[atom] += factor * ratio
            left = {atom: right.pop(atom) for _, atom in self.atom(terms[0][1])}
        elif rule == "parts":
            demand(self.way.agree(what[0]), f"{what[0]} may cancel")
            for k in range(len(self.way.operands(what[0]))):
                for factor, atom in self.atom(self.part(*what, k + 1)):
                    left[atom] += abs(factor)
            right |= {atom: factor for factor, atom in self.atom(self.part(*what, 0))}
        elif rule == "beside":
            demand((what := tuple(what)) in self.sizes, f"{what} is no part of the denominator")
            left = {atom: factor for factor, atom in self.atom(self.part(*what, 0))}
            right |= dict.fromkeys(self.sizes[what], Fraction(1))
        else:
            demand(rule == "range", f"no rule is called {rule}")
            first, second = (self.part(*part) for part in what[:2])
            ratios = [between(first, second, *bounds) for *bounds, by in self.way.bounded if by == what[2]]
            demand(ratios := [max(high, -low) for low, high in filter(None, ratios)], f"the bounds of {what[2]} say nothing of this ratio")
            left = {atom: factor for factor, atom in self.atom(first)}
            right |= {atom: factor * min(ratios) for factor, atom in self.atom(second)}
        for atoms, direction in ((left, -1), (right, 1)):
            for atom, factor in atoms.items():
                self.load[atom] += direction * amount * abs(factor)

    def bound(self) -> Fraction:
        rest = {atom: load for atom, load in self.load.items() if load > 0}
        demand(all(self.room[atom] for atom in rest), "something is left that no input carries")
        bounds = defaultdict(Fraction)
        for atom, load in rest.items():
            weight = atom[0] if self.sizes else 0
            bounds[weight] = max(bounds[weight], load / self.room[atom])
        return sum(bounds.values(), Fraction(0))


def groups(value: list, jacobian: list, inputs: list, outputs: list) -> dict:
    """The results beside each: the other components of an output or, of a derivative, of the same input unless that is a scalar."""
    found, count = {}, sum(map(len, inputs))
    for field in outputs:
        for k in field:
            found.setdefault(value[k], []).append({value[other] for other in field})
            for by in inputs if jacobian else []:
                for i in by:
                    others = [(k, other) for other in by] if len(by) > 1 else [(other, i) for other in field]
                    found.setdefault(jacobian[k * count + i], []).append({jacobian[other * count + i] for other, i in others})
    return {result: set.intersection(*all_) for result, all_ in found.items()}


def check(certificates: str, graph: bytes, shapes: tuple = ((), ())) -> tuple:
    """The numbers of certificates and of open results in a file; Refused if one does not hold."""
    head, *lines = map(json.loads, certificates.splitlines())
    demand(head["graph"] == hashlib.sha256(graph).hexdigest(), "it is about another graph")
    *ops, value, jacobian = map(json.loads, graph.decode().splitlines())
    fields = [[range(sum(of[:k]), sum(of[: k + 1])) for k in range(len(of))] for of in shapes]
    beside, by_result, by_way = groups(value[1:], jacobian[1:], *fields), defaultdict(list), defaultdict(list)
    for line in lines:
        by_result[line["result"]].append(line)
        by_way[tuple(map(tuple, line.get("way", ())))].append(line)
    demand(set(by_result) == set(value[1:] + jacobian[1:]), "something is said of other results, or not of all")
    for result, of in by_result.items():
        possible = lambda given: Branches(ops, given).possible()
        ways = [dict(line.get("way", ())) for line in of]
        demand(are_all(ways, possible) if "way" in of[0] else len(of) == 1, f"{result}: not on every way")
        demand(all({*line.get("beside", ())} <= beside.get(result, set()) for line in of), f"{result}: something is not beside it")
    for answers, of in by_way.items():
        of = [line for line in of if "open" not in line]
        way = Way(ops, dict(answers), [n for line in of for n in (line["result"], *line.get("beside", ()))])
        for line in of:
            parts = Parts(way, line["result"], line.get("beside"), fields[0])
            for rule, amount, *what in line["steps"]:
                demand((amount := Fraction(amount)) >= 0, "a negative amount")
                parts.use(rule, amount, *what)
            demand(parts.bound() <= Fraction(line["bound"]), f"{line['result']}: {parts.bound()} is proved, not {line['bound']}")
    for name, results in (("value", value[1:]), ("jacobian", jacobian[1:])):
        of = [by_result[result] for result in results]
        bounds = [max(Fraction(line["bound"]) for line in lines) for lines in of if "open" not in lines[0]]
        said = (sum(map(bool, bounds)), Fraction(max(bounds, default=0)), len(of) - bounds.count(0))
        demand(said == (head[name]["proved"], Fraction(head[name]["bound"]), head[name]["entries"]), f"the head says else of the {name}")
    return sum("steps" in line for line in lines), sum("open" in line for line in lines)


def shapes(golden: Path) -> tuple:
    """The numbers of components of the inputs and of the outputs of a formula."""
    formula = json.loads(golden.read_text())
    return tuple([math.prod(field["shape"]) for field in formula[of]] for of in ("inputs", "outputs"))


def main(graphs: Path, bounds: Path) -> int:
    files, proved, failed = sorted(bounds.glob("*.jsonl")), 0, 0
    for file in files:
        try:
            proved += check(file.read_text(), (graphs / file.name).read_bytes(), shapes(bounds.parent / f"{file.stem}.json"))[0]
        except (Refused, LookupError, TypeError, ValueError, ArithmeticError, OSError) as error:
            failed += 1
            print(f"{file.stem}: {error!r}")
    print(f"{len(files)} formulas, {proved} certificates add up, {failed} formulas off")
    return 1 if failed or not files else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), Path(*sys.argv[2:]) if sys.argv[2:] else Path(__file__).parents[2] / "golden/bounds"))
