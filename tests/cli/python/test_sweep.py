# SPDX-License-Identifier: MIT
"""The rows of a sweep in memory against those that the program writes."""

import json
import os
import subprocess
import sys

import numpy as np
import pytest
from conftest import ROOT, timeless

import stillpoint

SWEEPS = [
    {"v0": 1, "p": 1, "f": "0.001:0.35:50", "delta": "0:0.5:50"},
    {"v0": 1, "p": 1, "f": "1e-3:0.3:200:log", "delta": 0.01, "times": ""},
    {"v0": 1, "p": 1, "beta": "0.6:0.95:30"},
    {"velocity": "300mm/s:500mm/s:3", "period": "2.8s", "f": "0.01,0.02", "delta_m": "5mm"},
    {"p": 1, "f": "0.05:0.2:16", "delta": 0, "excitation": "harmonic", "k": 0.2, "lambda_": 0.35,
     "t_end": 20},
    {"v0": 1, "p": 1, "f": 0.1, "delta": 0.02, "damping": "0:20%:5", "breakaway": "1,1.5"},
    {"v0": 1, "p": 1, "f": 0.1, "delta": "0:0.5:9", "columns": "delta,outcome"},
]


@pytest.mark.parametrize("options", SWEEPS)
def test_rows_match_the_program(program, options):
    flags = {key: value for key, value in options.items() if value != ""}
    arguments = ["--times"] if "times" in options else []
    program.run("sweep", *arguments, output="rows.npy", **flags)
    wanted = np.load("rows.npy")
    found = stillpoint.sweep(**{key: value if value != "" else True for key, value in options.items()})
    assert found.table.dtype == wanted.dtype
    assert found.table.tobytes() == wanted.tobytes()


def test_rows_that_exceed_memory_are_refused():
    with pytest.raises(stillpoint.InputError, match="^the table takes .* GB of memory: give output"):
        stillpoint.sweep(v0=1, p=1, f="0:1:30000000", delta="0:1:30000000")


def test_axis_may_be_an_array():
    f, delta = np.linspace(0.001, 0.35, 11), np.linspace(0, 0.5, 7)
    found = stillpoint.sweep(v0=1, p=1, f=f, delta=delta)
    wanted = stillpoint.sweep(v0=1, p=1, f="0.001:0.35:11", delta="0:0.5:7")
    assert found.table.tobytes() == wanted.table.tobytes()
    assert np.array_equal(found.table["f"].reshape(11, 7)[:, 0], f)


def test_list_is_read(program):
    (program.folder / "list.csv").write_text("f,delta\n0.1,0.2\n0.2,0.1\n")
    found = stillpoint.sweep(v0=1, p=1, list="list.csv")
    assert found.table["f"].tolist() == [0.1, 0.2]


def test_report_matches_the_program(program):
    axes = {"v0": 1, "p": 1, "f": "0.001:0.35:20", "delta": "0:0.5:20"}
    wanted = timeless(program.report("sweep", output="rows.npy", **axes))
    found = timeless(stillpoint.sweep(**axes).report)
    assert found.pop("output") == {**wanted.pop("output"), "file": None}
    assert found == wanted


REDUCED = [
    {"v0": 1, "p": 1, "f": "0:0.35:15", "delta": "0:0.6:13", "times": True,
     "histogram": ["peak_amplitude:0.7:0.95:6", "stop_time:1:40:5:log"]},
    {"v0": "0.5:1:4", "p": 1, "beta": "0.4:0.9:23"},
    {"velocity": "300mm/s:500mm/s:30", "period": "2.8s", "f": "0.01,0.02", "delta_m": "5mm"},
    {"p": 1, "f": "0.05:0.2:16", "delta": 0, "excitation": "harmonic", "k": 0.2, "lambda_": 0.35,
     "t_end": 20},
]


@pytest.mark.parametrize("options", REDUCED)
def test_reduction_matches_the_program(program, options):
    flags = {key: value for key, value in options.items() if value is not True}
    arguments = ["--times"] if "times" in options else []
    done = program.run("sweep", "--reduce", "--json", *arguments, **flags)
    found = stillpoint.sweep(reduce=True, **options)
    assert json.dumps(found.report) == json.dumps(json.loads(done.stdout))  # with the order of keys
    assert found.table is None
    assert str(found) == program.run("sweep", "--reduce", *arguments, **flags).stdout
    assert " of " in repr(found) and found.report.part is None


def test_reduction_agrees_with_the_rows():
    axes = {"v0": 1, "p": 1, "f": "0:0.35:15", "delta": "0:0.6:13"}
    peaks = stillpoint.sweep(**axes).table["peak_amplitude"]
    edges = np.linspace(0.7, 0.95, 7)
    found = stillpoint.sweep(reduce=True, histogram="peak_amplitude:" + ",".join(map(str, edges)),
                             **axes)
    column = next(one for one in found.columns if one.column == "peak_amplitude")
    assert (column.least.peak_amplitude, column.largest.peak_amplitude) == (peaks.min(), peaks.max())
    assert column.least.entry == peaks.argmin() + 1 and column.count == len(peaks)
    (histogram,) = found.histograms
    assert histogram.counts == np.histogram(peaks, edges)[0].tolist()


