# SPDX-License-Identifier: MIT
"""Wrong input has the program's text, doubtful input its warning; an interrupt ends a run."""

import os
import signal
import subprocess
import sys
import threading
import time
import types

import numpy as np
import pytest
from conftest import ROOT

import stillpoint

RECORD = ROOT / "data/records/near_fault_pulse.txt"
SLOW = {"excitation": "harmonic", "k": 0.2, "lambda_": 0.35, "t_end": 1e12}


@pytest.mark.parametrize("command,options", [
    ("design", {"v0": -1, "p": 1, "beta": 0.9}),
    ("design", {"v0": float("nan"), "p": 1, "beta": 0.9}),
    ("design", {"v0": 1, "p": 1}),
    ("design", {"v0": 1, "velocity": 1, "p": 1, "beta": 1}),
    ("design", {"v0": 1, "p": 1, "beta": 0.9, "objective": "beauty"}),
    ("design", {"v0": 1, "p": 1, "beta": 0.9, "algorithm": ""}),
    ("design", {"v0": "1:0", "p": 1, "beta": 0.9}),
    ("design", {"velocity": "3kg", "period": 1, "max_displacement": 1}),
    ("design", {"record": "nowhere.at2", "period": 1, "max_displacement": 1}),
    ("region", {"v0": 1.0, "p": 0.0, "beta": 0.9}),
    ("region", {"v0": 1, "p": 1, "beta": 1, "delta": 0.1}),
    ("simulate", {"v0": 1, "p": 1, "f": 1e-12, "delta": 1e-12}),
    ("simulate", {"v0": 1, "p": 1, "f": 0.1, "delta": 0, "damping": 1}),
    ("simulate", {"v0": 1, "p": 1, "f": 0.1, "delta": 0, "damping": "5mm"}),
    ("simulate", {"v0": 1, "p": 1, "f": 0.1, "delta": 0, "breakaway": 0.5}),
    ("simulate", {"v0": 1, "p": 1, "f": 0.1, "delta": 0, "excitation": "harmonic", "k": 1}),
    ("spectrum", {"record": "nowhere.at2", "period": "1:2:3", "f": 0.1, "delta_m": 0.01}),
    ("spectrum", {"period": "1:2:3", "f": 0.1, "delta_m": 0.01}),
    ("spectrum", {"period": "1:2", "f": 0.1, "delta_m": 0.01}),
    ("sweep", {"v0": 1, "p": 1, "f": "0:1", "delta": 0}),
    ("sweep", {"v0": 1, "p": 1, "f": "-1:1:5", "delta": 0}),
    ("sweep", {"v0": 1, "p": 1, "f": 0.1, "delta": 0, "columns": "colour"}),
])
def test_text_matches_the_program(program, command, options):
    with pytest.raises(stillpoint.InputError) as caught:
        getattr(stillpoint, command)(**options)
    assert str(caught.value) == program.error(command, **options)
    assert isinstance(caught.value, ValueError)


@pytest.mark.parametrize("options,text", [
    ({"vo": 1}, "vo: unknown option; did you mean v0?"),
    ({"f": 0.1}, "f: is not an option of design"),
    ({"json": True}, "json: is not an option of design"),
    ({"v0": "fast"}, 'v0 = "fast": must be a number, or a range [LOW, HIGH]'),
    ({"v0": 1 + 1j}, "v0 = (1+1j): must be a number, a string or a list of them"),
    ({"v0": 10**30}, "v0 = 1000000000000000000000000000000: must be a whole number of at most 18 digits"),
    ({"arrivals": 1.5}, "arrivals = 1.5: must be a whole number from 1 to 1000"),
    ({"beta": [1, 2]}, "beta = [1,2]: must be one number, not a range"),
    ({"catalogue": 5}, "catalogue = 5: must be a path"),
    ({"objective": 5}, "objective = 5: must be a string"),
    ({"record": ["a", 5]}, "record = 5: must be a path"),
])
def test_what_only_python_can_get_wrong_is_named(options, text):
    with pytest.raises(stillpoint.InputError) as caught:
        stillpoint.design(**options)
    assert str(caught.value) == text


