# SPDX-License-Identifier: MIT
"""histogram.py [ROWS]: how far dampers move whose friction, notch and hit all vary (default 10^7)."""

import sys

import numpy as np

import stillpoint

rows = int(float(sys.argv[1])) if len(sys.argv) > 1 else 10**7
side = 100 if rows >= 10**6 else 10

# A design, then every combination of a hit, an f and a delta up to 20 % off.
design = stillpoint.design(v0=1, p=1, beta=0.9).design
found = stillpoint.sweep(
    v0=np.linspace(0.8, 1.2, rows // side**2), p=1, f=np.linspace(0.8, 1.2, side) * design.f,
    delta=np.linspace(0.8, 1.2, side) * design.delta, columns="peak_amplitude,outcome")
peaks = found.table["peak_amplitude"]
print(f"{len(peaks)} motions, {found.outcomes.stopped_at_zero / len(peaks):.1%} stop at x = 0")

counts, edges = np.histogram(peaks, bins=12)
for count, low, high in zip(counts, edges, edges[1:]):
    print(f"{low:6.3f} to {high:6.3f}  {'#' * round(60 * count / counts.max())}")
