"""Prints formulas and elements as functions over arrays of any library that has the Array API, from the operations that are recorded.

Both sides of a choice are computed and one of them is taken. What is not taken must be finite, or the framework that differentiates
has 0 times infinity: so every divisor, root and the like is taken from a safe number where nothing needs it.
"""

import json
import keyword
import pathlib
import struct
import sys
from functools import cached_property

FOLDER = pathlib.Path(__file__).parent / "python" / "jointproof" / "arrays"
WIDTH = 120
#: Up to this many characters, what is used once stands where it is used.
SHORT = 60

INFIX = {"add": "+", "subtract": "-", "multiply": "*", "divide": "/", "less": "<", "less or equal": "<=", "equal": "=="}
COMPARED = {"less", "less or equal", "equal"}
CALLED = {
    "absolute": "abs",
    "root": "sqrt",
    "sine": "sin",
    "cosine": "cos",
    "arc sine": "asin",
    "exponential": "exp",
    "exponential minus one": "expm1",
    "nearest integer": "nearest_integer",
    "angle": "atan2",
    "maximum": "maximum",
    "multiply and add": "multiply_add",
    "norm": "norm",
    "sign": "sign",
}
#: What an operation is not defined for, by its operands: numbers that are safe.
SAFE = {"divide": (None, 1.0), "root": (1.0,), "arc sine": (0.0,), "exponential": (0.0,), "exponential minus one": (0.0,), "angle": (0.0, 1.0)}
#: The operands through which what is infinite may come out finite, and operations of which no result is infinite.
HIDING = {"divide": [1], "exponential": [0], "exponential minus one": [0], "angle": [0, 1], "maximum": [0, 1], "sign": [0]}
BOUNDED = {"number", "sine", "cosine", "arc sine", "exponential", "exponential minus one", "angle", "sign", *COMPARED}
#: What a compiler does not do twice: it would keep what an input is replaced by in memory.
COSTLY = {"divide", "root", "norm", "sine", "cosine", "arc sine", "exponential", "exponential minus one", "angle"}
ALWAYS, NEVER = ("always",), ("never",)


class Missing(Exception):
    """Why there is no program."""


class Program:
    """The operations of a formula, by places, and where its inputs are."""

    def __init__(self, program, names):
        if "missing" in program:
            raise Missing(program["missing"])
        *lines, (_, *self.value), (_, *self.jacobian) = program["lines"]
        self.ops = [tuple(line) for line in lines]
        self.names = names
        self.conditions, self.refusal = program["conditions"], program["refusal"]
        searches = {name for name, *_ in self.ops if name.startswith("search ")}
        if searches:
            raise Missing("it looks for the closest point of a curve, in as many steps as that takes; frameworks for arrays trace a fixed number")
        self._signs()

    def _signs(self):
        """Writes what is 1 for x > 0, −1 for x < 0 and 0 otherwise as the sign that it is."""
        for place, (name, *operands) in enumerate(self.ops):
            if name == "select" and self.number(operands[1]) == 1.0 and self._is_less(operands[0], 0):
                x = self.ops[operands[0]][2]
                other, *sides = self.ops[operands[2]]
                if other == "select" and [self.number(k) for k in sides[1:]] == [-1.0, 0.0] and self._is_less(sides[0], 1):
                    if self.ops[sides[0]][1] == x:
                        self.ops[place] = ("sign", x)

    def _is_less(self, place, zero):
        """Whether this compares a number with 0, which is the first or the second one."""
        name, *numbers = self.ops[place]
        return name == "less" and self.number(numbers[zero]) == 0.0

    def number(self, place):
        name, *bits = self.ops[place]
        return struct.unpack(">d", bytes.fromhex(bits[0]))[0] if name == "number" else None

    def operands(self, place):
        name, *operands = self.ops[place]
        return [] if name in ("input", "number") else operands

    def is_answer(self, place):
        name, *operands = self.ops[place]
        return name in COMPARED or name == "select" and self.is_answer(operands[1])

    @cached_property
    def accepting(self):
        """Whether all inputs together are allowed, as a tree of the comparisons on which that depends: True, False, or a comparison, then
        what holds if it does and if it does not. What overflows is not asked: a result is NaN then."""

        def tree(place, holds):
            """Of the number at this place, or of a condition; some comparisons are known."""
            name, *operands = self.ops[place]
            if name == "number":
                return self.number(place) == 0.0
            if name == "select":
                condition, *sides = operands
                return graft(tree(condition, holds), *sides, holds)
            if name not in COMPARED:
                raise Missing(f"what it refuses is no choice among numbers but the operation {name}")
            if self._is_overflow(place):
                return True
            return holds.get(place, (place, True, False))

        def graft(condition, yes, no, holds):
            if isinstance(condition, bool):
                return tree(yes if condition else no, holds)
            place, *sides = condition
            sides = [graft(side, yes, no, holds | {place: known}) for side, known in zip(sides, (True, False))]
            return sides[0] if sides[0] == sides[1] else (place, *sides)

        return True if self.refusal is None else tree(self.refusal, {})

    def _is_overflow(self, place):
        """Whether this asks if a number is finite."""
        name, *operands = self.ops[place]
        return name == "less or equal" and self.ops[operands[0]][0] == "absolute" and self.number(operands[1]) == sys.float_info.max

    def body(self, results):
        return Body(self, results)

    @cached_property
    def reach(self):
        """For every result the inputs on which it depends, and those of which NaN surely arrives: not by a condition, nor on one side."""
        depends, arrives = [], []
        for place, (name, *operands) in enumerate(self.ops):
            if name == "input":
                depends.append({operands[0]})
                arrives.append({operands[0]})
                continue
            operands = self.operands(place)
            depends.append(set().union(*(depends[k] for k in operands)))
            if name == "select":
                arrives.append(arrives[operands[1]] & arrives[operands[2]])
            else:
                arrives.append(set() if name in COMPARED else set().union(*(arrives[k] for k in operands)))
        return depends, arrives


