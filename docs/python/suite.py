# SPDX-License-Identifier: MIT
"""suite.py RECORD...: one damper for a suite of acceleration records, and its motion under each record."""

import sys

import numpy as np

import stillpoint

files = sys.argv[1:]
isolator = {"period": "2.8s"}

for file in files:
    record = stillpoint.read_record(file)
    print(f"{file}: {record.times[-1]:.1f} s, up to {np.abs(record.accelerations).max():.3f} g")

found = stillpoint.design(
    record=files, max_displacement="400mm", residual_m="30mm", search_notch_width_m="10mm:300mm", **isolator)
print(found)

# The same motions one by one, with their trajectories.
design = found.design
for row in found.cases[0].motions:
    motion = stillpoint.simulate(
        record=row.what, f=design.f, delta_m=design.delta_m, notch_width_m=design.notch_width_m,
        samples=200, **isolator)
    peak = np.abs(motion.trajectory["x_m"]).max()
    print(f"{row.what}: peak {peak:.4f} m, rests at {motion.physical.stop_position_m:.4f} m")
    assert abs(peak - row.physical.peak_m) <= 1e-9 * peak
