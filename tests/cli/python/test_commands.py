# SPDX-License-Identifier: MIT
"""Each command against the program: the same report, number by number."""

import inspect
import json

import numpy as np
import pytest
from conftest import ROOT, timeless

import stillpoint

RECORD = ROOT / "data/records/near_fault_pulse.txt"
PHYSICAL = {"velocity": "400mm/s", "period": "2.8s", "max_displacement": "150mm"}
HARMONIC = {"excitation": "harmonic", "k": 0.2, "lambda_": 0.35}

INPUTS = [
    ("design", {"v0": 1, "p": 1, "beta": 0.9}),
    ("design", {"v0": 1, "p": 1, "beta": 0.5}),  # no damper
    ("design", {**PHYSICAL, "mass": "1200t", "objective": "time", "tolerance": 0.1}),
    ("design", {"v0": "0.8:1", "p": "1:1.2", "beta": 0.9}),
    ("design", {"v0": 1, "p": 1, "beta": 0.75, "arrivals": 3, "criterion": "exact"}),
    ("design", {"pulse": "half-sine", "k": 0.5, "pulse_duration": 0.07, "period": 2.8,
                "max_displacement": 0.1}),
    ("design", {"v0": 1, "p": 1, "beta": 0.9, "trade_off": 5}),
    ("design", {"v0": 1, "p": 1, "beta": 0.9, "catalogue": "parts.csv"}),
    ("design", {"record": [str(RECORD)], "period": 2.8, "max_displacement": "400mm",
                "search_f": "0:0.2", "search_delta_m": "0:50mm"}),
    ("region", {"pulse": "half-sine", "k": 0.5, "lambda_": 20, "p": 1, "beta": 0.05, "f": 0.01}),
    ("region", {"v0": 1.0, "p": 1.0, "beta": 0.9}),  # without settings
    ("region", {"v0": 1.0, "p": 1.0, "beta": 0.5}),  # the same, empty
    ("region", {"v0": 1, "p": 1, "beta": 0.8, "f": 0.3, "delta": 0.4}),
    ("region", {**PHYSICAL, "catalogue": "parts.csv"}),
    ("simulate", {"v0": 1, "p": 1, "f": 0.02, "delta": 0.02}),
    ("simulate", {"velocity": "400mm/s", "period": 3, "f": 0.02, "delta_m": "10mm"}),
    ("simulate", {"v0": 0.5, "p": 1, "f": 0.18, "delta": 0, "t_end": 200, **HARMONIC}),
    ("simulate", {"period": 2.8, "f": 0.02, "delta_m": 1e-3, "record": str(RECORD)}),
    ("simulate", {"v0": 1, "p": 1, "f": 0.1, "delta": 0.1, "friction_zones": "0.5:0.2,0.8:0.3"}),
    ("simulate", {"v0": 1, "p": 1, "f": 0.1, "delta": 0.02, "damping": "5%", "breakaway": 1.5}),
    ("spectrum", {"record": [str(RECORD)], "period": "2s:3s:2", "f": 0.05, "delta_m": "10mm", "damping": 0.1}),
    ("spectrum", {"record": [str(RECORD)], "period": "2s:3s:4", "f": 0.05, "delta_m": "10mm"}),
    ("spectrum", {"pulse": "half-sine", "k": "5g", "pulse_duration": "11ms", "period": "5ms:50ms:4", "f": 0.1, "delta_m": 0}),
    ("spectrum", {"velocity": 0.4, "period": "1s:3s:4", "f": 0.05, "delta_m": "2mm"}),
    ("spectrum", {"record": [str(RECORD)] * 2, "record_scale": 0.5, "period": "1:4:3:log", "f": 0,
                  "delta_m": 0.01, "hold": 0.1, "combine": "mean"}),  # without the notch it never rests
]


@pytest.mark.parametrize("command,options", INPUTS)
def test_report_matches_the_program(program, command, options):
    (program.folder / "parts.csv").write_text("name,f,delta\na,0.2,0.3\nb,0.26,0.37\n")
    found = getattr(stillpoint, command)(**options)
    wanted = timeless(program.report(command, **options))
    # repr has every digit of a float, and tells 1 from 1.0.
    assert repr(timeless(json.loads(json.dumps(found.report)))) == repr(wanted)


@pytest.mark.parametrize("command,name", [
    ("design", "isolator"), ("design", "pulse"), ("design", "parts"), ("design", "varying_hits"),
    ("region", "plain"), ("spectrum", "spectrum")])
def test_scene_matches_the_program(program, command, name):
    scene = ROOT / f"data/scenes/{name}.json"
    wanted = timeless(program.report(command, scene=scene))
    assert timeless(getattr(stillpoint, command)(scene).report) == wanted


