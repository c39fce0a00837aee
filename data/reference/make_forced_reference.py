#!/usr/bin/env python3
"""Writes forced_motion.csv: forced and damped motions to 30 digits, by means of its own.

Shares nothing with the C++ kernel but the rules (docs/forced.md and docs/damping.md, section 1 of
each). Between events the motion
is the textbook solution with constants fitted to the start of the piece; events are bracketed on a
grid of PHASE_STEP and bisected; a record is walked sample by sample. Every case is run with two grids
and two precisions, which must agree.

Columns: name, x0, v0, p, f, delta, zeta, breakaway, then of W = k sin(lambda tau + phase) k, lambda, phase (of the record
of scene S5 `record`), t_end; then the results. Inputs are exact doubles.
Needs Python 3 and mpmath; takes about three minutes. Usage: make_forced_reference.py
"""
import csv
from pathlib import Path

from mpmath import mp, mpf

INPUTS = ("name", "x0", "v0", "p", "f", "delta", "zeta", "breakaway", "k", "lambda", "phase", "t_end")
RESULTS = ("peak_amplitude", "final_position", "final_velocity", "zero_passages", "turning_points", "sticks", "stick_time",
           "peak_absolute_acceleration")


def about(place, slope, p, zeta, t0, x0, v0):
    """x and v as functions of time: a particular solution and a decaying sine from (t0, x0, v0)."""
    w = p * mp.sqrt(1 - zeta**2)
    c = x0 - place(t0)
    s = (v0 - slope(t0) + zeta * p * c) / w

    def sine(t):
        h = t - t0
        e = mp.exp(-zeta * p * h)
        return e * (c * mp.cos(w * h) + s * mp.sin(w * h)), e * (s * mp.cos(w * h) - c * mp.sin(w * h))

    def v(t):
        here, ahead = sine(t)
        return slope(t) + w * ahead - zeta * p * here

    return lambda t: place(t) + sine(t)[0], v


class Wave:
    """W = k sin(lam t + phase), and the motion under W and a constant."""

    def __init__(self, p, zeta, k, lam, phase):
        self.p, self.zeta, self.k, self.lam, self.phase = p, zeta, k, lam, phase

    def load(self, t):
        return self.k * mp.sin(self.lam * t + self.phase)

    def strongest(self, a, b):
        crest = mp.ceil((self.lam * a + self.phase) / mp.pi - mpf(1) / 2) + mpf(1) / 2
        inside = self.k and crest * mp.pi <= self.lam * b + self.phase
        return self.k if inside else max(abs(self.load(a)), abs(self.load(b)))

    def particular(self, t):
        p, k, lam, angle = self.p, self.k, self.lam, self.lam * t + self.phase
        if lam == p and self.zeta == 0:
            return k * t * mp.cos(angle) / (2 * p), k * (mp.cos(angle) - lam * t * mp.sin(angle)) / (2 * p)
        stiff, damp = p**2 - lam**2, 2 * self.zeta * p * lam
        of_sin, of_cos = (-k * stiff / (stiff**2 + damp**2), k * damp / (stiff**2 + damp**2))
        return (of_sin * mp.sin(angle) + of_cos * mp.cos(angle),
                lam * (of_sin * mp.cos(angle) - of_cos * mp.sin(angle)))

    def motion(self, t0, x0, v0, shift):
        """x and v as functions of time from (t0, x0, v0) about the place -shift."""
        return about(lambda t: self.particular(t)[0] - shift, lambda t: self.particular(t)[1],
                     self.p, self.zeta, t0, x0, v0)


class Line:
    """W = w0 + w1 (t - begin)."""

    def __init__(self, p, zeta, begin, w0, w1):
        self.p, self.zeta, self.begin, self.w0, self.w1 = p, zeta, begin, w0, w1

    def load(self, t):
        return self.w0 + self.w1 * (t - self.begin)

    def strongest(self, a, b):
        return max(abs(self.load(max(a, self.begin))), abs(self.load(b)))

    def motion(self, t0, x0, v0, shift):
        lag = 2 * self.zeta * self.w1 / self.p**3
        return about(lambda t: lag - shift - self.load(t) / self.p**2, lambda t: -self.w1 / self.p**2,
                     self.p, self.zeta, t0, x0, v0)


def bisected(g, a, b):
    """Where g, not negative at a and negative at b, changes its sign."""
    while b - a > mpf(10) ** (8 - mp.dps) * max(1, abs(b)):
        m = (a + b) / 2
        if g(m) >= 0:
            a = m
        else:
            b = m
    return (a + b) / 2