class Body:
    """The lines that compute some results."""

    def __init__(self, program, results):
        """What is required of all inputs together is computed with the results, if these are numbers that are returned. What is infinite
        is made NaN in inputs, or in results and wherever it would be hidden from them."""
        self.program, self.places = program, list(results)
        self.is_value = self.places == program.value
        is_asked = self.places == [program.refusal]
        accepting = True if is_asked else program.accepting
        results = [*results, *comparisons(accepting)]
        needed = set()
        todo = list(results)
        while todo:
            place = todo.pop()
            if place not in needed:
                needed.add(place)
                todo.extend(program.operands(place))
        self.order = sorted(needed)
        self.uses = dict.fromkeys(self.order, 0)
        for place in [*results, *(operand for place in self.order for operand in program.operands(place))]:
            self.uses[place] += 1
        self._find_where_needed()
        self._find_alternatives()
        self.texts, self.lines, self.safe = {}, [], {}
        self.added = self._added()
        self.guards = set() if is_asked else self._guards()
        for place in self.order:
            name, *operands = program.ops[place]
            if name == "input":
                self.texts[place] = program.names[operands[0]]
                if not is_asked:
                    self._allow(place, program.conditions[operands[0]])
        self.results = [bare(self.text(place)) for place in self.places]
        self.refuses = accepting is not True
        if self.refuses:
            self.lines.append(f"refused = lib.constants({bare(self._accepted(accepting))}, 0.0, lib.nan)")

    def _accepted(self, tree):
        """A tree of comparisons as a condition."""
        place, yes, no = tree
        condition = self.text(place)
        if yes is True:
            return condition if no is False else f"({condition} | {self._accepted(no)})"
        if yes is False:
            return f"~{condition}" if no is True else f"(~{condition} & {self._accepted(no)})"
        if no is False:
            return f"({condition} & {self._accepted(yes)})"
        if no is True:
            return f"(~{condition} | {self._accepted(yes)})"
        return f"(({condition} & {self._accepted(yes)}) | (~{condition} & {self._accepted(no)}))"

    def _allow(self, place, conditions):
        """Makes an input NaN that is not allowed."""
        text = self.texts[place]
        if conditions:
            holds = " & ".join(f"({text} {relation} {bound!r})" for relation, bound in conditions)
            allowed = f"t{len(self.lines) + 1}" if place in self.added else text
            self.lines.append(f"{allowed} = lib.where({bare(holds)}, {text}, lib.nan)")
            if place in self.added:
                self.added[place] = allowed
        if place in self.guards:
            self.lines.append(f"{text} = lib.finite({text})")

    def _added(self):
        """Inputs of which NaN is added to all results that depend on them: these are computed from what is given. Not where derivatives are
        those of the results."""
        if not self.is_value or not self.program.jacobian:
            return {}
        depends, arrives = self.program.reach
        inputs = {place: self.program.ops[place][1] for place in self.order if self.program.ops[place][0] == "input"}
        return {place: self.program.names[k] for place, k in inputs.items() if not any(k in arrives[result] for result in self.places)}

    def _guards(self):
        """Where what is infinite because an input is becomes NaN: in inputs, or in results and before it would be hidden from them."""
        at_inputs = not any(self.program.ops[place][0] in COSTLY for place in self.order)
        guards, arrives = set(), self.program.reach[1]
        hidden = {self.program.ops[place][1:][k] for place in self.order for k in HIDING.get(self.program.ops[place][0], ())}
        entries = set(self.places[len(self.program.value) :])
        # Inputs by which a result may be infinite, and those by which it is NaN if they are infinite.
        infinite, is_nan = {}, {}
        for place in self.order:
            name = self.program.ops[place][0]
            operands = self.program.operands(place)[name == "select" :]
            if name == "input":
                infinite[place] = set() if place in self.added else arrives[place]
            else:
                infinite[place] = set().union(*(infinite[k] for k in operands)) if name not in BOUNDED else set()
            if name == "select":
                is_nan[place] = set.intersection(*(is_nan[k] for k in operands))
            else:
                is_nan[place] = set().union(*(is_nan[k] for k in operands)) if name not in COMPARED else set()
            infinite[place] = infinite[place] - is_nan[place]
            shown = place in self.places and infinite[place] - self._lost(place)
            if shown or infinite[place] and (at_inputs or place in hidden or place in entries):
                guards.add(place)
                is_nan[place] = is_nan[place] | arrives[place]
                infinite[place] = set()
        # What overflows was to be refused.
        overflows = any(self.program._is_overflow(place) for place in range(len(self.program.ops)))
        return guards | set(self.places) if overflows else guards

    def _lost(self, place):
        """The inputs of which NaN is added to this result, since it does not arrive by itself."""
        depends, arrives = self.program.reach
        return depends[place] - arrives[place] if place in self.program.value else set()

    def values(self):
        """The results, to which what is NaN is added where it would not arrive."""
        given = dict(enumerate(self.program.names)) | {self.program.ops[place][1]: text for place, text in self.added.items()}
        added = [self._sum([given[k] for k in sorted(self._lost(place))]) for place in self.program.value]
        for text in dict.fromkeys(added):
            if " " in text and added.count(text) > 1:
                name = f"t{len(self.lines) + 1}"
                self.lines.append(f"{name} = {text}")
                added = [name if one == text else one for one in added]
        return [f"({text}) + {more}" if more else text for text, more in zip(self.results, added)]

    def _sum(self, lost):
        """What is NaN if one of these is, or if all inputs together are refused, and 0 otherwise."""
        total = " + ".join(lost)
        terms = [f"0.0 * ({total})" if lost[1:] else f"0.0 * {total}"] if lost else []
        return " + ".join([*terms, "refused"] if self.refuses else terms)

    def _find_where_needed(self):
        """When each result is needed: always, or if some of the conditions around it hold."""
        needed = {place: NEVER for place in self.order}
        for place in self.places:
            needed[place] = ALWAYS
        for place in reversed(self.order):
            name, *operands = self.program.ops[place]
            if name in ("input", "number"):
                continue
            if name == "select" and not self.program.is_answer(place):
                condition, yes, no = operands
                needed[condition] = either(needed[condition], needed[place])
                needed[yes] = either(needed[yes], both(needed[place], (condition, True)))
                needed[no] = either(needed[no], both(needed[place], (condition, False)))
            else:
                for operand in operands:
                    needed[operand] = either(needed[operand], needed[place])
        self.needed = needed

    def _find_alternatives(self):
        """Costly operations of which one is needed only where a condition holds and the other only where it does not: they are one."""
        self.alternatives, before = {}, {}
        for place in self.order:
            name = self.program.ops[place][0]
            if name not in COSTLY or name == "norm":
                continue
            for other in before.setdefault(name, []):
                opposite = {(condition, not holds) for condition, holds in surely(self.needed[other])}
                common = [one for one in opposite & surely(self.needed[place]) if one[0] < other]
                if common and not self._follows([place], other):
                    condition, holds = min(common)
                    yes, no = (place, other) if holds else (other, place)
                    self.alternatives[place] = self.alternatives[other] = condition, yes, no
                    before[name].remove(other)
                    break
            else:
                before[name].append(place)

    def _follows(self, places, other):
        """Whether one of these results is another one or computed from it."""
        todo, seen = list(places), set()
        while todo:
            one = todo.pop()
            if one == other:
                return True
            if one > other and one not in seen:
                seen.add(one)
                todo.extend(self.program.operands(one))
        return False

    def text(self, place):
        number = self.program.number(place)
        if number is not None:
            return f"({number!r})" if str(number).startswith("-") else repr(number)
        if place not in self.texts:
            self._write(place)
        return self.texts[place]

    def _write(self, place):
        name, *operands = self.program.ops[place]
        alternatives = self.alternatives.get(place)
        text = self._either(*alternatives) if alternatives else self._operation(place, name, operands)
        places = alternatives[1:] if alternatives else (place,)
        uses = sum(self.uses[k] for k in places)
        if name == "divide" and uses > 1 and self.is_value:
            text, name = f"lib.reused({bare(text)})", "reused"
        if not self.guards.isdisjoint(places):
            text, name = f"lib.finite({bare(text)})", "guard"
        # A condition also stands where what is not needed is kept safe.
        if uses == 1 and len(text) <= SHORT and not self.program.is_answer(place):
            self.texts[place] = text if name in CALLED or name in ("select", "guard") else f"({text})"
            return
        name = f"t{len(self.lines) + 1}"
        self.lines.append(f"{name} = {bare(text)}")
        self.texts.update(dict.fromkeys(places, name))

    def _operation(self, place, name, operands):
        if name == "select":
            return self._choice(place, *operands)
        if name == "less" and self.program.number(operands[0]) == 0.0 and (answer := self._answer(operands[1])):
            return answer
        return self._called(name, [self._safely((place,), (operand,), self.text(operand), k) for k, operand in enumerate(operands)])

    def _either(self, condition, yes, no):
        """One of two alternatives, by their operands."""
        name, *operands = self.program.ops[yes]
        texts = []
        for k, (one, other) in enumerate(zip(operands, self.program.operands(no), strict=True)):
            text = self.text(one)
            if one != other:
                text = f"lib.where({', '.join(map(bare, (self.text(condition), text, self.text(other))))})"
            texts.append(self._safely((yes, no), (one, other), text, k))
        return self._called(name, texts)

    def _called(self, name, texts):
        if name in INFIX:
            return f" {INFIX[name]} ".join(texts)
        if name == "negative":
            return f"-{texts[0]}"
        return f"lib.{CALLED[name]}({', '.join(map(bare, texts))})"

    def _choice(self, place, condition, yes, no):
        texts = [self.text(k) for k in (condition, yes, no)]
        if self.program.is_answer(place):
            if no == condition:
                return f"{texts[0]} & {texts[1]}"
            if yes == condition:
                return f"{texts[0]} | {texts[2]}"
            return f"({texts[0]} & {texts[1]}) | (~{texts[0]} & {texts[2]})"
        if texts[1] == texts[2]:
            return texts[1]
        constants = self.program.number(yes) is not None and self.program.number(no) is not None
        return f"lib.{'constants' if constants else 'where'}({', '.join(map(bare, texts))})"

    def _answer(self, place):
        """Whether a number is positive that is chosen among constants: the condition itself."""
        name, *operands = self.program.ops[place]
        if name == "number":
            return self.program.number(place) > 0.0
        if name != "select":
            return None
        yes, no = (self._answer(operand) for operand in operands[1:])
        if None in (yes, no) or yes == no:
            return None
        condition = self.text(operands[0])
        if yes is True:
            return condition if no is False else f"({condition} | {no})"
        if no is False:
            return f"({condition} & {yes})"
        return f"~{condition}" if yes is False and no is True else None

    def _safely(self, places, operands, text, k):
        """An operand of one or of alternative results, or a safe number where none of them is needed."""
        safe = SAFE.get(self.program.ops[places[0]][0], ())[k : k + 1]
        needed = either_of(self.needed[place] for place in places)
        is_number = all(self.program.number(operand) is not None for operand in operands)
        if safe in ((), (None,)) or needed in (ALWAYS, NEVER) or is_number or any(self._follows(conditions(needed), place) for place in places):
            return text
        key = operands, safe, needed
        if key not in self.safe:
            holds = bare(self._holds(needed))
            self.safe[key] = f"t{len(self.lines) + 1}"
            self.lines.append(f"{self.safe[key]} = lib.safe({holds}, {bare(text)}, {safe[0]!r})")
        return self.safe[key]

    def _holds(self, needed):
        kind, *parts = needed
        if kind == "either":
            return f"({' | '.join(sorted(self._holds(part) for part in parts[0]))})"
        around, (condition, holds) = parts
        text = self.text(condition) if holds else f"~{self.text(condition)}"
        return text if around == ALWAYS else f"({self._holds(around)} & {text})"