def test_reduced_parts_merge_with_those_of_the_program(program):
    axes = {"v0": 1, "p": 1, "f": "0:0.35:20", "delta": "0:0.5:21"}
    first = stillpoint.sweep(reduce=True, part="1/2", output="r-{part}.json", **axes)
    assert first.part == {"number": 1, "count": 2}
    program.run("sweep", "--reduce", part="2/2", output="r-{part}.json", **axes)
    parts = ["r-2-of-2.json", program.folder / "r-1-of-2.json"]
    merged = program.run("sweep", "merge", "r.json", *parts)
    assert merged.returncode == 0, merged.stderr
    program.run("sweep", "--reduce", output="whole.json", **axes)
    whole = (program.folder / "whole.json").read_bytes()
    assert (program.folder / "r.json").read_bytes() == whole
    again = stillpoint.sweep(reduce=True, part="1/2", output="r-{part}.json", resume=True, **axes)
    assert again.report == first.report
    with pytest.raises(stillpoint.InputError, match="is part 1/2 of this sweep"):
        stillpoint.sweep(reduce=True, part="2/2", output="r-1-of-2.json", **axes)


def test_parts_are_those_of_the_program(program):
    axes = {"v0": 1, "p": 1, "f": "0:0.35:20", "delta": "0:0.5:21"}
    for i in (1, 2):
        stillpoint.sweep(part=f"{i}/2", output="here-{part}.npy", **axes)
        program.run("sweep", part=f"{i}/2", output="there-{part}.npy", **axes)
        here, there = (program.folder / f"{where}-{i}-of-2.npy" for where in ("here", "there"))
        assert here.read_bytes() == there.read_bytes()


@pytest.mark.parametrize("more", [
    {"histogram": "peak_amplitude:0:1:50"}, {"reduce": True, "histogram": "outcome:0:1:2"},
    {"reduce": True, "format": "npy"},
    {"reduce": True, "resume": True}])
def test_wrong_reduction_is_refused_as_the_program_does(program, more):
    axes = {"v0": 1, "p": 1, "f": "0:0.3:3", "delta": 0.1}
    flags = [f"--{key}" for key, value in more.items() if value is True]
    values = {key: value for key, value in more.items() if value is not True}
    with pytest.raises(stillpoint.InputError) as caught:
        stillpoint.sweep(**axes, **more)
    done = program.run("sweep", *flags, **axes, **values)
    assert done.returncode == 2 and done.stderr == f"stillpoint: {caught.value}\n"


def test_output_goes_to_a_file(program):
    axes = {"v0": 1, "p": 1, "f": "0:0.35:20", "delta": 0.1}
    found = stillpoint.sweep(output="here.csv", **axes)
    program.run("sweep", output="there.csv", **axes)
    assert found.table is None and found.rows == 20
    assert (program.folder / "here.csv").read_bytes() == (program.folder / "there.csv").read_bytes()


def test_fronts_match_the_designs():
    table = stillpoint.sweep(v0=1, p=1, beta=[0.9, 1.2], arrivals=2, trade_off=3).table.reshape(2, 3)
    assert np.array_equal(table["trade_off"], [[1, 2, 3]] * 2)
    for front, beta in zip(table, [0.9, 1.2]):
        report = stillpoint.design(v0=1, p=1, beta=beta, arrivals=2, trade_off=3).report
        for row, damper in zip(front, report["trade_off"]):
            for field in ("f", "delta", "tolerance", "peak_amplitude"):
                assert row[field] == damper[field]


def test_rows_outlive_the_result():
    rows = stillpoint.sweep(v0=1, p=1, f="0:0.3:1000", delta=0.1).table
    copy = rows.copy()
    junk = [stillpoint.sweep(v0=1, p=1, f="0:0.3:1000", delta=0.2) for _ in range(20)]
    assert len(junk) == 20 and rows.tobytes() == copy.tobytes()


def test_no_result_depends_on_threads():
    axes = {"v0": 1, "p": 1, "f": "0:0.3:300", "delta": "0:0.4:100"}
    one, many = (stillpoint.sweep(threads=n, **axes) for n in (1, 5))
    assert one.table.tobytes() == many.table.tobytes()


def test_record_matches_the_program():
    found = stillpoint.read_record(ROOT / "data/records/near_fault_pulse.txt")
    assert found.times.shape == found.accelerations.shape and found.times[0] == 0
    assert found.times.dtype == found.accelerations.dtype == np.float64
    half = stillpoint.read_record(ROOT / "data/records/near_fault_pulse.txt", record_scale=0.5)
    assert np.array_equal(half.accelerations, found.accelerations / 2)


def test_output_must_not_be_the_list(program):
    (program.folder / "list.csv").write_text("f,delta\n0.1,0.2\n")
    options = {"v0": 1, "p": 1, "list": "list.csv", "output": "list.csv"}
    with pytest.raises(stillpoint.InputError) as caught:
        stillpoint.sweep(**options)
    assert str(caught.value) == program.error("sweep", **options)


@pytest.mark.parametrize("stream", [0, 1, 2])
def test_a_closed_standard_stream_is_no_file(program, stream):
    axes = {"v0": 1, "p": 1, "f": 0.1, "delta": "0:1:5"}
    stillpoint.sweep(**axes, output="whole.csv")
    host = f"import os, stillpoint; stillpoint.sweep(**{axes}, output='rows.csv'); os.write({stream}, b'from the host')"
    subprocess.run([sys.executable, "-c", host], preexec_fn=lambda: os.close(stream), check=True)
    assert (program.folder / "rows.csv").read_bytes() == (program.folder / "whole.csv").read_bytes()
