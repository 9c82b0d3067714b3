"""Scenes are columns."""

import json

import numpy as np
import pytest
from conftest import wanted

import jointproof

SCENE = {
    "title": "a rail",
    "dimension": "3d",
    "orientations": {"along": {"axes": [[1, 0, 0], [0, 1, 0]]}},
    "nodes": {"rail": {"at": [0, 0, 0], "orientation": "along"}, "car": {"at": [1, 2, 3]}},
    "elements": {"guide": {"kind": "slot", "nodes": ["rail", "car"], "mu": 0.25}},
    "frames": [
        {"time": time, "nodes": {"car": {"u": [time / 2, 0, 0]}}, "loads": {"guide": {"f2": 3 * time, "f3": 4 * time}}}
        for time in (1, 2, 3)
    ],
    "outputs": ["U1", "FN"],
}


def test_a_scene_is_columns(tmp_path):
    path = tmp_path / "rail.json"
    path.write_text(json.dumps(SCENE))
    for source in (SCENE, json.dumps(SCENE), path, str(path)):
        scene = jointproof.scene(source)
        assert scene.title == "a rail" and scene.times.tolist() == [1.0, 2.0, 3.0]
        assert scene["guide", "FN"].tolist() == [5.0, 10.0, 15.0]
        assert scene["guide", "U1"].tolist() == [0.5, 1.0, 1.5]
        assert scene.counts["slot.relative_motion"] == 3
    assert jointproof.scene(SCENE, exact=True)["guide", "FN"].tolist() == [5.0, 10.0, 15.0]


def test_a_scene_is_a_frame():
    wanted("pandas")
    scene = jointproof.scene(SCENE)
    frame = scene.frame()
    assert frame.index.name == "time" and list(frame.columns) == [("guide", "U1", 0), ("guide", "FN", 0)]
    assert np.array_equal(frame["guide", "FN", 0], scene["guide", "FN"])
    assert "<table" in scene._repr_html_()


def test_a_fault_has_its_place():
    with pytest.raises(ValueError, match='unknown key "output"'):
        jointproof.scene(SCENE | {"output": []})