def bare(text):
    """Without brackets around all of it."""
    depth = 0
    for k, character in enumerate(text):
        depth += (character == "(") - (character == ")")
        if depth == 0 and k < len(text) - 1:
            return text
    return text[1:-1] if text.startswith("(") else text


def comparisons(tree):
    """The places of those in a tree."""
    return [] if isinstance(tree, bool) else [tree[0], *(place for side in tree[1:] for place in comparisons(side))]


def conditions(needed):
    kind, *parts = needed
    if kind == "either":
        for part in parts[0]:
            yield from conditions(part)
    elif kind == "both":
        yield parts[1][0]
        yield from conditions(parts[0])


def surely(needed):
    """The conditions, and whether they hold, without which nothing is needed."""
    kind, *parts = needed
    if kind == "either":
        return set.intersection(*map(surely, parts[0]))
    return {parts[1]} | surely(parts[0]) if kind == "both" else set()


def both(needed, condition):
    return needed if needed == NEVER else ("both", needed, condition)


def either(one, other):
    """One of both is needed; where a condition holds or not, what is around it."""
    if NEVER in (one, other):
        return one if other == NEVER else other
    if ALWAYS in (one, other) or one == other:
        return ALWAYS if ALWAYS in (one, other) else one
    parts = set()
    for part in (one, other):
        parts |= part[1] if part[0] == "either" else {part}
    for part in list(parts):
        if part[0] == "both" and part in parts:
            _, around, (condition, holds) = part
            opposite = ("both", around, (condition, not holds))
            if around in parts:
                parts.discard(part)
            elif opposite in parts:
                return either_of([*(parts - {part, opposite}), around])
    return next(iter(parts)) if len(parts) == 1 else ("either", frozenset(parts))


