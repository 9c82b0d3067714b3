"""Audits from Python are those of the command, and parts of them add up byte for byte."""

import html
import json
import random
import subprocess
import sys

import pytest

import jointproof

IDS = ("slot.friction", "coulomb.return_map")


def test_an_audit_passes_and_tells():
    audits = jointproof.audit(*IDS, samples=50, seed=7)
    assert audits.passed and bool(audits)
    assert [audit["formula"] for audit in audits.data] == list(IDS)
    assert "slot.friction" in str(audits) and "\x1b" not in str(audits)
    assert "2 formulas" in audits.text and "0 formulas off" in audits.text
    assert audits.text in html.unescape(audits._repr_html_())


@pytest.mark.parametrize("of", [1, 3, 16])
def test_parts_are_the_whole_byte_for_byte(of):
    whole = jointproof.audit(*IDS, samples=40, seed=7)
    parts = [jointproof.audit_part(id, k, of, samples=40, seed=7) for id in IDS for k in range(1, of + 1)]
    random.Random(of).shuffle(parts)
    assert jointproof.merge(parts).json == whole.json


def test_merging_is_associative():
    one, two, three = (jointproof.audit_part("slot.friction", k, 3, samples=40) for k in (1, 2, 3))
    left = jointproof.merge_parts(jointproof.merge_parts(one, two), three)
    assert left == jointproof.merge_parts(one, jointproof.merge_parts(two, three))
    with pytest.raises(ValueError, match="does not follow"):
        jointproof.merge_parts(one, three)
    with pytest.raises(ValueError, match="are not all"):
        jointproof.merge([one, two])


def test_what_is_asked_wrongly_is_said():
    with pytest.raises(KeyError, match="slot.nothing"):
        jointproof.audit("slot.nothing")
    with pytest.raises(ValueError, match="there is no part 4 of 3"):
        jointproof.audit_part("slot.friction", 4, 3)


def test_jobs_write_parts_and_merge_them(tmp_path):
    def run(*arguments):
        return subprocess.run([sys.executable, "-m", "jointproof", *arguments], capture_output=True, text=True, check=True)

    files = []
    for k in (1, 2):
        files.append(tmp_path / f"{k}.json")
        files[-1].write_text(run("slot.f*", "--samples", "40", "--shard", f"{k}/2").stdout)
    merged = run("--merge", *map(str, files)).stdout
    assert merged == jointproof.audit("slot.f*", samples=40).text
    assert json.loads(files[0].read_text().splitlines()[0])
