# SPDX-License-Identifier: MIT
"""write_stub.py DIR TEMPLATE OUT: the type stub of the package in DIR, from TEMPLATE and its options."""

import sys
from pathlib import Path

folder, template, out = sys.argv[1:]
sys.path.insert(0, folder)
import stillpoint  # noqa: E402


def keywords(command):
    return "".join(f"    {name}: {kind} | None = None,\n"
                   for name, kind, _ in stillpoint.options(command))


text = Path(template).read_text()
for command in "design", "region", "simulate", "spectrum", "sweep":
    text = text.replace(f"    @{command}@\n", keywords(command))
Path(out).write_text(text)
