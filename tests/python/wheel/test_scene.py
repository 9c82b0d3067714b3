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


def test_arrays_and_numbers_of_numpy_are_lists_and_numbers():
    frames = [frame | {"time": np.float32(frame["time"]), "loads": {"guide": {"f2": np.int64(3 * k), "f3": np.float64(4 * k)}}} for k, frame in enumerate(SCENE["frames"], 1)]
    nodes = {"rail": SCENE["nodes"]["rail"] | {"at": np.zeros(3)}, "car": {"at": np.array([1, 2, 3])}}
    axes = {"along": {"axes": np.eye(3)[:2]}}
    scene, expected = jointproof.scene(SCENE | {"frames": frames, "nodes": nodes, "orientations": axes}), jointproof.scene(SCENE)
    assert all(np.array_equal(scene[column], expected[column]) for column in expected.columns)
    with pytest.raises(TypeError, match="a scene has no set"):
        jointproof.scene(SCENE | {"outputs": {"U1"}})


def test_a_fault_has_its_place():
    with pytest.raises(ValueError, match='unknown key "output"'):
        jointproof.scene(SCENE | {"output": []})


@pytest.mark.parametrize("save", [np.savez, np.savez_compressed])
def test_a_scene_names_arrays(tmp_path, save):
    count, states = 5, 3
    time = np.arange(1.0, states + 1)
    start = np.linspace([1, 2, 3], [2, 3, 4], count)
    u = np.multiply.outer(time, np.linspace([0.5, 0, 0], [1, 0, 0], count))
    arrays = {"start": start, "mu": np.linspace(0, 0.5, count), "time": time, "u": u, "f2": u[:, :, 0]}
    save(tmp_path / "many.npz", **arrays)
    described = SCENE | {
        "columns": "many.npz",
        "nodes": SCENE["nodes"] | {"car": {"at": "start"}},
        "elements": {"guide": {"kind": "slot", "nodes": ["rail", "car"], "mu": "mu", "k_stick": 2}},
        "frames": {"time": "time", "nodes": {"car": {"u": "u"}}, "loads": {"guide": {"f2": "f2"}}},
        "outputs": ["U1", "CSF1", "RF"],
    }
    path = tmp_path / "many.json"
    path.write_text(json.dumps(described))
    scene = jointproof.scene(path)
    for k in range(count):
        frames = [
            {"time": time[i], "nodes": {"car": {"u": u[i, k].tolist()}}, "loads": {"guide": {"f2": u[i, k, 0]}}}
            for i in range(states)
        ]
        element = {"kind": "slot", "nodes": ["rail", "car"], "mu": arrays["mu"][k], "k_stick": 2}
        nodes = SCENE["nodes"] | {"car": {"at": start[k].tolist()}}
        alone = described | {"nodes": nodes, "elements": {"guide": element}, "frames": frames}
        alone = jointproof.scene({key: value for key, value in alone.items() if key != "columns"})
        for output in described["outputs"]:
            assert np.array_equal(scene[f"guide[{k}]", output], alone["guide", output]), (k, output)

    save(tmp_path / "many.npz", **arrays | {"u": u.astype("float32")})
    with pytest.raises(ValueError, match="frames.nodes.car.u .*array \"u\" of \"many.npz\": numbers of type '<f4'"):
        jointproof.scene(path)
    save(tmp_path / "many.npz", **arrays | {"u": np.asfortranarray(u)})
    with pytest.raises(ValueError, match="Fortran order; allowed is C order"):
        jointproof.scene(path)


def test_a_frame_of_pandas_is_a_history(tmp_path):
    pd = wanted("pandas")
    bare = {key: value for key, value in SCENE.items() if key != "frames"}
    nodes = pd.DataFrame({"time": [1.0, 2.0, 3.0], "node": "car", "u1": [0.5, 1.0, 0.1 + 1.4], "step": 1})
    loads = pd.DataFrame({"time": [1.0, 2.0, 3.0], "element": "guide", "f2": [3, 6, 9], "f3": [4, 8, 12]})
    expected = jointproof.scene(SCENE)
    nodes.to_csv(tmp_path / "nodes.csv", index=False)
    for table in (nodes, nodes.set_index(["time", "node"]), tmp_path / "nodes.csv"):
        scene = jointproof.scene(bare, nodes=table, loads=loads)
        assert all(np.array_equal(scene[column], expected[column]) for column in expected.columns)
        assert len(scene.notes) == 1 and "step" in scene.notes[0]
    with pytest.raises(ValueError, match=r'nodes, line 3, column 2 \("node"\)|no node of the scene'):
        jointproof.scene(bare, nodes=nodes.assign(node="bus"))
