# SPDX-License-Identifier: MIT
"""Results can be copied, and sent to other processes and back."""

import copy
import pickle
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from multiprocessing import get_context

import numpy as np
import pytest
from conftest import ROOT

import stillpoint

HIT = {"v0": 1, "p": 1}


def results():
    yield stillpoint.design(beta=0.9, **HIT), ()
    yield stillpoint.region(beta=0.5, **HIT), ()
    yield stillpoint.simulate(f=0.02, delta=0.02, samples=20, **HIT), ("trajectory",)
    yield stillpoint.simulate(velocity=0.4, period=2.8, f=0.02, delta_m=0.005, samples=20), ("trajectory",)
    yield stillpoint.simulate(f=0.02, delta=0.02, **HIT), ("trajectory",)
    yield stillpoint.sweep(f="0:0.3:5", delta="0:0.4:3", **HIT), ("table",)
    yield stillpoint.spectrum(record=ROOT / "data/records/strong_motion.AT2", period="2:3:3", f=0.05, delta_m=0.01), ()


@pytest.mark.parametrize("remade", [
    lambda one: pickle.loads(pickle.dumps(one)), lambda one: pickle.loads(pickle.dumps(one, 2)),
    lambda one: pickle.loads(pickle.dumps(copy.copy(one))), copy.copy, copy.deepcopy])
def test_a_copy_says_the_same(remade):
    for one, arrays in results():
        other = remade(one)
        assert type(other) is type(one) and other is not one
        assert other.report == one.report and isinstance(other.report, stillpoint.Fields)
        assert str(other) == str(one) and repr(other) == repr(one)
        assert other._repr_html_() == one._repr_html_()
        assert dir(other) == dir(one)
        for name in arrays:
            assert np.asarray(getattr(other, name)).tobytes() == np.asarray(getattr(one, name)).tobytes()


def test_a_deep_copy_shares_nothing():
    one = stillpoint.design(beta=0.9, **HIT)
    other = copy.deepcopy(one)
    other.report["design"]["f"] = 0
    assert one.design.f > 0 and copy.copy(one).report is one.report


def test_pools_of_processes_work():
    betas = [0.85, 0.9, 0.95]
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        found = [*pool.map(stillpoint.design, [{"beta": beta, **HIT} for beta in betas])]
        regions = [*pool.map(partial(stillpoint.region, HIT), [])]
        wrong = pool.submit(stillpoint.design, v0=-1, p=1, beta=1)
        many = pool.submit(stillpoint.sweep, f=np.array([0.1, 0.2]), delta=0.1, v0=1, p=1).result()
        with pytest.raises(stillpoint.InputError, match="^v0 = -1: "):
            wrong.result()
    assert not regions
    assert [one.design for one in found] == [stillpoint.design(beta=beta, **HIT).design for beta in betas]
    assert many.table.tobytes() == stillpoint.sweep(f=[0.1, 0.2], delta=0.1, v0=1, p=1).table.tobytes()
