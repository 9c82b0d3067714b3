"""What can be wrong with a call."""

from typing import Any


class InputError(ValueError):
    """Rows of a call were refused. All others are computed; the results of these are NaN.

    ``formula``: the identifier. ``row``: the first row that is refused, counted from 0 in C order; ``index``: the same in the
    shape of the call. ``input``: the input that is wrong, as ``f2`` or ``e1a[2]``, or None where several are, together.
    ``value``, ``allowed``: its value, and what is allowed, in words. ``kind``: the name of the error. ``count``: how many rows
    are refused. ``results``: what the call would have returned.
    """

    formula: str
    row: int
    index: tuple[int, ...]
    input: str | None
    value: float | None
    allowed: str | None
    kind: str
    count: int
    results: Any

    def __init__(self, formula: str, told: dict[str, Any], index: tuple[int, ...], results: Any) -> None:
        self.formula = formula
        self.row = told["row"]
        self.index = index
        self.input = told["input"]
        self.value = told["value"]
        self.allowed = told["allowed"]
        self.kind = told["kind"]
        self.count = told["count"]
        self.results = results
        self._reason = told["reason"]
        super().__init__(self._said())

    def renumbered(self, row: int, index: tuple[int, ...]) -> "InputError":
        """The same in a larger call, of which this was a block: the row's number there, and its index."""
        return InputError(self.formula, self._told() | {"row": row}, index, self.results)

    def _told(self):
        told = {name: getattr(self, name) for name in ("input", "value", "allowed", "kind", "count")}
        return told | {"reason": self._reason}

    def _said(self):
        if self.index == ():
            return f"{self.formula}: {self._reason}"
        row = self.row if len(self.index) == 1 else f"{self.row} at {list(self.index)}"
        which = f"row {row}" if self.count == 1 else f"row {row}, the first of {self.count} that are refused"
        return f"{self.formula}: {which}: {self._reason}"

    def __reduce__(self):
        return InputError, (self.formula, self._told() | {"row": self.row}, self.index, self.results)


class ShapeError(ValueError):
    """An array has not the shape that its field needs. ``name``: the field."""

    def __init__(self, name: str, said: str) -> None:
        self.name = name
        super().__init__(f"{name}: {said}")

    def __reduce__(self):
        return ShapeError, (self.name, str(self).removeprefix(f"{self.name}: "))