class Motion:
    def __init__(self, x0, v0, p, f, delta, zeta, breakaway):
        self.x, self.v, self.p, self.f, self.delta, self.zeta = x0, v0, p, f, delta, zeta
        self.hold = breakaway * f
        self.s = mp.sign(v0)
        self.t = mpf(0)
        self.peak = abs(x0)
        self.felt = mpf(0)
        self.passages = self.turns = self.sticks = 0
        self.stick_time = mpf(0)
        self.rest_begin = self.t if v0 == 0 else None
        self.held = False

    def through(self, drive, end, step):
        while self.t < end and not self.held:
            if self.rest_begin is not None:
                self.rest(drive, end, step)
            else:
                self.slide(drive, end, step)
        if self.held:
            self.felt = max(self.felt, drive.strongest(self.t, end))

    def rest(self, drive, end, step):
        excess = lambda t: self.hold - abs(drive.load(t) + self.p**2 * self.x)
        tiny = mpf(10) ** (12 - mp.dps)
        while excess(self.t) >= -tiny:
            if excess(self.t + tiny) < 0:  # held to the last digit and being overcome
                self.t += tiny
                break
            a, b = self.t, min(self.t + step, end)
            left = excess(b) < 0
            self.t = bisected(excess, a, b) + tiny if left else b
            self.felt = max(self.felt, drive.strongest(a, self.t))
            if left:
                break
            if b == end:
                return
        if self.t > self.rest_begin + tiny * 10:
            self.sticks += 1
            self.stick_time += self.t - self.rest_begin
        self.rest_begin = None
        self.s = -mp.sign(drive.load(self.t) + self.p**2 * self.x)
        self.v = mpf(0)

    def slide(self, drive, end, step):
        s, a = self.s, self.t
        x, v = drive.motion(self.t, self.x, self.v, s * self.f / self.p**2)
        speed = lambda t: s * v(t)
        inward = s * self.x < 0
        feels = lambda t: s * self.p**2 * x(t) + self.f + 2 * self.zeta * self.p * speed(t)
        # Its slope: p^2 v + 2 zeta p x'', and x'' = -W - feels.
        rises = lambda t: self.p * speed(t) - 2 * self.zeta * (s * drive.load(t) + feels(t))

        def feel(begin, end):
            self.felt = max(self.felt, abs(feels(begin)), abs(feels(end)))
            if rises(begin) * rises(end) < 0:
                side = mp.sign(rises(begin))
                self.felt = max(self.felt, abs(feels(bisected(lambda t: side * rises(t), begin, end))))

        while True:
            b = min(a + step, end)
            turns = b > self.t and speed(b) < 0
            stop = bisected(speed, a, b) if turns else b
            if inward and s * x(stop) >= 0:
                stop = bisected(lambda t: -s * x(t), a, stop)
                feel(a, stop)
                self.arrive(stop, v(stop))
                return
            feel(a, stop)
            if turns:
                self.t, self.x, self.v = stop, x(stop), mpf(0)
                self.turns += 1
                self.rest_begin = stop
                self.peak = max(self.peak, abs(self.x))
                return
            a = b
            if b == end:
                self.t, self.x, self.v = b, x(b), v(b)
                self.peak = max(self.peak, abs(self.x))
                return

    def arrive(self, t, v):
        self.t, self.x = t, mpf(0)
        if v**2 <= 2 * self.delta:
            self.v, self.held = mpf(0), True
            return
        self.v = self.s * mp.sqrt(v**2 - 2 * self.delta)
        self.passages += 1


def record_of_s5():
    """As tests/support/scene_s5.hpp: rounded to 2^-36, so that every library gives the same doubles."""
    values = []
    for i in range(3000):
        t = mpf(i) / 50
        w = mpf(2) / 5 * mp.exp(-(((t - 20) / 10) ** 2)) * mp.sin(mpf(23) / 10 * t)
        w += mpf(1) / 5 * mp.exp(-(((t - 25) / 12) ** 2)) * mp.sin(mpf(51) / 10 * t + 1)
        values.append(float(mp.nint(w * 2**36)) / 2**36)
    return values


def simulate(row, step):
    x0, v0, p, f, delta, zeta, breakaway = (mpf(row[key]) for key in INPUTS[1:8])
    motion = Motion(x0, v0, p, f, delta, zeta, breakaway)
    if row["k"] == "record":
        values, dt = record_of_s5(), mpf(0.02)
        for i in range(len(values) - 1):
            w0, w1 = mpf(values[i]), mpf(values[i + 1])
            motion.through(Line(p, zeta, i * dt, w0, (w1 - w0) / dt), (i + 1) * dt, step)
    else:
        k, lam, phase, end = (mpf(row[key]) for key in INPUTS[8:])
        motion.through(Wave(p, zeta, k, lam, phase), end, step)
    for_ever = row["k"] in ("record", 0.0) and mp.fabs(p**2 * motion.x) <= motion.hold  # W = 0 from there on
    if motion.rest_begin is not None and motion.t > motion.rest_begin and not for_ever:
        motion.sticks += 1
        motion.stick_time += motion.t - motion.rest_begin
    return dict(peak_amplitude=motion.peak, final_position=motion.x, final_velocity=motion.v, zero_passages=motion.passages,
                turning_points=motion.turns, sticks=motion.sticks, stick_time=motion.stick_time,
                peak_absolute_acceleration=motion.felt)


