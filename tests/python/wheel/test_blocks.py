"""Blocks on several processes have the bytes of one; a process that is killed loses nothing but time."""

import functools
import os
import random
import signal

import numpy as np
import pytest
from conftest import points, same, wanted

import jointproof

da = wanted("dask.array")
distributed = wanted("distributed")
blocks = wanted("jointproof.blocks")

IDS = ["slot.friction", "slot.relative_position", "slot.contact_force", "element.arm"]


@pytest.fixture(scope="module")
def client():
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            yield client


def chunked(formula, count, chunk):
    inputs = formula.unpack(points(formula, count))
    return inputs, {
        field.name: da.from_array(inputs[field.name], chunks=(chunk, *field.shape)) for field in formula.inputs
    }


@pytest.mark.parametrize("id", IDS)
def test_arrays_have_the_bytes_of_one_process(client, id):
    formula = jointproof.find(id)
    inputs, arrays = chunked(formula, 1000, 170)
    expected, by = formula.linearize(**inputs)
    assert all(same(a.compute(), b) for a, b in zip(blocks.value(formula, **arrays), expected))
    value, jacobian = blocks.linearize(id, **arrays)
    assert all(same(a.compute(), b) for a, b in zip(value, expected))
    assert same(jacobian.array.compute(), by.array)
    output, field = formula.outputs[0], formula.inputs[0]
    assert same(jacobian[output.name][field.name].compute(), by[output.name][field.name])


@pytest.mark.parametrize("chunk", [1000, 170, 37])
def test_summaries_have_the_bytes_of_one(client, chunk):
    formula = jointproof.find("slot.friction")
    inputs, arrays = chunked(formula, 1000, chunk)
    whole = blocks.Summary.of(formula, *inputs.values())
    assert blocks.summary(formula, **arrays).compute().json() == whole.json()


def test_summaries_add_in_any_order():
    formula = jointproof.slot.contact_force
    f2 = np.linspace(-5, 5, 1001)
    f2[[17, 500]] = np.nan
    whole = blocks.Summary.of(formula, f2, 1.0)
    cuts = [slice(k, k + 77) for k in range(0, 1001, 77)]
    parts = [blocks.Summary.of(formula, f2[cut], np.ones(len(f2[cut])), first_row=cut.start) for cut in cuts]
    random.Random(0).shuffle(parts)
    assert functools.reduce(lambda a, b: a + b, parts).json() == whole.json()
    assert (whole.rows, whole.refused, whole.first_refused) == (1001, 2, 17)
    fc = np.hypot(np.delete(f2, [17, 500]), 1.0)
    for q in (0.01, 0.5, 0.99):
        assert abs(whole.quantile("fc", q) / np.quantile(fc, q, method="inverted_cdf") - 1) < 2**-8 + 1e-12
    assert whole.columns["∂fc/∂f2"]["least"][1] == 0 and whole.columns["∂fc/∂f2"]["greatest"][1] == 1000
    negative = whole.quantile("∂fc/∂f2", 0.25)
    assert negative < 0 and "1001 rows, 2 refused" in repr(whole)


def test_audits_have_the_bytes_of_one(client):
    whole = jointproof.audit("slot.friction", "slot.stop", samples=40)
    assert blocks.audit("slot.friction", "slot.stop", shards=16, samples=40).compute().json == whole.json


def slow_part(id, index, of, killed):
    """A part of an audit, during the first of which this process dies, once."""
    if index == 2 and not os.path.exists(killed):
        with open(killed, "x"):
            pass
        os.kill(os.getpid(), signal.SIGKILL)
    return jointproof.audit_part(id, index, of, samples=40)


def test_a_process_that_is_killed_loses_nothing(tmp_path):
    killed = tmp_path / "killed"
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            parts = client.map(slow_part, ["slot.friction"] * 8, range(1, 9), [8] * 8, [str(killed)] * 8, pure=False)
            audits = jointproof.merge(client.gather(parts))
    assert killed.exists()
    assert audits.json == jointproof.audit("slot.friction", samples=40).json


def test_record_batches_become_record_batches():
    pyarrow = wanted("pyarrow")
    formula = jointproof.slot.relative_position
    drawn = points(formula, 10)
    names = blocks.component_names(formula.inputs)
    batch = pyarrow.RecordBatch.from_arrays([pyarrow.array(x) for x in drawn.T], names=names)
    function = blocks.arrow("slot.relative_position")
    (result, again) = list(function(iter([batch, batch])))
    assert result.equals(again) and result.schema.names == function.schema()
    value, jacobian = formula.linearize(**formula.unpack(drawn))
    assert same(result.column("y"), value.y)
    assert same(result.column("∂y/∂e2a[1]"), jacobian.y.e2a[:, 1])


def test_a_refused_row_is_named_by_its_number_in_the_whole():
    f2 = np.linspace(1.0, 2.0, 40)
    f2[33] = np.nan
    arrays = da.from_array(f2, chunks=8), da.from_array(np.ones(40), chunks=8)
    for result in (blocks.value("slot.contact_force", *arrays).fc, blocks.linearize("slot.contact_force", *arrays)[0].fc):
        with pytest.raises(jointproof.InputError, match="slot.contact_force: row 33: f2 is NaN") as error:
            result.compute(scheduler="synchronous")
        assert (error.value.row, error.value.index) == (33, (33,))
    table = da.from_array(f2.reshape(10, 4), chunks=(3, 2))
    with pytest.raises(jointproof.InputError, match=r"row 33 at \[8, 1\]"):
        blocks.value("slot.contact_force", table, 1.0).fc.compute(scheduler="synchronous")


def test_a_formula_takes_arrays_of_dask_block_by_block():
    f2, f3 = np.linspace(1.0, 2.0, 40), np.linspace(2.0, 5.0, 40)
    arrays = da.from_array(f2, chunks=8), da.from_array(f3, chunks=10)
    value, jacobian = jointproof.slot.contact_force.linearize(*arrays)
    expected, by = jointproof.slot.contact_force.linearize(f2, f3)
    assert isinstance(value.fc, da.Array) and same(value.fc.compute(), expected.fc)
    assert same(jacobian.fc.f3.compute(), by.fc.f3)
    assert same(jointproof.slot.contact_force(*arrays).fc.compute(), expected.fc)
    whole = blocks.Summary.of(jointproof.slot.contact_force, f2, f3)
    assert blocks.summary("slot.contact_force", *arrays).compute() == whole
