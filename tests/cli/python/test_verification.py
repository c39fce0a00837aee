# SPDX-License-Identifier: MIT
"""docs/verification.md is what bench/verification/verify.py writes; the script checks each figure."""

import os
import re
import shutil
import subprocess
import sys

from conftest import ROOT


def figures(page):
    """Without differences, which hang on the last bit of another machine's mathematical library."""
    return re.sub(r"-?\d+e[+-]\d+ \|", "~ |", page.read_text(encoding="utf-8"))


def test_the_page_shows_what_the_program_prints(tmp_path):
    page = tmp_path / "verification.md"
    shutil.copy(ROOT / "docs" / "verification.md", page)
    run = subprocess.run([sys.executable, ROOT / "bench" / "verification" / "verify.py",
                          os.environ["STILLPOINT_PROGRAM"], page],
                         capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert figures(page) == figures(ROOT / "docs" / "verification.md")
