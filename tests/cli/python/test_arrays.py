# SPDX-License-Identifier: MIT
"""Lists that are arrays: as in files, bit for bit, whatever the arrays, the threads, the parts."""

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


def table(f, delta, **options):
    return stillpoint.sweep(list={"f": f, "delta": delta}, **{"v0": 1, "p": 1, **options}).table


def test_a_list_of_arrays_is_one_in_a_file(program):
    f, delta = dampers(3000)
    rows = np.rec.fromarrays([f, delta], names="f,delta")
    np.savetxt("list.csv", rows, "%.17g", ",", header="f,delta", comments="")
    for options in ({}, {"times": True}, {"columns": "f,delta,outcome"}, {"threads": 2},
                    {"excitation": "half-sine", "k": 0.2, "lambda_": 0.5}):
        wanted = stillpoint.sweep(v0=1.25, p=0.75, list="list.csv", **options).table
        assert table(f, delta, v0=1.25, p=0.75, **options).tobytes() == wanted.tobytes()
        assert stillpoint.sweep(v0=1.25, p=0.75, list=rows, **options).table.tobytes() == wanted.tobytes()
    physical = {"velocity": 0.4, "period": 2.8}
    lengths = 0.01 * delta
    np.savetxt("metres.csv", np.column_stack([lengths, f]), "%.17g", ",", header="delta_m,f", comments="")
    found = stillpoint.sweep(list={"delta_m": lengths, "f": f}, **physical)
    assert found.table.tobytes() == stillpoint.sweep(list="metres.csv", **physical).table.tobytes()
    designs = stillpoint.sweep(list={"beta": [0.8, 0.9]}, v0=1, p=1)
    assert designs.table.tobytes() == stillpoint.sweep(beta=[0.8, 0.9], v0=1, p=1).table[
        [*designs.table.dtype.names]].tobytes()
    assert stillpoint.sweep(list={"f": f, "delta": delta}, v0=1, p=1, reduce=True).rows == 3000


def test_parts_of_arrays_are_of_one_sweep(program):
    f, delta = dampers(100)
    for i in (1, 2):
        stillpoint.sweep(list={"f": f, "delta": delta}, v0=1, p=1, part=f"{i}/2", output="r-{part}.npy")
    stillpoint.sweep(list={"f": f, "delta": delta[::-1]}, v0=1, p=1, part="2/2", output="other.npy")
    assert program.run("sweep", "merge", "r.npy", "r-1-of-2.npy", "r-2-of-2.npy").returncode == 0
    assert np.load("r.npy").tobytes() == table(f, delta).tobytes()
    assert "list has changed" in program.run("sweep", "merge", "r.npy", "r-1-of-2.npy", "other.npy").stderr


def test_single_damper_matches_simulate():
    for f, delta in zip(*dampers(20)):
        response = stillpoint.simulate(v0=1, p=1, f=f, delta=delta).response
        (row,) = table([f], [delta], times=True)
        for name in ("peak_amplitude", "half_cycles", "outcome", "stop_position", "stop_time"):
            value = stillpoint.outcomes[row[name]] if name == "outcome" else row[name]
            assert value == response[name], name


def test_numbers_of_any_kind_are_taken():
    (wanted,) = table([0.25], [0.5], v0=2.0)
    for f in (np.array([0.25], np.float32), np.array([0.25], np.longdouble), [Fraction(1, 4)], (0.25,)):
        assert table(f, np.array([0.5]), v0=np.int64(2))[0] == wanted
    f = np.linspace(0.01, 0.3, 10)
    assert table(f[::2], f[::2]).tobytes() == table(f, f)[::2].tobytes()
    assert len(table([], [])) == 0
    region = stillpoint.region(v0=1.0, p=1.0, beta=0.75).region
    assert stillpoint.region(v0=np.int64(1), p=np.float64(1), beta=np.float32(0.75)).region == region
    assert stillpoint.region(v0=np.longdouble(1), p=1, beta=np.longdouble(0.75)).region == region
    axis = np.linspace(0.01, 0.3, 5)
    assert np.array_equal(stillpoint.sweep(v0=1, p=1, f=axis.astype(np.longdouble), delta=0.1).table,
                          stillpoint.sweep(v0=1, p=1, f=axis, delta=0.1).table)


@pytest.mark.parametrize("wrong, says", [(-1, "f = -1: must be"), (np.nan, "f = nan: must be finite"),
                                         (np.inf, "f = inf: must be finite")])
@pytest.mark.parametrize("entries", [100, 200_000])
def test_wrong_entry_is_named(entries, wrong, says):
    f, delta = dampers(entries)
    f[entries - 7] = wrong
    with pytest.raises(stillpoint.InputError, match=rf"^list arrays, line {entries - 6}: {says}"):
        table(f, delta)


def test_wrong_lists_are_refused():
    for wrong, says in [({}, "no columns"), ({"g": [1]}, "not a column of a list"),
                        ({"f": [0.1], "delta": [0.1, 0.2]}, "delta has 2 values, but f has 1"),
                        ({"f": 0.1}, "^f = a column of the list: must be an array of numbers"),
                        ({"f": [[0.1]]}, "must be an array of numbers"), ({"f": "a"}, "must be an array")]:
        with pytest.raises(stillpoint.InputError, match=says):
            stillpoint.sweep(v0=1, p=1, delta=0.1, list=wrong)
    with pytest.raises(stillpoint.InputError, match="f.* also a column of the list"):
        stillpoint.sweep(v0=1, p=1, f=0.1, list={"f": [0.1], "delta": [0.1]})


@pytest.mark.parametrize("wrong", [
    True, np.True_, [True, 0.5], [0.5, np.False_], np.array([True, False]), [[0.5], [True]],
    np.array([0.5, True], object)])
def test_booleans_are_no_numbers(wrong):
    with pytest.raises(stillpoint.InputError, match="^f = a column of the list: must be an array"):
        table(wrong, [0.1, 0.1])
    with pytest.raises(stillpoint.InputError, match="^f = .*must be a number"):
        stillpoint.sweep(v0=1, p=1, f=wrong, delta=0.1)


def test_what_is_masked_is_refused():
    wrong = np.ma.masked_greater([0.1, 0.2, 99], 1)
    with pytest.raises(stillpoint.InputError, match="^f = .*no masked entries"):
        table(wrong, [0.1] * 3)
    with pytest.raises(stillpoint.InputError, match="^f = .*no masked entries"):
        stillpoint.sweep(v0=1, p=1, f=wrong, delta=0.1)
    for value in wrong[2], wrong[2:]:
        with pytest.raises(stillpoint.InputError, match="^beta = .*no masked entries"):
            stillpoint.region(v0=1, p=1, beta=value)
    bare = np.ma.masked_greater([0.1, 0.2], 1)  # nothing of it is masked
    assert table(bare, [0.1] * 2).tobytes() == table([0.1, 0.2], [0.1] * 2).tobytes()


def test_python_threads_run_side_by_side():
    f, delta = dampers(50_000)
    wanted = table(f, delta).tobytes()
    design = stillpoint.design(v0=1, p=1, beta=0.9).design
    with ThreadPoolExecutor(8) as pool:
        tables = [pool.submit(table, f, delta) for _ in range(16)]
        designs = [pool.submit(stillpoint.design, v0=1, p=1, beta=0.9) for _ in range(16)]
        assert all(rows.result().tobytes() == wanted for rows in tables)
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
    for function in (lambda: table(f, delta),
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