def either_of(parts):
    whole = NEVER
    for part in parts:
        whole = either(whole, part)
    return whole


def folded(text, indent="    "):
    """A line, broken at spaces where it is long, within brackets."""
    if len(indent + text) <= WIDTH:
        return [indent + text]
    head, bracket, rest = text.partition(" = ") if " = " in text.split("(")[0] else ("return ", "", text.removeprefix("return "))
    if text.startswith("def "):
        head, bracket, rest = text.partition("(")
    elif not rest.startswith("Function("):
        rest = f"({rest})"
    lines, line = [], indent + head + bracket
    for k, word in enumerate(rest.split(" ")):
        if k and len(line) + 1 + len(word) > WIDTH:
            lines.append(line)
            line = indent + "   "
        line += f" {word}" if k else word
    return [*lines, line]


def components(fields):
    """The names of components in order."""
    names = []
    for field in fields:
        name = field["name"] + "_" * keyword.iskeyword(field["name"]) if isinstance(field, dict) else field.name
        shape = field["shape"] if isinstance(field, dict) else field.shape
        size = 1
        for length in shape:
            size *= length
        names += [name] if not shape else [f"{name}_{k}" for k in range(size)]
    return names


def function(name, names, statements, returned):
    lines = folded(f"def {name}({', '.join(['lib', *names])}):", "")
    for line in statements:
        lines += folded(line)
    return "\n".join(["", "", *lines, *folded(f"return {returned}"), ""])


