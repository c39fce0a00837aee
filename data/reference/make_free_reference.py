"""High-precision reference for free vibration with constant and point friction.

Writes free_motion.csv, one row for each motion of

    x'' + (f + delta * dirac(x)) sgn x' + p^2 x = 0,   x(0) = x0,  x'(0) = v0,

followed in the time domain: while x' keeps its sign s, with e = -s f / p^2 and the phase a = p h,

    x = e + (x0 - e) cos a + (v0 / p) sin a,

and the next event (v = 0, or x = 0 on the way in) is bracketed by a scan in phase and refined by
Newton's method kept inside the bracket. Neither the energy integral nor a map from one half-cycle
to the next is used, so that a program built on those is checked by something else than itself.

Inputs are the exact values of the doubles printed. Every motion is computed at 90 and at 130
digits; the two must agree in every count, and to 1e-41 in every number, or nothing is written.

Exact ties (v = 0 at x = 0; v^2 = 2 delta at an arrival; p^2 |x| = f at a turn) count as ties within
1e-45, relative, because an irrational phase never meets them exactly. Every tie ends the motion.
The start is judged without a threshold: products of doubles are exact at 90 digits.

Columns: half_cycles is 1 + zero_passages if anything moves, else 0; turning_points are instants
with v = 0, x != 0 reached from motion, a final rest off zero included; zero_passages are arrivals
at x = 0 after which the mass goes on; arrival_speed is that of the last arrival at x = 0, before
the notch acts; peak_acceleration is the largest |x''| away from the notch, one-sided limits at the
ends of the monotone pieces included. What does not exist is left empty.

Run: python3 make_free_reference.py   (needs mpmath; minutes; the same bytes every time)
"""
import csv
import random
from math import inf, nextafter, sqrt
from pathlib import Path

from mpmath import mp, mpf

TIE = mpf("1e-45")
# Below pi/8, so no pair of roots fits in a step; no fraction of pi, so a swing from rest, pi long,
# does not end on the scan's grid.
PHASE_STEP = mpf("0.39")
COLUMNS = ("name x0 v0 p f delta peak_amplitude peak_acceleration half_cycles turning_points "
           "zero_passages stop_time stop_position arrival_speed outcome").split()


def bracketed_root(g, slope, a, b):
    """Root of g between a and b, where g changes sign."""
    rising = g(b) > g(a)
    theta = (a + b) / 2
    for _ in range(2000):
        value, gradient = g(theta), slope(theta)
        if (value > 0) == rising:
            b = theta
        else:
            a = theta
        step = value / gradient if gradient else mpf(inf)
        # 15 digits above rounding: next to a graze the slope, and so the root, is only that good
        if abs(step) <= mpf(10) ** (15 - mp.dps) * theta:
            return theta - step
        theta = theta - step if a < theta - step < b else (a + b) / 2
    raise RuntimeError("no convergence")


def monotone_piece(x0, v0, s, p, f):
    """Phase, position and velocity at the end of the piece from (x0, v0) in direction s."""
    reach = x0 + s * f / p**2

    def position(a):  # cos a - 1 = -2 sin^2(a/2): no cancellation when friction leaves a tiny phase
        return x0 + v0 / p * mp.sin(a) - 2 * reach * mp.sin(a / 2) ** 2

    def velocity(a):
        return v0 * mp.cos(a) - reach * p * mp.sin(a)

    a, b = mpf(0), PHASE_STEP
    while True:
        turning = s * velocity(b) <= 0
        end = b
        if turning:
            end = bracketed_root(velocity, lambda h: -v0 * mp.sin(h) - reach * p * mp.cos(h), a, b)
        if x0 * s < 0:  # on the way in; x is monotone up to end, so its sign there tells of zero
            x_end = position(end)
            if turning and abs(x_end) <= TIE * abs(x0):
                return end, mpf(0), mpf(0)
            if s * x_end >= 0:
                end = bracketed_root(position, lambda h: velocity(h) / p, a, end)
                return end, mpf(0), velocity(end)
        if turning:
            return end, position(end), mpf(0)
        a, b = b, b + PHASE_STEP


