"""Audits: all that is claimed of formulas, executed now, on one machine or on many."""

import fnmatch
import html
import json
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from . import _jointproof

if TYPE_CHECKING:
    from .formula import Formula


class Audits:
    """What audits found. It prints as text; ``passed`` says whether everything held, ``data`` has all of it."""

    def __init__(self, text: str) -> None:
        self.json = text
        self.data: Any = json.loads(text)
        self.text: str
        self.passed: bool
        self.text, self.passed = _jointproof.audit_text(text)

    def __repr__(self) -> str:
        return self.text.rstrip()

    def __bool__(self) -> bool:
        return self.passed

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Audits) and self.json == other.json

    def __hash__(self) -> int:
        return hash(self.json)

    def _repr_html_(self):
        return f"<pre>{html.escape(self.text)}</pre>"

    def __reduce__(self):
        return Audits, (self.json,)


def audit(*patterns: "str | Formula", samples: int | None = None, seed: int | None = None) -> Audits:
    """Audits the formulas of these identifiers; ``slot.*`` is a family. Without any, all of them. Samples and seed are those of
    the command where they are not given."""
    return Audits(_jointproof.audit(chosen(patterns), samples, seed))


def audit_part(formula: "str | Formula", index: int, of: int, *, samples: int | None = None, seed: int | None = None) -> str:
    """A part of the audit of a formula, as text that travels: the part of this number, counted from 1, of so many. Whatever
    their number, all draw the same points, and each audits its share."""
    return _jointproof.audit_part(_id(formula), samples, seed, index, of)


def merge_parts(one: str, following: str) -> str:
    """A part of an audit and the one that follows it, as one part."""
    return _jointproof.merge_parts(one, following)


def merge(parts: Iterable[str]) -> Audits:
    """The audits that parts are, of one formula or of several, in whatever order the parts are given."""
    return Audits(_jointproof.merge_all(list(parts)))


def chosen(patterns: "Iterable[str | Formula]") -> list[str]:
    """The identifiers that one of the patterns fits, in the order of the book."""
    from . import formulas

    patterns = [_id(pattern) for pattern in patterns] or ["*"]
    for pattern in patterns:
        if not fnmatch.filter(formulas, pattern):
            raise KeyError(f"there is no formula {pattern!r}")
    return [id for id in formulas if any(fnmatch.fnmatchcase(id, pattern) for pattern in patterns)]


def _id(formula):
    return formula if isinstance(formula, str) else formula.id
