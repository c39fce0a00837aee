# SPDX-License-Identifier: MIT
"""region.py [POINTS [FILE.png]]: which dampers work for an isolator, and where the design lies.

Each of POINTS x POINTS dampers is followed (default 400). With matplotlib the plane is drawn into
FILE.png (default region.png).
"""

import sys

import numpy as np

import stillpoint

points = int(sys.argv[1]) if len(sys.argv) > 1 else 400
file = sys.argv[2] if len(sys.argv) > 2 else "region.png"

found = stillpoint.design(velocity="400mm/s", period="2.8s", max_displacement="150mm", mass="1200t")
print(found)

# All dampers of the plane at once, dimensionless: f down, delta across.
task, design = found.input, found.design
f = np.linspace(0, 2 * design.f, points)
delta = np.linspace(0, 2 * design.delta, points)
motions = stillpoint.sweep(v0=task.v0, p=task.p, f=f, delta=delta).table.reshape(points, points)
stops = motions["outcome"] == stillpoint.outcomes.index("stopped_at_zero")
works = stops & (motions["half_cycles"] == 1) & (motions["peak_amplitude"] <= task.beta)
print(f"{works.mean():.1%} of the dampers stop at x = 0 on their first return, within the stroke")

nearest = np.abs(f - design.f).argmin(), np.abs(delta - design.delta).argmin()
assert works[nearest]

try:
    import matplotlib
except ImportError:
    sys.exit("without matplotlib there is no picture")
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

figure, axes = plt.subplots(figsize=(6, 4.5))
shades = axes.pcolormesh(f, delta, np.where(works, motions["peak_amplitude"] / task.beta, np.nan).T)
figure.colorbar(shades, label="peak / largest admissible displacement")
axes.plot(design.f, design.delta, "o", color="tab:orange", label="design")
box = design.tolerance
axes.add_patch(plt.Rectangle(
    (design.f * (1 - box), design.delta * (1 - box)), 2 * design.f * box, 2 * design.delta * box,
    fill=False, edgecolor="tab:orange", label=f"+-{box:.0%}"))
axes.set(xlabel="friction f", ylabel="point friction $\\Delta$", title="Dampers that work")
axes.legend()
figure.savefig(file, dpi=120)
print(f"drawn in {file}")
