#!/usr/bin/env python3
"""Scenes from arrays to arrays, as numpy writes and opens them: python -m unittest test_scenes, or run this file."""

from __future__ import annotations

import json
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
SCENES = ROOT / "golden" / "scenes"


def scene(*arguments) -> str:
    """What `cargo xtask scene` prints."""
    command = ["cargo", "xtask", "scene", *map(str, arguments)]
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout


def as_array(series: dict) -> np.ndarray:
    """The values of a series of JSON as the array that is written: NaN in a state that has none."""
    width = max(len(state) for state in series["values"])
    values = np.array([state or [np.nan] * width for state in series["values"]], float)
    return values[:, 0] if width == 1 else values


class Arrays(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def results(self, path: Path) -> tuple[dict, dict]:
        """The results of a scene as JSON, and as arrays."""
        arrays, text = self.folder / "results.npz", self.folder / "results.json"
        scene(path, "--out", arrays)
        scene(path, "--out", text)
        with np.load(arrays, allow_pickle=False) as opened:
            return json.loads(text.read_text()), dict(opened)

    def assert_same(self, one: np.ndarray, other: np.ndarray, what: str):
        """The same shape and bits; every NaN is as good as another."""
        self.assertEqual((one.dtype, one.shape), (other.dtype, other.shape), what)
        self.assertTrue(np.array_equal(np.isnan(one), np.isnan(other)), what)
        self.assertEqual(one[~np.isnan(one)].tobytes(), other[~np.isnan(other)].tobytes(), what)

    def test_numpy_opens_the_results_of_every_example(self):
        examples = [path for path in SCENES.glob("*.json") if path.with_suffix(".result.json").exists()]
        self.assertGreater(len(examples), 5)
        absent = 0
        for path in examples:
            printed, arrays = self.results(path)
            expected = {f"{series['element']}/{series['output']}": as_array(series) for series in printed["series"]}
            self.assertEqual(arrays.keys(), {"time", *expected}, path.name)
            for name, array in {"time": np.array(printed["times"], float), **expected}.items():
                self.assert_same(arrays[name], array, f"{path.name}: {name}")
                absent += np.isnan(array).sum()
        self.assertGreater(absent, 0, "some torque is not output in every state")

    def test_what_numpy_writes_is_evaluated_as_the_same_numbers_in_json(self):
        count, states = 7, 3
        connectors = ["--generate", count, "--of", "translator", "--states", states]
        arrays, described, text = (self.folder / name for name in ("many.npz", "described.json", "many.json"))
        text.write_text(scene(*connectors))
        described.write_text(scene(*connectors, "--columns", arrays))
        printed, _ = self.results(text)
        of_members = {(series["element"], series["output"]): as_array(series) for series in printed["series"]}
        with np.load(arrays, allow_pickle=False) as opened:
            given = dict(opened)
        self.assertEqual((given["u"].shape, given["mu"].shape), ((states, count, 3), (count,)))
        for save in (np.savez, np.savez_compressed):
            save(arrays, **given)
            _, of_set = self.results(described)
            outputs = {name.removeprefix("s/") for name in of_set if name != "time"}
            self.assertEqual(outputs, {output for _, output in of_members}, "all outputs of the set, and no others")
            for output in outputs:
                members = np.stack([of_members[f"s{k}", output] for k in range(count)], axis=1)
                self.assert_same(of_set[f"s/{output}"], members, f"{save.__name__}: {output}")


if __name__ == "__main__":
    unittest.main()
