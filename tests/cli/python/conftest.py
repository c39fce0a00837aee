# SPDX-License-Identifier: MIT
"""What the tests of the module share: the program to compare with."""

import json
import os
import signal
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]

# A job in the background ignores interrupts, and hands that on.
signal.signal(signal.SIGINT, signal.default_int_handler)


class Program:
    """The program, run in a directory of the test's own."""

    def __init__(self, folder):
        self.folder = folder

    def run(self, command, *arguments, scene=None, **options):
        texts = [command, *([str(scene)] if scene else []), *map(str, arguments)]
        for keyword, value in options.items():
            for one in value if isinstance(value, list) else [value]:
                texts += ["--" + keyword.rstrip("_").replace("_", "-"), str(one)]
        return subprocess.run(
            [os.environ["STILLPOINT_PROGRAM"], *texts],
            cwd=self.folder, capture_output=True, text=True, check=False)

    def report(self, command, **options):
        run = self.run(command, "--json", **options)
        assert run.stdout, run.stderr
        return json.loads(run.stdout)

    def error(self, command, **options):
        run = self.run(command, **options)
        assert run.returncode == 2 and not run.stdout
        return run.stderr.removeprefix("stillpoint: ").removesuffix("\n")


@pytest.fixture
def program(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return Program(tmp_path)


def timeless(report):
    """The report without the times of the wall clock."""
    if isinstance(report, dict):
        return {key: timeless(value) for key, value in report.items()
                if key not in ("wall_time_s", "rows_per_s")}
    return [timeless(entry) for entry in report] if isinstance(report, list) else report
