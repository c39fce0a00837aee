# SPDX-License-Identifier: MIT
"""motions: against the program, bit for bit, whatever the arrays, the threads, the blocks."""

import sys
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import numpy as np
import pytest

import stillpoint

SEED = 20_261_122


def dampers(count):
    random = np.random.default_rng(SEED)
    return random.uniform(0.01, 0.4, count), random.uniform(0, 0.6, count)


def peak(*arguments, **options):
    return stillpoint.motions(*arguments, **options).peak_amplitude


def test_motions_match_a_sweep(program):
    f, delta = dampers(300)
    np.savetxt("list.csv", np.column_stack([f, delta]), "%.17g", ",", header="f,delta", comments="")
    program.run("sweep", "--times", v0=1.25, p=0.75, list="list.csv", output="rows.npy")
    wanted = np.load("rows.npy")
    found = stillpoint.motions(f, delta, 1.25, 0.75, times=True)
    assert [*found] == ["peak_amplitude", "half_cycles", "outcome", "stop_position", "stop_time"]
    for name, values in found.items():
        assert values.tobytes() == wanted[name].tobytes(), name


def test_single_damper_matches_simulate():
    for f, delta in zip(*dampers(20)):
        response = stillpoint.simulate(v0=1, p=1, f=f, delta=delta).response
        found = stillpoint.motions(f, delta, 1, 1, times=True, acceleration=True)
        assert found.peak_amplitude.shape == ()
        for name in found:
            value = stillpoint.outcomes[found[name]] if name == "outcome" else found[name]
            assert value == response[name], name


def test_several_blocks_equal_their_parts():
    f, delta = dampers(600_000)  # a block has 262 144
    whole = stillpoint.motions(f, delta, 1, 1)
    part = stillpoint.motions(f[250_000:300_000], delta[250_000:300_000], 1, 1)
    for name, values in part.items():
        assert values.tobytes() == whole[name][250_000:300_000].tobytes(), name


def test_arrays_broadcast():
    f, delta = np.linspace(0.01, 0.3, 5), np.linspace(0, 0.4, 3)
    plane = stillpoint.motions(f[:, None], delta, 1, 1)
    assert plane.peak_amplitude.shape == plane.outcome.shape == (5, 3)
    assert plane.peak_amplitude[4, 1] == peak(f[4], delta[1], 1, 1)
    assert peak(f, 0.1, np.full(5, 2.0), 1).shape == (5,)
    assert peak(np.array([0.1]), 0.1, 1, 1).shape == (1,)
    assert peak(f[::2], 0.1, 1, 1).tolist() == peak(f, 0.1, 1, 1)[::2].tolist()
    assert peak([], [], 1, 1).shape == (0,)
    with pytest.raises(stillpoint.InputError, match="broadcast"):
        stillpoint.motions(f, delta, 1, 1)


def test_numbers_of_any_kind_are_taken():
    wanted = peak(0.25, 0.5, 2.0, 1.0)
    assert peak(f=0.25, delta=0.5, v0=2, p=1) == wanted
    assert peak(np.float64(0.25), np.float32(0.5), np.int64(2), np.longdouble(1)) == wanted
    assert peak(np.array([0.25], np.longdouble), [Fraction(1, 2)], 2, 1)[0] == wanted
    region = stillpoint.region(v0=1.0, p=1.0, beta=0.75).region
    assert stillpoint.region(v0=np.int64(1), p=np.float64(1), beta=np.float32(0.75)).region == region
    assert stillpoint.region(v0=np.longdouble(1), p=1, beta=np.longdouble(0.75)).region == region
    axis = np.linspace(0.01, 0.3, 5)
    assert np.array_equal(stillpoint.sweep(v0=1, p=1, f=axis.astype(np.longdouble), delta=0.1).table,
                          stillpoint.sweep(v0=1, p=1, f=axis, delta=0.1).table)


@pytest.mark.parametrize("entries", [100, 600_000])
def test_wrong_entry_is_named(entries):
    f, delta = dampers(entries)
    f[entries - 7] = -1
    f[entries - 3] = np.nan
    with pytest.raises(stillpoint.InputError, match=rf"^f\[{entries - 7}\] = -1: must be"):
        stillpoint.motions(f, delta, 1, 1)


