#!/usr/bin/env python3
"""Runs the chapter on Python: what its examples print, and the files that they write, must be what the book shows.

A block of Python is followed by a block of text if it prints. Files that the examples write are beside the chapter.

    python3 xtask/wheel/chapter.py           compare
    python3 xtask/wheel/chapter.py --write   write what is found into the book
"""

import argparse
import contextlib
import difflib
import io
import os
import pathlib
import re
import sys
import tempfile

CHAPTER = pathlib.Path(__file__).resolve().parents[2] / "book" / "src" / "python.md"
EXAMPLE = re.compile(r"(?P<head>^```python\n(?P<code>.*?)^```\n)(?P<shown>\n```text\n(?P<text>.*?)^```\n)?", re.MULTILINE | re.DOTALL)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true")
    write = parser.parse_args().write
    with tempfile.TemporaryDirectory() as folder:
        found = {CHAPTER: run(CHAPTER.read_text(encoding="utf-8"), folder)}
        for file in pathlib.Path(folder).iterdir():
            found[CHAPTER.with_name(file.name)] = file.read_text(encoding="utf-8")
    stale = [path for path, text in found.items() if not path.exists() or path.read_text(encoding="utf-8") != text]
    for path in stale:
        if write:
            path.write_text(found[path], encoding="utf-8")
        else:
            show(path, found[path])
    if stale and not write:
        print("the chapter is not what runs; python3 xtask/wheel/chapter.py --write mends it", file=sys.stderr)
    return 1 if stale and not write else 0


def run(chapter, folder):
    """The chapter with what its examples print, run in a folder in which they write."""
    names = {"__name__": "chapter"}
    before = os.getcwd()
    os.chdir(folder)
    try:
        return EXAMPLE.sub(lambda example: ran(example, names), chapter)
    finally:
        os.chdir(before)


def ran(example, names):
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        exec(compile(example["code"], str(CHAPTER), "exec"), names)
    text = "\n".join(line.rstrip() for line in said.getvalue().split("\n"))
    return example["head"] + (f"\n```text\n{text}```\n" if text else "")


def show(path, text):
    shown = path.read_text(encoding="utf-8") if path.exists() else ""
    lines = difflib.unified_diff(shown.splitlines(), text.splitlines(), f"{path.name} in the book", "as it runs", lineterm="")
    print("\n".join(lines))


if __name__ == "__main__":
    sys.exit(main())