def test_recursive_scene_is_refused():
    scene = {}
    scene["excitation"] = scene
    with pytest.raises(RecursionError):
        stillpoint.design(scene)


def test_scene_is_refused_as_the_program_does(program):
    (program.folder / "scene.json").write_text('{"v0": 1,\n "p": }')
    with pytest.raises(stillpoint.InputError) as caught:
        stillpoint.design("scene.json")
    assert str(caught.value) == program.error("design", scene="scene.json")
    for command in ("design", "region", "sweep"):
        (program.folder / "scene.json").write_text('{"v0": 1, "p": 1,\n "beta": -1}')
        with pytest.raises(stillpoint.InputError, match="line 2, column 2: beta = -1") as caught:
            getattr(stillpoint, command)("scene.json")
        assert str(caught.value) == program.error(command, scene="scene.json")


def test_doubtful_value_gives_a_warning(program):
    options = {"velocity": 0.4, "period": 2.8, "max_displacement": 150}
    with pytest.warns(UserWarning) as caught:
        stillpoint.design(**options)
    said = program.run("design", **options).stderr
    assert f"warning: {caught[0].message}" in said


@pytest.fixture
def interrupt():
    """An interrupt from another thread, a moment from now."""
    timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    yield
    timer.join()


def test_interrupt_ends_a_motion(interrupt):
    with pytest.raises(KeyboardInterrupt):
        stillpoint.simulate(v0=0.5, p=1, f=0.18, delta=0, **SLOW)
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_interrupt_ends_slow_motions(interrupt):
    with pytest.raises(KeyboardInterrupt):
        stillpoint.sweep(list={"f": [5e-11] * 300}, delta=1e-13, v0=1, p=1, half_cycle_limit=1e11)


def test_interrupt_ends_a_sweep(interrupt):
    with pytest.raises(KeyboardInterrupt):
        stillpoint.sweep(v0=1, p=1, f="1e-7:1.1e-7:1000000", delta=1e-5, columns="peak_amplitude")


def test_interrupt_ends_a_sweep_without_rows(interrupt):
    with pytest.raises(KeyboardInterrupt):
        stillpoint.sweep(v0=1, p=1, f="1e-7:1.1e-7:1000000", delta=1e-5, reduce=True)


def test_interrupt_ends_a_design_under_records(interrupt):
    with pytest.raises(KeyboardInterrupt):
        stillpoint.design(record=[RECORD] * 100, period=4, max_displacement=0.4, hold=0.1)


def test_interrupt_ends_a_spectrum(interrupt):
    with pytest.raises(KeyboardInterrupt):
        stillpoint.spectrum(record=[RECORD] * 100, period="1:4:10000", f=2e-5, delta_m=1e-7)


@pytest.mark.parametrize("options", [
    {"v0": 1, "p": 1, "beta": 2, "arrivals": 1000},
    {"v0": 1, "p": 1, "beta": 1, "arrivals": 1000, "trade_off": 1000},
    {"pulse": "half-sine", "k": "0.3:0.5", "lambda_": "0.02:20", "p": "1:1.5", "beta": 3, "tolerance": 0.2},
])
def test_interrupt_ends_a_design(interrupt, options):
    begun = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        stillpoint.design(**options)
    assert time.monotonic() - begun < 10


@pytest.fixture(scope="module")
def many_parts(tmp_path_factory):
    path = tmp_path_factory.mktemp("catalogue") / "parts.csv"
    parts = "".join(f"P{i},{0.35 * i / 1e5},{0.5 * (i * 0.618 % 1)}\n" for i in range(100_000))
    path.write_text("name,f,delta\n" + parts)
    return path


@pytest.mark.parametrize("command", ["design", "sweep"])
def test_interrupt_ends_a_choice_of_many_parts(many_parts, interrupt, command):
    with pytest.raises(KeyboardInterrupt):
        while True:
            getattr(stillpoint, command)(v0=1, p=1, beta=0.9, arrivals=8, residual=0.05, catalogue=many_parts)