def reference(row):
    runs = []
    for digits, step in ((60, mpf(1) / 13), (75, mpf(1) / 23)):
        with mp.workdps(digits):
            runs.append(simulate(row, step * min(1, 1 / mpf(row['p']))))
    coarse, fine = runs
    for key in RESULTS:
        if abs(fine[key] - coarse[key]) > mpf("1e-32") * (abs(fine[key]) + mpf("1e-3")):
            raise RuntimeError(f"{row['name']}: {key}: {coarse[key]} {fine[key]}")
    with mp.workdps(40):
        return row | {key: mp.nstr(fine[key], 30) if isinstance(fine[key], mpf) else fine[key] for key in RESULTS}


def cases():
    def case(name, v0, p, f, delta, k, lam, phase, t_end, x0=0.0, zeta=0.0, breakaway=1.0):
        return dict(zip(INPUTS, (name, x0, v0, p, f, delta, zeta, breakaway, k, lam, phase, t_end)))

    def free(name, v0, p, f, delta, t_end, **more):
        return case(name, v0, p, f, delta, 0.0, 0.0, 0.0, t_end, **more)

    yield case("scene_s3", 0.5, 1.0, 0.05, 0.01, 0.2, 1.0, 0.0, 200.0)
    yield case("scene_s4", 0.5, 1.0, 0.18, 0.0, 0.2, 0.35, 0.0, 200.0)
    yield case("scene_s5", 0.0, 1.0, 0.05, 0.0, "record", "", "", "")
    yield case("between_samples_of_frequency", 0.3, 2.0, 0.04, 0.002, 0.3, 3.1, 0.7, 60.0)
    yield case("slow_forcing", 1.0, 1.0, 0.06, 0.003, 0.5, 0.11, -1.0, 150.0)
    yield case("fast_forcing", 0.4, 1.0, 0.1, 0.0, 0.9, 7.3, 0.2, 30.0)
    yield case("near_resonance_1e-6", 0.2, 1.5, 0.03, 0.001, 0.15, 1.5 * (1 + 1e-6), 0.4, 80.0)
    yield case("from_rest", 0.0, 1.0, 0.1, 0.004, 0.3, 0.8, 0.0, 80.0)
    yield case("from_x0_inwards", -0.2, 0.7, 0.02, 0.001, 0.1, 1.1, 2.0, 80.0, 1.25)
    yield case("even_ratio_two_stops", 0.0, 1.0, 0.15, 0.0, 0.2, 0.5, 0.0, 100.0)
    yield free("damped_free", 1.0, 1.0, 0.02, 0.005, 40.0, zeta=0.05)
    yield free("damped_free_held_at_first_return", 1.0, 1.3, 0.21, 0.35, 20.0, zeta=0.05)
    yield free("damped_free_of_a_tiny_share", 1.0, 1.0, 0.02, 0.001, 60.0, zeta=1e-12)
    yield free("damped_free_of_a_fifth", -0.7, 2.0, 0.004, 1e-4, 20.0, zeta=0.2)
    yield free("damped_free_of_nine_tenths", 1.0, 1.0, 1e-4, 1e-7, 20.0, zeta=0.9)
    yield free("damped_free_nearly_critical_from_x0", 0.0, 1.0, 1e-3, 0.0, 40.0, x0=2.0, zeta=0.99)
    yield free("damped_free_rests_at_breakaway", 0.0, 1.0, 0.1, 0.0, 30.0, x0=0.9, zeta=0.05, breakaway=3.5)
    yield case("damped_resonance", 0.2, 1.0, 0.03, 0.002, 0.15, 1.0, 0.4, 80.0, zeta=0.05)
    yield case("damped_of_a_tiny_share_near_resonance", 0.2, 1.0, 0.03, 0.001, 0.15, 1 + 1e-7, 0.4, 80.0, zeta=1e-9)
    yield case("damped_of_a_fifth_fast_forcing", 0.4, 1.0, 0.1, 0.0, 0.9, 7.3, 0.2, 30.0, zeta=0.2)
    yield case("damped_of_nine_tenths_slow_forcing", 1.0, 1.0, 0.06, 0.003, 0.5, 0.11, -1.0, 150.0, zeta=0.9)
    yield case("breakaway_alone", 0.5, 1.0, 0.12, 0.0, 0.2, 0.35, 0.0, 200.0, breakaway=1.4)
    yield case("damped_with_breakaway", 0.5, 1.0, 0.12, 0.0, 0.2, 0.35, 0.0, 200.0, zeta=0.05, breakaway=1.25)
    yield case("damped_record_with_breakaway", 0.0, 1.0, 0.05, 0.0, "record", "", "", "", zeta=0.05, breakaway=1.5)


def main():
    with open(Path(__file__).with_name("forced_motion.csv"), "w", newline="", encoding="ascii") as file:
        file.write("# Forced, and damped, vibration with constant and point friction, 30 significant digits.\n"
                   "# Made by make_forced_reference.py, which defines the columns.\n")
        writer = csv.DictWriter(file, INPUTS + RESULTS, lineterminator="\n")
        writer.writeheader()
        for case in cases():
            writer.writerow(reference(case))
            file.flush()


if __name__ == "__main__":
    main()