def test_option_overrides_the_key_of_a_scene(program):
    scene = {"v0": 1, "p": 1, "beta": 0.9}
    found = stillpoint.design(scene, velocity=0.4, period=2.8, max_displacement=0.15)
    wanted = stillpoint.design(velocity=0.4, period=2.8, max_displacement=0.15)
    assert timeless(found.report) == timeless(wanted.report)


def test_fields_of_the_report_are_attributes():
    found = stillpoint.design(v0=1, p=1, beta=0.9)
    assert found.design.f == found.report["design"]["f"]
    assert found.report is found.report
    assert {*found.report, "report"} <= set(dir(found))
    assert "table" in dir(stillpoint.sweep(v0=1, p=1, f=0.1, delta=0.1))
    for name, value in found.report.items():
        assert getattr(found, name) == value
    with pytest.raises(AttributeError, match="no field 'colour'"):
        found.colour
    with pytest.raises(AttributeError, match="no field 'colour'"):
        found.design.colour


def test_axis_of_a_spectrum_may_be_an_array():
    damper = {"record": RECORD, "f": 0.05, "delta_m": 0.01}
    periods = np.array([1.1, 2.3, 2.9])
    found = stillpoint.spectrum(period=periods, **damper)
    assert [point.period_s for point in found.combined] == pytest.approx(periods, rel=1e-15)
    assert found.report == stillpoint.spectrum(period="1.1,2.3,2.9", **damper).report


def test_trajectory_matches_the_program(program):
    motion = {"v0": 1, "p": 1, "f": 0.02, "delta": 0.02}
    program.run("simulate", trajectory="rows.csv", samples=50, **motion)
    wanted = np.loadtxt("rows.csv", delimiter=",", skiprows=1)
    found = stillpoint.simulate(samples=50, **motion)
    for column, name in enumerate(("tau", "x", "v", "w", "absolute_acceleration", "friction")):
        assert np.array_equal(found.trajectory[name], wanted[:, column])
    assert stillpoint.simulate(**motion).trajectory is None
    assert stillpoint.simulate(t_end=3, **motion).trajectory["tau"][-1] == 3


def test_trajectory_of_physical_input_is_in_metres_and_seconds(program):
    motion = {"velocity": "0.4m/s", "period": "2.8s", "f": 0.02, "delta_m": 0.005}
    program.run("simulate", trajectory="rows.csv", samples=50, **motion)
    wanted = np.genfromtxt("rows.csv", delimiter=",", names=True)
    found = stillpoint.simulate(samples=50, **motion)
    dimensionless = ("tau", "x", "v", "w", "absolute_acceleration", "friction")
    physical = ("t_s", "x_m", "v_m_per_s", "w_m_per_s2", "absolute_acceleration_m_per_s2", "friction_m_per_s2")
    assert found.trajectory.dtype.names == wanted.dtype.names == dimensionless + physical
    for name in wanted.dtype.names:
        assert np.array_equal(found.trajectory[name], wanted[name])
    assert (found.trajectory["t_s"][0], found.trajectory["v_m_per_s"][0]) == (0, 0.4)
    assert found.trajectory["t_s"][-1] == found.physical.stop_time_s
    assert not found.trajectory.flags.writeable


def test_text_matches_the_program(program):
    motion = {"v0": 1, "p": 1, "f": 0.02, "delta": 0.02}
    found = stillpoint.simulate(**motion)
    assert str(found) == program.run("simulate", **motion).stdout
    assert repr(found) == "<Free motion: The mass stops at x = 0 after tau = 34.5989.>"


@pytest.mark.parametrize("command,options,figures", [
    ("design", {"v0": 1, "p": 1, "beta": 0.9}, 6), ("region", {"v0": 1.0, "p": 1.0, "beta": 0.9}, 1),
    ("simulate", {"v0": 1, "p": 1, "f": 0.02, "delta": 0.02}, 5),
    ("spectrum", {"record": str(RECORD), "period": "2:3:5", "f": 0.05, "delta_m": 0.01}, 3),
    ("sweep", {"v0": 1, "p": 1, "f": "0:0.3:20", "delta": "0:0.4:20"}, 1)])
def test_notebook_shows_the_figures_of_the_page(program, command, options, figures):
    html = getattr(stillpoint, command)(**options)._repr_html_()
    program.run(command, svg="drawn", **options, **({"output": "rows.csv"} if command == "sweep" else {}))
    drawn = sorted((program.folder / "drawn").iterdir())
    assert len(drawn) == figures
    for figure in drawn:
        assert figure.read_text().strip().splitlines()[-1] in html


@pytest.mark.parametrize("command", ["design", "region", "simulate", "spectrum", "sweep"])
def test_help_names_every_option(command):
    function = getattr(stillpoint, command)
    keywords = [name for name, _, _ in stillpoint.options(command)]
    assert [*inspect.signature(function).parameters] == ["scene", *keywords]
    assert ("lambda_" in keywords) == (command != "spectrum")
    for keyword in keywords:
        assert f"\n{keyword} " in inspect.getdoc(function)