def test_wrong_arguments_are_refused():
    for arguments in ("a", 0, 1, 1), (0, [0, "b"], 1, 1), (0, 0, 1j, 1), (0, 0, np.clongdouble(1), 1):
        with pytest.raises(stillpoint.InputError, match="must be a number or an array"):
            stillpoint.motions(*arguments)
    with pytest.raises(stillpoint.InputError, match="^p = 0: must be"):
        stillpoint.motions(0.1, 0.1, 1.0, 0.0)
    with pytest.raises(stillpoint.InputError, match="threads = -1"):
        stillpoint.motions([0.1], 0.1, 1, 1, threads=-1)
    with pytest.raises(TypeError):
        stillpoint.motions(0.1, 0.1)


@pytest.mark.parametrize("wrong", [
    True, np.True_, [True, 0.5], [0.5, np.False_], np.array([True, False]), [[0.5], [True]],
    np.array([0.5, True], object)])
def test_booleans_are_no_numbers(wrong):
    with pytest.raises(stillpoint.InputError, match="^f: must be a number or an array"):
        stillpoint.motions(wrong, 0.1, 1, 1)
    with pytest.raises(stillpoint.InputError, match="^f = .*must be a number"):
        stillpoint.sweep(v0=1, p=1, f=wrong, delta=0.1)


def test_what_is_masked_is_refused():
    wrong = np.ma.masked_greater([0.1, 0.2, 99], 1)
    with pytest.raises(stillpoint.InputError, match="^f = .*no masked entries"):
        stillpoint.motions(wrong, 0.1, 1, 1)
    with pytest.raises(stillpoint.InputError, match="^f = .*no masked entries"):
        stillpoint.sweep(v0=1, p=1, f=wrong, delta=0.1)
    for value in wrong[2], wrong[2:]:
        with pytest.raises(stillpoint.InputError, match="^beta = .*no masked entries"):
            stillpoint.region(v0=1, p=1, beta=value)
    bare = np.ma.masked_greater([0.1, 0.2], 1)  # nothing of it is masked
    assert stillpoint.motions(bare, 0.1, 1, 1).peak_amplitude.tolist() == peak([0.1, 0.2], 0.1, 1, 1).tolist()


def test_half_cycles_are_limited():
    with pytest.raises(stillpoint.InputError, match="half-cycles"):
        stillpoint.motions([0.1, 1e-5], 1e-9, 1, 1, half_cycle_limit=100)


def test_no_result_depends_on_threads():
    f, delta = dampers(100_000)
    one, many = (stillpoint.motions(f, delta, 1, 1, threads=n).stop_position for n in (1, 7))
    assert one.tobytes() == many.tobytes()


def test_python_threads_run_side_by_side():
    f, delta = dampers(50_000)
    wanted = stillpoint.motions(f, delta, 1, 1).peak_amplitude.tobytes()
    design = stillpoint.design(v0=1, p=1, beta=0.9).design
    with ThreadPoolExecutor(8) as pool:
        peaks = [pool.submit(stillpoint.motions, f, delta, 1, 1) for _ in range(16)]
        designs = [pool.submit(stillpoint.design, v0=1, p=1, beta=0.9) for _ in range(16)]
        assert all(peak.result().peak_amplitude.tobytes() == wanted for peak in peaks)
        assert all(one.result().design == design for one in designs)


def references(function, objects):
    """By how much `function`, run 50 times, changes the count of each object."""
    def counts():
        return [sys.getrefcount(one) for one in objects]

    function()
    before = counts()
    for _ in range(50):
        function()
    return [after - count for after, count in zip(counts(), before)]


def test_references_are_released():
    f, delta = dampers(1000)
    options = {"v0": 1.5, "p": 1.25, "beta": 2.5}
    wrong = {"v0": "a", "p": 1.25, "beta": 2.5}

    def refused():
        with pytest.raises(stillpoint.InputError):
            stillpoint.region(**wrong)

    objects = [f, delta, options, wrong, *options.values(), stillpoint.Fields]
    for function in (lambda: stillpoint.motions(f, delta, 1, 1),
                     lambda: stillpoint.region(**options).region, lambda: stillpoint.design(options).report,
                     lambda: stillpoint.sweep(v0=1, p=1, f=f, delta=0.1).table, refused):
        assert references(function, objects) == [0] * len(objects)


def test_trajectory_keeps_its_memory():
    result = stillpoint.simulate(v0=1, p=1, f=0.02, delta=0.02, samples=1000)
    rows = result.trajectory
    first = rows.copy()
    del result
    junk = [stillpoint.simulate(v0=2, p=1, f=0.02, delta=0.02, samples=1000) for _ in range(20)]
    assert len(junk) == 20 and rows.tobytes() == first.tobytes()
    with pytest.raises(ValueError, match="read-only"):
        rows["x"] = 0
