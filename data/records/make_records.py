"""Two synthetic acceleration records, so that the program can be tried without a real one.

near_fault_pulse.txt: the velocity pulse of G. P. Mavroeidis and A. S. Papageorgiou (Bulletin of the
Seismological Society of America 93, 2003), with s = t - T0 and |s| <= GAMMA / (2 FP),

    v = A/2 (1 + cos(2 pi FP s / GAMMA)) cos(2 pi FP s + NU),

and zero before and after. The file holds its derivative in g. With NU = pi/2 the velocity is odd
about T0, so the ground comes back to where it was.

strong_motion.AT2: white noise w under an envelope, through the soil filter of Kanai and Tajimi and
the high-pass filter of Clough and Penzien,

    x'' + 2 Z_G W_G x' + W_G^2 x = w,        u = 2 Z_G W_G x' + W_G^2 x,
    y'' + 2 Z_F W_F y' + W_F^2 y = u,        a = y'',

by the trapezoidal rule, scaled to the peak PEAK and written as PEER does.

The noise comes from a generator of its own (SplitMix64; twelve uniform numbers make a normal one),
so that it does not depend on Python's. The same bytes every time.

Run: python3 make_records.py   (standard library only; a second)
"""
from math import cos, exp, pi, sin
from pathlib import Path

GRAVITY = 9.80665
STEP = 0.01

PULSE_DURATION = 12.0
A, FP, GAMMA, NU, T0 = 0.9, 0.5, 2.0, pi / 2, 4.0  # m/s, Hz, -, rad, s

NOISE_COUNT = 2000
W_G, Z_G = 15.6, 0.6  # rad/s, firm soil
W_F, Z_F = 1.5, 0.6
RISE, STRONG, DECAY = 3.0, 10.0, 0.35  # s, s, 1/s
PEAK = 0.35  # g
SEED = 1960


def pulse_acceleration(t):
    """The derivative of v, in g."""
    s = t - T0
    if abs(s) > GAMMA / (2 * FP):
        return 0.0
    slow, fast = 2 * pi * FP * s / GAMMA, 2 * pi * FP * s + NU
    rate = -A * pi * FP * (sin(slow) * cos(fast) / GAMMA + (1 + cos(slow)) * sin(fast))
    return rate / GRAVITY


def pulse_file():
    lines = [
        "# SYNTHETIC, no earthquake: near-fault velocity pulse of Mavroeidis and Papageorgiou",
        f"# amplitude {A} m/s, frequency {FP} Hz, gamma {GAMMA}, phase 90 degrees, centre {T0} s",
        "# time in s, acceleration in g; made by make_records.py",
    ]
    for i in range(round(PULSE_DURATION / STEP) + 1):
        value = pulse_acceleration(i * STEP)
        lines.append(f"{i * STEP:.2f} {value + 0.0:.9f}".replace(" -0.000000000", " 0.000000000"))
    return "\n".join(lines) + "\n"


def normal_numbers(count):
    """SplitMix64; the sum of twelve uniform numbers less six has mean 0 and variance 1."""
    state, mask = SEED, (1 << 64) - 1
    for _ in range(count):
        total = 0
        for _ in range(12):
            state = (state + 0x9E3779B97F4A7C15) & mask
            z = state
            z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & mask
            z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
            total += (z ^ (z >> 31)) >> 11
        yield total / (1 << 53) - 6


def envelope(t):
    if t < RISE:
        return (t / RISE) ** 2
    return 1.0 if t < STRONG else exp(-DECAY * (t - STRONG))


def filtered(forces, w, z):
    """(q, q', q'') of q'' + 2 z w q' + w^2 q = force at every step, from rest."""
    q = v = a = 0.0
    for force in forces:
        # q and v as the trapezoidal rule has them, with the new a left to find.
        q_known = q + STEP * v + STEP ** 2 / 4 * a
        v_known = v + STEP / 2 * a
        a = ((force - 2 * z * w * v_known - w * w * q_known)
             / (1 + z * w * STEP + w * w * STEP ** 2 / 4))
        q, v = q_known + STEP ** 2 / 4 * a, v_known + STEP / 2 * a
        yield q, v, a


def noise_values():
    noise = [envelope(i * STEP) * n for i, n in enumerate(normal_numbers(NOISE_COUNT))]
    soil = [2 * Z_G * W_G * v + W_G ** 2 * q for q, v, _ in filtered(noise, W_G, Z_G)]
    values = [a for _, _, a in filtered(soil, W_F, Z_F)]
    peak = max(abs(value) for value in values)
    return [PEAK * value / peak for value in values]


def fortran(value):
    """As Fortran's 1PE15.7 less the 1P: 0.1234567E-01."""
    digits, exponent = f"{abs(value):.6e}".split("e")
    mantissa = digits.replace(".", "")
    power = int(exponent) + 1 if value else 0
    return f"{'-' if value < 0 else ''}0.{mantissa}E{power:+03d}".rjust(15)


def noise_file():
    lines = [
        "SYNTHETIC RECORD, NO EARTHQUAKE: FILTERED NOISE MADE BY MAKE_RECORDS.PY",
        f"KANAI-TAJIMI {W_G} RAD/S {Z_G}, CLOUGH-PENZIEN {W_F} RAD/S {Z_F}, SEED {SEED}",
        "ACCELERATION TIME HISTORY IN UNITS OF G",
        f"NPTS=  {NOISE_COUNT}, DT= {STEP:.5f} SEC".replace("= 0.", "= ."),
    ]
    values = [fortran(value) for value in noise_values()]
    lines += ["".join(values[i:i + 5]) for i in range(0, len(values), 5)]
    return "\n".join(lines) + "\n"


def main():
    folder = Path(__file__).resolve().parent
    for name, text in (("near_fault_pulse.txt", pulse_file()), ("strong_motion.AT2", noise_file())):
        (folder / name).write_bytes(text.encode("ascii"))


if __name__ == "__main__":
    main()