def tuple_of(texts):
    return f"({', '.join(texts)}{',' * (len(texts) == 1)})"


def accepted(name, program):
    """Whether inputs are allowed, each alone and all together."""
    texts = [f"lib.are_finite({', '.join(program.names)})"]
    for component, conditions in zip(program.names, program.conditions, strict=True):
        texts += [f"({component} {relation} {bound!r})" for relation, bound in conditions]
    lines = []
    if program.refusal is not None:
        body = program.body([program.refusal])
        lines, texts = body.lines, [*texts, f"({body.results[0]} == 0.0)"]
    return function(name, program.names, lines, " & ".join(texts))


def formula(name, id, program):
    """The functions of a formula, and the object that is called."""
    value = program.body(program.value)
    values = value.values()
    text = function(f"_{name}_value", program.names, value.lines, tuple_of(values))
    linearized, entries = "None", []
    if program.jacobian:
        n, m = len(program.names), len(program.value)
        entries = [(*divmod(k, n), place) for k, place in enumerate(program.jacobian) if program.number(place) != 0.0]
        both = program.body([*program.value, *(place for *_, place in entries)])
        linearized = f"_{name}_linearized"
        results = [tuple_of(both.values()), tuple_of(both.results[m:])]
        text += function(linearized, program.names, both.lines, ", ".join(results))
    text += accepted(f"_{name}_accepted", program)
    pairs = tuple_of([f"({i}, {j})" for i, j, _ in entries])
    made = f"{name} = Function({id!r}, _{name}_value, {linearized}, _{name}_accepted, {pairs})"
    return text + "\n\n" + "\n".join(folded(made, "")) + "\n"