def at_most(a, b):
    return a <= b + TIE * max(abs(a), abs(b))


def simulate(x0, v0, p, f, delta):
    """The motion's columns from peak_amplitude on."""
    x, v, p, f, delta = (mpf(value) for value in (x0, v0, p, f, delta))
    peak, acceleration, phase = abs(x), mpf(0), mpf(0)
    turns, passages, arrival_speed, outcome = 0, 0, None, None
    if v == 0 and p**2 * abs(x) <= f:
        outcome = "stopped_in_dead_zone" if x else "stopped_at_zero"
    elif x == 0 and v**2 < 2 * delta:
        outcome = "caught_at_start"
    while outcome is None:
        s = mp.sign(v) if v else -mp.sign(x)
        acceleration = max(acceleration, abs(p**2 * x + s * f))
        duration, x, v = monotone_piece(x, v, s, p, f)
        phase += duration
        peak, acceleration = max(peak, abs(x)), max(acceleration, abs(p**2 * x + s * f))
        if x != 0:
            turns += 1
            if f == 0 and delta == 0:  # the first turn has shown the amplitude; the rest repeats it
                return peak, acceleration, None, None, None, None, None, None, "never_stops"
            if at_most(p**2 * abs(x), f):
                outcome = "stopped_in_dead_zone"
        else:
            arrival_speed = abs(v)
            if v == 0 or at_most(v**2, 2 * delta):
                outcome = "stopped_at_zero"
            else:
                passages += 1
                v = s * mp.sqrt(v**2 - 2 * delta)
    half_cycles = passages + 1 if phase else 0
    return (peak, acceleration, half_cycles, turns, passages, phase / p, x, arrival_speed, outcome)


def reference_row(name, inputs):
    """The row of one motion, checked against the same motion at another precision."""
    with mp.workdps(90):
        check = simulate(*inputs)
    row = [name, *map(repr, inputs)]
    with mp.workdps(130):
        for value, other in zip(simulate(*inputs), check):
            number = isinstance(value, mpf)
            if not (abs(value - other) <= mpf("1e-41") * abs(value) if number else value == other):
                raise RuntimeError(f"{name}: {other} and {value} at two precisions")
            row.append(mp.nstr(value, 40) if number else "" if value is None else value)
    return row


def around(name, inputs, which):
    """A tie, and the same with input number `which` one ulp lower and higher."""
    for suffix, towards in (("", None), ("_ulp_below", -inf), ("_ulp_above", inf)):
        shifted = [float(value) for value in inputs]
        if suffix:
            shifted[which] = nextafter(shifted[which], towards)
        yield name + suffix, shifted


def random_cases():
    rng = random.Random(20240229)

    def log_uniform(low, high):  # mpmath's power, not libm's: the same doubles on every machine
        return float(mpf(10) ** mpf(rng.uniform(low, high)))

    def scales():  # V0, V0 p and V0^2
        v0, p = log_uniform(-4.5, 4.5), log_uniform(-4.5, 4.5)
        return v0, p, v0 * p, v0 * v0

    for i in range(45):
        v0, p, force, energy = scales()
        f, delta = log_uniform(-3, 0) * force, log_uniform(-3, -0.30103) * energy
        yield f"ordinary_{i}", (0, v0 * rng.choice((1, -1)), p, f, delta)
    for kind, heading in (("outward", 1), ("inward", -1), ("at_rest", 0)):
        for i in range(6):
            v0, p, force, energy = scales()
            side, x0 = rng.choice((1, -1)), log_uniform(-1, 1) * v0 / p
            f, delta = log_uniform(-2, 0.5) * force, log_uniform(-3, 0) * energy
            yield f"start_{kind}_{i}", (side * x0, side * heading * v0, p, f, delta)
    for i in range(5):
        v0, p, force, energy = scales()
        yield f"point_friction_only_{i}", (0, v0, p, 0, log_uniform(-3, -0.30103) * energy)
        yield f"constant_friction_only_{i}", (0, v0, p, log_uniform(-3, 1) * force, 0)


