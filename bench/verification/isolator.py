# SPDX-License-Identifier: MIT
"""A pendulum isolator by the equivalent linear method, and records whose spectrum it assumes."""

import math
from dataclasses import dataclass

import numpy as np

G = 9.80665
TABLE = [(0.02, 0.8), (0.05, 1.0), (0.1, 1.2), (0.2, 1.5), (0.3, 1.7), (0.4, 1.9), (0.5, 2.0)]


@dataclass
class Estimate:
    """In m and s; damping as a share of critical damping, and what divides the spectrum for it."""
    displacement: float
    period: float
    damping: float
    reduction: float


def equivalent_linear(radius, friction, one_second):
    """ASCE/SEI 7, chapter 17: the displacement that its own period and damping give."""
    d = 0.3
    for _ in range(200):
        period = math.tau * math.sqrt(1 / (G * (1 / radius + friction / d)))
        damping = 2 / math.pi * friction / (friction + d / radius)
        reduction = float(np.interp(damping, *zip(*TABLE)))
        d = G * one_second * period / (4 * math.pi**2 * reduction)
    return Estimate(d, period, damping, reduction)


def matched_records(program, folder, one_second):
    """Seven files of 60 s whose spectra at 5 % are one_second/T in g within 10 %, 0.5 s to 5 s.

    Sines with random phases under an envelope, each amplitude divided by how far the spectrum, which the
    program computes, is too high at its period. Phases that are not within after twelve rounds are left out."""
    step, count = 0.01, 6000
    t = step * np.arange(count)
    envelope = np.minimum(1, t / 5) * np.where(t > 30, np.exp(-(t - 30) / 8), 1)
    periods = np.geomspace(0.25, 8, 160)
    asked = np.geomspace(0.3, 6, 60)
    inside = (asked >= 0.5) & (asked <= 5)
    found = 0
    for seed in range(100):
        random = np.random.Generator(np.random.PCG64(seed))
        waves = np.sin(math.tau / periods[:, None] * t + random.uniform(0, math.tau, (len(periods), 1)))
        amplitudes = one_second / periods * 0.1
        file = folder / f"matched_{seed}.txt"
        for _ in range(12):
            ground = envelope * (amplitudes @ waves)
            np.savetxt(file, np.column_stack([t, ground]), fmt="%.2f %.9e")
            rows = program.text(f"spectrum --record {file} --period {','.join(f'{p:.9g}' for p in asked)} "
                                "--f 0 --delta-m 0 --damping 5% --table -").split()[1:]
            pseudo = np.array([float(row.split(",")[2]) for row in rows]) * (math.tau / asked)**2 / G
            ratio = pseudo * asked / one_second
            if np.all(np.abs(ratio[inside] - 1) < 0.1):
                found += 1
                yield file
                break
            amplitudes = amplitudes / np.interp(periods, asked, ratio)
        if found == 7:
            return