def element(forms):
    """The functions of an element, without and with friction, and the object that is called."""
    text, given = "", []
    for said in forms:
        name = f"_{said['id']}_{'rubbing' if said['rubs'] else 'smooth'}"
        program = Program(said["program"], components(said["inputs"]))
        body = program.body(program.value)
        text += function(name, program.names, body.lines, tuple_of(body.values()))
        shapes = [(output, tuple(shape)) for output, shape in said["outputs"]]
        given.append(f"({said['inputs']!r}, {shapes!r}, {name})")
    first = forms[0]
    return f"{text}\n\n{first['id']} = Element({first['id']!r}, {first['title']!r}, {first['source']!r}, {', '.join(given)})\n"


HEAD = '''"""The formulas of the family {family}, over arrays of any library. Generated when the wheel was built."""

{elements}from ._function import Function, Missing
'''


def write(package):
    """Puts a module for each family beside the sources of the package, from where maturin takes them."""
    for former in FOLDER.glob("[!_]*.py"):
        former.unlink()
    said = json.loads(package._jointproof.programs())
    families = {}
    for one in said["formulas"]:
        formula_of = package.find(one["id"])
        family = one["id"].split(".")[0]
        try:
            program = Program(one["program"], components(formula_of.inputs))
            text = formula(formula_of.__name__, one["id"], program)
        except Missing as why:
            text = f"\n\n{formula_of.__name__} = Missing({one['id']!r}, {str(why)!r})\n"
        families.setdefault(family, []).append(text)
    forms = {}
    for one in said["elements"]:
        forms.setdefault(one["id"], []).append(one)
    for id, some in forms.items():
        try:
            families["element"].append(element(some))
        except Missing as why:
            families["element"].append(f"\n\n{id} = Missing({f'element {id}'!r}, {str(why)!r})\n")
    for family, texts in families.items():
        head = HEAD.format(family=family, elements="from ._element import Element\n" if family == "element" else "")
        (FOLDER / f"{family}.py").write_text(head + "".join(texts), encoding="utf-8")
