# SPDX-License-Identifier: MIT
"""write_stub.py DIR TEMPLATE OUT: the type stub of the package in DIR, from TEMPLATE and its options."""

import re
import sys
from pathlib import Path

folder, template, out = sys.argv[1:]
sys.path.insert(0, folder)
import stillpoint  # noqa: E402


def keywords(command):
    return "".join(f"    {name}: {kind} | None = None,\n"
                   for name, kind, _ in stillpoint.options(command[1]))


Path(out).write_text(re.sub(r"    @(\w+)@\n", keywords, Path(template).read_text()))
