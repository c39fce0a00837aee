# SPDX-License-Identifier: MIT
"""Elastic spectra by the exact matrix of a step with a linear load (Nigam and Jennings, 1969)."""

import math

import numpy as np

PARTS = 10  # of an interval: what Hermite's cubic misses of an extreme falls with the fourth power
G = 9.80665


def read_at2(file):
    """Step in s and values in m/s2 of a PEER file; the ground is at rest before the first."""
    lines = file.read_text().splitlines()
    step = next(float(word) for word in lines[3].replace("=", " ").replace(",", " ").split()
                if word.startswith((".", "0.")))
    return step, G * np.array([float(word) for line in lines[4:] for word in line.split()])


def transition(omega, zeta, h):
    """x, v after h = exp(-zeta omega h) M (x, v) + the parts of a load -(w0 + slope t)."""
    damped = omega * math.sqrt(1 - zeta**2)
    decay, c, s = math.exp(-zeta * omega * h), math.cos(damped * h), math.sin(damped * h)
    return decay * np.array([[c + zeta * omega / damped * s, s / damped],
                             [-omega**2 / damped * s, c - zeta * omega / damped * s]])


def elastic_spectrum(step, values, periods, zeta):
    """The largest |x| in m and |x'' + w| in m/s2 for each period, until the free motion is half."""
    found = []
    for period in periods:
        omega = 2 * math.pi / period
        h = step / PARTS
        matrix = transition(omega, zeta, h)
        quiet = np.zeros(math.ceil(2 * period / step))
        ground = np.concatenate([values, quiet])
        state = np.zeros(2)
        peaks = [0.0, 0.0]
        for w0, w1 in zip(ground, ground[1:]):
            slope = (w1 - w0) / step
            for part in range(PARTS):
                w = w0 + slope * part * h
                # The particular solution of a load -(w + slope t).
                shift = np.array([-w / omega**2 + 2 * zeta * slope / omega**3, -slope / omega**2])
                after = matrix @ (state - shift) + shift + np.array([-slope / omega**2 * h, 0])
                peaks[0] = max(peaks[0], extreme(state[0], after[0], state[1], after[1], h))
                felt = [2 * zeta * omega * s[1] + omega**2 * s[0] for s in (state, after)]
                rates = [2 * zeta * omega * (-load - felt_at) + omega**2 * s[1] for load, felt_at, s
                         in ((w, felt[0], state), (w + slope * h, felt[1], after))]
                peaks[1] = max(peaks[1], extreme(*felt, *rates, h))
                state = after
        found.append(peaks)
    return found


def extreme(y0, y1, d0, d1, h):
    """The largest |y| of Hermite's cubic between two points."""
    best = max(abs(y0), abs(y1))
    if d0 * d1 < 0:
        # Its derivative, a quadratic in t/h, by halving.
        a, b = 0.0, 1.0
        slope = 3 * (y1 - y0) / h
        rate = lambda t: d0 + t * (2 * slope - 4 * d0 - 2 * d1 + t * (3 * (d0 + d1) - 2 * slope))
        for _ in range(40):
            middle = (a + b) / 2
            a, b = (middle, b) if rate(middle) * d0 > 0 else (a, middle)
        t = a
        best = max(best, abs(y0 + t * h * (d0 + t * ((slope - 2 * d0 - d1) + t * (d0 + d1 - 2 * slope / 3)))))
    return best