def chosen_cases():
    yield "scene_s1", (0, 1, 1, 0.02, 0.02)
    yield "scene_s1_mirrored", (0, -1, 1, 0.02, 0.02)
    yield "scene_s2", (0, 1, 1, 1e-3, 1e-4)
    yield "design_first_return_published", (0, 1, 1, 0.2593, 0.3667)
    yield "design_first_return_exact", (0, 1, 1, 0.2569, 0.3633)
    for i, (a, b) in enumerate(((0.65, 0.65), (0.65, 1.35), (1.35, 0.65), (1.35, 1.35))):
        yield f"design_corner_{i}", (0, 1, 1, 0.2593 * a, 0.3667 * b)
    # Every outcome.
    yield "nothing_moves", (0, 0, 1, 0.02, 0.02)
    yield "nothing_moves_frictionless", (0, 0, 1, 0, 0)
    yield "caught_at_start", (0, -1, 2, 0.1, 0.6)
    yield "frictionless", (0, 1.5, 3, 0, 0)
    yield "frictionless_inward", (-0.7, 1.1, 0.3, 0, 0)
    yield "frictionless_from_rest", (0.7, 0, 0.3, 0, 0)
    yield "start_inward_stops_short_of_zero", (1, -0.25, 1, 3, 0.125)
    yield "start_inward_caught_on_first_arrival", (0.5, -1, 1, 0.25, 0.75)
    yield "start_inward_passes", (0.5, -3, 1, 0.25, 0.75)
    yield "start_inward_fast_point_friction_only", (-0.5, 3, 2, 0, 0.75)
    yield "start_inward_near_zero", (1e-12, -1, 1, 0.02, 0.02)
    yield "start_outward_rests_at_peak", (-0.5, -1, 1, 2, 0.125)
    yield "start_outward_swings_back_to_rest", (0.5, 1, 1, 0.6, 0.125)
    yield "start_at_rest_sticks", (-0.5, 0, 1, 0.75, 0.125)
    yield "start_at_rest_swings_to_rest", (1, 0, 1, 0.75, 0.125)
    yield "start_at_rest_caught_at_zero", (-1, 0, 1, 0.25, 0.3)
    yield "start_at_rest_passes", (1, 0, 1, 0.0625, 0.03125)
    yield "start_at_rest_point_friction_only", (1, 0, 3, 0, 0.7)
    # Extreme sizes.
    for f in (1e8, 1e150, 1e300):
        yield f"friction_dominates_{f:.0e}", (0, 1, 1, f, 0.125)
    yield "friction_dominates_1e+08_no_point_friction", (0, 0.3, 7, 2.1e8, 0)
    yield "friction_dominates_1e+08_from_x0", (0.7, -1e-3, 1.3, 1e8, 0.125)
    for tiny in (1e-300, 5e-324):
        yield f"tiny_f_{tiny:.0e}", (0, 1, 1, tiny, 0.03)
        yield f"tiny_delta_{tiny:.0e}", (0, 1, 1, 0.03, tiny)
    for v0, p, f, delta in ((1e150, 1e150, 1e299, 1e299), (1e150, 1e-150, 0.1, 1e298),
                            (1e-150, 1e150, 0.1, 2e-302), (1e-150, 1e-150, 1e-301, 1e-301)):
        name = f"scale_v{v0:.0e}_p{p:.0e}"
        yield name, (0, v0, p, f, delta)
        yield name + "_slow_decay", (0, v0, p, f / 8, delta / 16)
        yield name + "_from_x0", (-0.75 * (v0 / p), 0, p, f, delta)
    # Long runs.
    for name, size in (("1e3", 1.0), ("1e4", 0.1)):
        yield f"long_{name}", (0, 1, 1, 2e-4 * size, 2e-4 * size)
        yield f"long_{name}_scaled", (0, 310, 0.07, 4e-3 * size, 15 * size)
    yield "long_1e3_from_x0", (-1.1, 0.2, 1.3, 1e-4, 3e-4)