def test_interrupt_ends_a_free_motion(interrupt):
    with pytest.raises(KeyboardInterrupt):
        stillpoint.simulate(v0=1, p=1, f=1e-11, delta=1e-14, half_cycle_limit=1e12)


def test_interrupt_ends_arrays(interrupt):
    with pytest.raises(KeyboardInterrupt):
        while True:
            stillpoint.sweep(list={"f": [1e-6] * 1000}, delta=1e-12, v0=1, p=1)


def test_scenes_and_paths_are_accepted_or_refused_by_name(program):
    plain = {"v0": 1, "p": 1, "beta": 0.9}
    assert stillpoint.region(types.MappingProxyType(plain)).report == stillpoint.region(plain).report
    for scene in (5, [1], bytearray(b"x"), 1j):
        with pytest.raises(stillpoint.InputError, match="^scene = "):
            stillpoint.region(scene)
    for record in (5, ["a"], None):
        with pytest.raises(stillpoint.InputError, match="^record = .*: must be a path$"):
            stillpoint.read_record(record)
    (program.folder / "a").write_text("{}")
    with pytest.raises(stillpoint.InputError, match="null character"):
        stillpoint.region("a\0b")
    with pytest.raises(ValueError, match="surrogates"):
        stillpoint.region("\ud800")
    with pytest.raises(stillpoint.InputError, match="^command = colour: must be design"):
        stillpoint.options("colour")


def test_axes_may_be_any_sequence():
    whole = stillpoint.sweep(v0=1, p=1, f=[1, 2], delta=0.1).table
    assert stillpoint.sweep(v0=1, p=1, f=range(1, 3), delta=0.1).table.tobytes() == whole.tobytes()
    for axis in (b"12", (x for x in (0.1, 0.2)), {0.1, 0.2}):
        with pytest.raises(stillpoint.InputError, match="^f = "):
            stillpoint.sweep(v0=1, p=1, f=axis, delta=0.1)


@pytest.mark.parametrize("wrong", [1j, ["a"], ["0.1"], np.array([1j]), np.array(["2020"], "M8[Y]"), {}])
def test_arrays_are_of_numbers(wrong):
    with pytest.raises(stillpoint.InputError, match="^f = a column of the list: must be an array of numbers$"):
        stillpoint.sweep(list={"f": wrong}, delta=0.1, v0=1, p=1)


COMMAS = """
import locale, sys
if len(sys.argv) > 1:
    locale.setlocale(locale.LC_NUMERIC, sys.argv[1])
    assert locale.str(0.5) == "0,5"
import stillpoint
for options in ({"velocity": "400.5mm/s", "period": "2.8s", "max_displacement": "150mm"},
                {"v0": 1, "p": 1, "beta": 0.7}):
    for command in stillpoint.design, stillpoint.region:
        found = command(**options)
        print(found.report["region"], found, found._repr_html_())
print(stillpoint.sweep(v0="0.5:1:3", p=1, f="0.01,0.02", delta="1e-3:0.1:4:log").table.tobytes())
"""


def test_decimal_commas_of_the_host_change_nothing(tmp_path):
    (tmp_path / "source").write_text(
        'LC_NUMERIC\ndecimal_point ","\nthousands_sep "."\ngrouping 3;3\nEND LC_NUMERIC\n')
    # It complains because the source defines nothing else.
    subprocess.run(["localedef", "-c", "--quiet", "-i", "source", "-f", "UTF-8", "./comma"], cwd=tmp_path, check=False)
    plain, commas = (
        subprocess.run([sys.executable, "-c", COMMAS, *name], env={**os.environ, "LOCPATH": str(tmp_path)},
                       capture_output=True, text=True, check=True).stdout for name in ((), ("comma",)))
    assert "f >= 0.364286" in plain  # (1 - 0.49) / 1.4
    assert commas == plain
