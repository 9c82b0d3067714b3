"""Parts of audits, for schedulers of jobs: ``python -m jointproof --shard 3/16 > 3.json``, ``python -m jointproof --merge *.json``."""

import argparse
import pathlib
import sys

from . import auditing


def main():
    parser = argparse.ArgumentParser(prog="python -m jointproof", description="Audit formulas, or merge parts of audits.")
    parser.add_argument("formulas", nargs="*", help="identifiers, or patterns as slot.*; all of them if there is none")
    parser.add_argument("--samples", type=int, help="random points of every formula")
    parser.add_argument("--seed", type=int, help="what they are drawn from")
    parser.add_argument("--shard", help="3/16 is the third of sixteen parts, printed for --merge, a line a formula")
    parser.add_argument("--merge", nargs="+", metavar="FILE", type=pathlib.Path, help="files of parts")
    given = parser.parse_args()
    if given.merge:
        lines = (file.read_text(encoding="utf-8").splitlines() for file in given.merge)
        audits = auditing.merge(part for parts in lines for part in parts)
    elif given.shard:
        index, of = map(int, given.shard.split("/"))
        for id in auditing.chosen(given.formulas):
            print(auditing.audit_part(id, index, of, samples=given.samples, seed=given.seed))
        return 0
    else:
        audits = auditing.audit(*given.formulas, samples=given.samples, seed=given.seed)
    print(audits.text, end="")
    return 0 if audits.passed else 1


if __name__ == "__main__":
    sys.exit(main())