def tie_cases():
    F, DELTA = 3, 4  # the input to shift
    # v^2 = 2 delta on arrival, after Pythagorean legs f and p v0 (7, 24, 25 leads to p^2 v^2 = 72).
    yield from around("tie_first_arrival", (0, 24, 1, 7, 36), DELTA)
    yield from around("tie_first_arrival_p3", (0, 8, 3, 7, 4), DELTA)
    powers = (0, 24 * 2.0**50, 2.0**400, 7 * 2.0**450, 36 * 2.0**100)
    yield from around("tie_first_arrival_powers_of_two", powers, DELTA)
    yield from around("tie_first_arrival_f20", (0, 99, 1, 20, 1660.5), DELTA)
    yield from around("tie_second_arrival", (0, 264, 1, 23, 8316), DELTA)
    # A peak on the dead zone's edge, p^2 |x| = f; a return that reaches x = 0 with v = 0.
    yield from around("tie_first_peak_on_edge", (3, 6, 1, 5, 0.125), F)
    yield from around("tie_second_peak_on_edge", (0, 99, 1, 20, 1060.5), DELTA)
    yield from around("tie_first_return_graze", (4, 12, 1, 5, 0), F)
    yield from around("tie_first_return_graze_point_friction", (4, 12, 1, 5, 0.125), F)
    yield from around("tie_second_return_graze", (0, 99, 1, 20, 60.5), DELTA)
    # delta = 0 and sqrt((p^2 x0 + f)^2 + (p v0)^2) = n f: odd n grazes, even n ends on the edge.
    for x0, v0, n in ((7, 16, 4), (10, 20, 5), (45, 120, 26), (100, 100, 29)):
        yield from around(f"tie_constant_friction_only_n{n}", (x0, v0, 1, 5, 0), F)
    for x0 in (2, 3, 20):  # the same from rest: even multiples of f graze, odd ones end on the edge
        yield from around(f"tie_from_rest_x{x0}", (x0, 0, 1, 1, 0), F)
    yield "rational_constant_friction_only_7_24", (0, 24, 1, 7, 0)
    yield "rational_constant_friction_only_20_99", (0, 99, 1, 20, 0)
    # f = 0 and v0^2 / (2 delta) an integer: exactly, then only in decimal.
    yield from around("tie_point_friction_only_4", (0, 1, 1, 0, 0.125), DELTA)
    yield from around("tie_point_friction_only_64", (0, -1, 1, 0, 1 / 128), DELTA)
    for name, delta in (("0.1", 0.1), ("0.05", 0.05), ("sixth", 1 / 6), ("0.01", 0.01)):
        yield f"near_tie_point_friction_only_{name}", (0, 1, 1, 0, delta)
    yield "near_tie_point_friction_only_v0.1", (0, 0.1, 1, 0, 0.001)
    # The start; near ties differ by less than the rounding of v0^2 or p^2 x0 to a double.
    yield "tie_start", (0, 2, 1, 0.25, 2)
    yield from around("tie_start_point_friction_only", (0, 2, 1, 0, 2), DELTA)
    yield from around("tie_stick_at_start", (2, 0, 1.5, 4.5, 0.125), F)
    yield "near_tie_start_v0.1", (0, 0.1, 1, 0, 0.005)
    yield "near_tie_start_v_sqrt2", (0, sqrt(2), 1, 0.1, 1)
    yield "near_tie_stick_at_start", (3, 0, 0.1, 0.03, 0.125)


def main():
    cases = [*chosen_cases(), *tie_cases(), *random_cases()]
    assert len({name for name, _ in cases}) == len(cases)
    rows = [reference_row(name, [float(value) for value in inputs]) for name, inputs in cases]
    with open(Path(__file__).with_name("free_motion.csv"), "w", newline="") as file:
        file.write("# Free vibration with constant and point friction, 40 significant digits.\n"
                   "# Made by make_free_reference.py, which defines the columns: solved in time;\n"
                   "# inputs are exact doubles; empty where the value does not exist.\n")
        csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])


if __name__ == "__main__":
    main()
