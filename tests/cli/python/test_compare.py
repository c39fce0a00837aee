# SPDX-License-Identifier: MIT
"""./dev compare finds what differs between two programs, and nothing else."""

import json
import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
PROGRAM = os.environ["STILLPOINT_PROGRAM"]


def compared(program, *words):
    script = ROOT / "tests" / "compare" / "compare.py"
    return subprocess.run([sys.executable, script, PROGRAM, ROOT, program, ROOT, *words],
                          capture_output=True, text=True, check=False)


@pytest.fixture
def edited(tmp_path):
    """The program behind a script that edits its output."""
    def make(edit):
        program = tmp_path / "edited"
        program.write_text(f'#!/bin/sh\n"{PROGRAM}" "$@" | sed "{edit}"\n')
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        return program
    return make


def test_a_program_does_not_differ_from_itself():
    answer = compared(PROGRAM, "--tasks", "60")
    assert answer.returncode == 0, answer.stdout
    assert "60 commands, 0 differ; seed 1" in answer.stdout
    answer = compared(PROGRAM, "--only", "isolator.json")
    assert answer.returncode == 0, answer.stdout
    assert ", 0 differ" in answer.stdout and not answer.stdout.startswith("\n0 commands")


def test_a_number_that_differs_is_shown(edited):
    answer = compared(edited("s/.peak_amplitude.: /&1/"), "--tasks", "20")
    assert answer.returncode == 1
    assert "response.peak_amplitude: " in answer.stdout


def test_words_that_differ_are_shown(edited):
    answer = compared(edited("s/independent methods/independent ways/"), "--only", "design data/scenes/isolator.json")
    assert answer.returncode == 1
    assert "+  checks            2 independent ways agree" in answer.stdout


def test_renamed_fields_are_compared(monkeypatch):
    monkeypatch.syspath_prepend(ROOT / "tests" / "compare")
    import compare
    old = json.dumps({"cases": [{"peak": 1.5, "at": 2}], "status": "ok"})
    new = json.dumps({"case": [{"stroke": 1.5}], "status": "ok"})
    table = {"cases[].peak": "case[].stroke", "cases[].at": None}
    assert compare.differing_fields(old, new, table, 0) == []
    assert compare.differing_fields(old, new.replace("1.5", "1.6"), table, 0) == ["cases[0].peak: 1.5 -> 1.6"]
    assert compare.differing_fields(old, new.replace("1.5", "1.6"), table, 0.1) == []
    assert compare.differing_fields(old, new, {}, 0) == [
        "cases[0].peak: 1.5 -> no field cases[0].peak", "cases[0].at: 2 -> no field cases[0].at"]
