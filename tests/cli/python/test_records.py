# SPDX-License-Identifier: MIT
"""Records as arrays instead of files, and files with names of any bytes."""

import os
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, timeless

import stillpoint

PULSE = ROOT / "data/records/near_fault_pulse.txt"
STRONG = ROOT / "data/records/strong_motion.AT2"
DAMPER = {"period": "2.8s", "f": 0.05, "delta_m": 0.01}


def arrays(path):
    record = stillpoint.read_record(path)
    return record.times, record.accelerations


def without_names(report):
    """The report without what only a file says of its record."""
    if isinstance(report, dict):
        return {key: without_names(value) for key, value in report.items()
                if key not in ("file", "record", "records", "what", "motion", "description",
                               "record_step", "step")}
    return [without_names(entry) for entry in report] if isinstance(report, list) else report


@pytest.mark.parametrize("command,options", [
    ("simulate", {**DAMPER, "samples": 20}),
    ("spectrum", {"period": "2:3:5", "f": 0.05, "delta_m": 0.01}),
    ("design", {"period": "2.8s", "max_displacement": "400mm", "search_f": [0, 0.2],
                "search_delta_m": [0, 0.01], "scan_points": 100}),
    ("sweep", {"period": "2:3:5", "f": 0.05, "delta_m": 0.01})])
def test_arrays_are_as_good_as_a_file(command, options):
    function = getattr(stillpoint, command)
    found, wanted = function(record=arrays(PULSE), **options), function(record=PULSE, **options)
    assert without_names(timeless(found.report)) == without_names(timeless(wanted.report))
    for name in "table", "trajectory":
        assert np.asarray(getattr(found, name, 0)).tobytes() == np.asarray(getattr(wanted, name, 0)).tobytes()


def test_several_records_may_be_arrays_and_files():
    options = {"period": "2:3:5", "f": 0.05, "delta_m": 0.01}
    strong = arrays(STRONG)
    found = stillpoint.spectrum(record=[arrays(PULSE), STRONG, np.array(strong)], **options)
    wanted = stillpoint.spectrum(record=[PULSE, STRONG, STRONG], **options)
    assert [motion.what for motion in found.motions] == ["record 1", str(STRONG), "record 2"]
    assert found.report["combined"] == wanted.report["combined"]
    scene = {"record": [arrays(PULSE), str(STRONG), (list(strong[0]), list(strong[1]))], **options}
    assert stillpoint.spectrum(scene).report["combined"] == wanted.report["combined"]


def test_values_alone_need_a_step_and_units_are_options():
    times, values = arrays(STRONG)
    wanted = stillpoint.simulate(record=STRONG, **DAMPER).response
    alone = stillpoint.simulate(record=values, record_step=float(times[1]), **DAMPER)
    assert alone.response == wanted
    with pytest.raises(stillpoint.InputError, match="^record-step is missing: "):
        stillpoint.simulate(record=values, **DAMPER)
    metric = stillpoint.simulate(record=(times, values * 9.80665), record_units="m/s2", **DAMPER)
    assert metric.response.peak_amplitude == pytest.approx(wanted.peak_amplitude, rel=1e-12)
    read = stillpoint.read_record((times, values), record_scale=2)
    assert np.array_equal(read.accelerations, 2 * values) and np.array_equal(read.times, times)


@pytest.mark.parametrize("record,said", [
    (([0, 0.1, 0.2], [1, 2]), r"record = \(3 times, 2 values\): must have a time for each value"),
    (([0, 0.1, 0.1], [1, 2, 3]), "record record 1, line 3: time 0.1: must be more than the previous time, 0.1"),
    (([0, 0.1, 0.2], [0.1, np.nan, 0.1]), "record record 1, line 2, column 5: \"nan\" is not a finite number"),
    (np.zeros((5, 2)), r"record = an array of shape \(5, 2\): must be \(times, accelerations\)"),
    (np.ma.masked_greater([0.1, 9], 1), "record = .*no masked entries"),
    (([0, 1], ["a", "b"]), r"record = \['a', 'b'\]: must be a file, an array of numbers, or \(times, accel"),
    (([0, 0.1], [False, True]), r"record = \[False, True\]: must be a file, an array of numbers"),
    (([], []), r"record = \[\]: must be a file, an array of numbers"), ([], "record = "),
    (5, "record = 5: must be one path")])
def test_wrong_arrays_are_refused(record, said):
    with pytest.raises(stillpoint.InputError, match="^" + said):
        stillpoint.simulate(record=record, **DAMPER)


def test_a_file_of_the_name_of_an_array_is_another_record(program):
    (program.folder / "record 1").mkdir()
    found = stillpoint.spectrum(record=arrays(PULSE), period="2:3:3", f=0.05, delta_m=0.01)
    assert found.motions[0].what == "record 1'"


@pytest.mark.parametrize("kind", [os.fsencode, Path, str])
def test_names_may_have_any_bytes(program, kind):
    name = os.fsdecode(b"pul\xffse.txt")
    path = program.folder / name
    path.write_bytes(PULSE.read_bytes())
    found = stillpoint.simulate(record=kind(path), **DAMPER)
    assert found.response == stillpoint.simulate(record=PULSE, **DAMPER).response
    assert found.input.excitation.record == str(path)
    str(found), repr(found), found._repr_html_()
    assert stillpoint.read_record(kind(path)).file == str(path)
    with pytest.raises(stillpoint.InputError) as caught:
        stillpoint.simulate(record=kind(program.folder / ("no" + name)), **DAMPER)
    assert "no such file" in str(caught.value).lower() and name in str(caught.value)
    scene = program.folder / os.fsdecode(b"sc\xffene.json")
    scene.write_text('{"v0": 1, "p": 1, "beta": 0.9}')
    assert stillpoint.design(kind(scene)).design == stillpoint.design(v0=1, p=1, beta=0.9).design
    stillpoint.sweep(v0=1, p=1, f="0:0.3:5", delta=0.1, output=kind(program.folder / ("rows" + name + ".npy")))
    assert len(np.load(program.folder / ("rows" + name + ".npy"))) == 5


@pytest.mark.parametrize("f", [0.03, [0.03, 0.03], "0.03:0.03", np.array([0.03, 0.03])])
def test_a_search_takes_one_value_or_a_range(f):
    options = {"record": PULSE, "period": "2.8s", "max_displacement": 1, "scan_points": 100}
    found = stillpoint.design(search_f=f, search_delta_m="0:5mm", **options)
    assert found.design.f == 0.03
    assert timeless(found.report) == timeless(
        stillpoint.design(search_f="0.03:0.03", search_delta_m=[0, 0.005], **options).report)
