"""Synthetic acceleration records, so that the program can be tried without a real one.

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

short_pulse.*: one short pulse in each format of the networks that is read, to be compared,

    a = SHORT_PEAK sin^2(pi t / D) sin(3 pi t),  0 <= t < D = SHORT_COUNT SHORT_STEP.

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


SHORT_COUNT, SHORT_STEP, SHORT_PEAK = 100, 0.02, 250.0  # -, s, cm/s2


def short_pulse():
    times = [i * SHORT_STEP for i in range(SHORT_COUNT)]
    duration = SHORT_COUNT * SHORT_STEP
    return [round(SHORT_PEAK * sin(pi * t / duration) ** 2 * sin(3 * pi * t), 6) + 0.0 for t in times]


def integral(values):
    """By the trapezoidal rule, from 0."""
    total, sums = 0.0, [0.0]
    for before, after in zip(values, values[1:]):
        total += SHORT_STEP * (before + after) / 2
        sums.append(total)
    return sums


def rows(values, form, per_line):
    """Fields of a fixed width; a value that rounds to 0 has no sign."""
    fields = [format(value, form) for value in values]
    zero = format(0 * values[0], form)
    fields = [zero if float(field) == 0 else field for field in fields]
    return ["".join(fields[i:i + per_line]) for i in range(0, len(fields), per_line)]


def esm_file():
    known = {
        "EVENT_NAME": "SYNTHETIC, NO EARTHQUAKE", "EVENT_ID": "NONE", "NETWORK": "XX",
        "STATION_CODE": "NONE", "STATION_NAME": "MADE BY MAKE_RECORDS.PY",
        "SAMPLING_INTERVAL_S": f"{SHORT_STEP:.6f}", "NDATA": f"{SHORT_COUNT}",
        "DURATION_S": f"{(SHORT_COUNT - 1) * SHORT_STEP:.6f}", "STREAM": "HNE", "UNITS": "cm/s^2",
        "BASELINE_CORRECTION": "BASELINE NOT REMOVED", "HEADER_FORMAT": "DYNA 1.2",
        "DATA_TYPE": "ACCELERATION", "PROCESSING": "none",
    }
    keys = """EVENT_NAME EVENT_ID EVENT_DATE_YYYYMMDD EVENT_TIME_HHMMSS EVENT_LATITUDE_DEGREE
        EVENT_LONGITUDE_DEGREE EVENT_DEPTH_KM HYPOCENTER_REFERENCE MAGNITUDE_W MAGNITUDE_W_REFERENCE
        MAGNITUDE_L MAGNITUDE_L_REFERENCE FOCAL_MECHANISM NETWORK STATION_CODE STATION_NAME
        STATION_LATITUDE_DEGREE STATION_LONGITUDE_DEGREE STATION_ELEVATION_M LOCATION SENSOR_DEPTH_M
        VS30_M/S SITE_CLASSIFICATION_EC8 MORPHOLOGIC_CLASSIFICATION EPICENTRAL_DISTANCE_KM
        EARTHQUAKE_BACKAZIMUTH_DEGREE DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS
        DATE_TIME_FIRST_SAMPLE_PRECISION SAMPLING_INTERVAL_S NDATA DURATION_S STREAM UNITS INSTRUMENT
        INSTRUMENT_ANALOG/DIGITAL INSTRUMENTAL_FREQUENCY_HZ INSTRUMENTAL_DAMPING FULL_SCALE_G
        N_BIT_DIGITAL_CONVERTER PGA_CM/S^2 TIME_PGA_S BASELINE_CORRECTION FILTER_TYPE FILTER_ORDER
        LOW_CUT_FREQUENCY_HZ HIGH_CUT_FREQUENCY_HZ LATE/NORMAL_TRIGGERED DATABASE_VERSION
        HEADER_FORMAT DATA_TYPE PROCESSING DATA_TIMESTAMP_YYYYMMDD_HHMMSS DATA_LICENSE DATA_CITATION
        DATA_CREATOR ORIGINAL_DATA_MEDIATOR_CITATION ORIGINAL_DATA_MEDIATOR
        ORIGINAL_DATA_CREATOR_CITATION ORIGINAL_DATA_CREATOR USER1 USER2 USER3 USER4 USER5""".split()
    lines = [f"{key}: {known.get(key, '')}" for key in keys]
    return "\n".join(lines + rows(short_pulse(), ".6f", 1)) + "\n"


def knet_file():
    offset, gal, counts = 8000, 3920, 6182761
    values = [round(offset + value * counts / gal) for value in short_pulse()]
    heading = {
        "Origin Time": "SYNTHETIC", "Lat.": "0", "Long.": "0", "Depth. (km)": "0", "Mag.": "0",
        "Station Code": "SYNTHETIC", "Station Lat.": "0", "Station Long.": "0",
        "Station Height(m)": "0", "Record Time": "", "Sampling Freq(Hz)": f"{1 / SHORT_STEP:.0f}Hz",
        "Duration Time(s)": f"{SHORT_COUNT * SHORT_STEP:.0f}", "Dir.": "E-W",
        "Scale Factor": f"{gal}(gal)/{counts}", "Max. Acc. (gal)": f"{max(map(abs, short_pulse())):.3f}",
        "Last Correction": "", "Memo.": "no earthquake: made by make_records.py",
    }
    lines = [f"{key:<18}{value}".rstrip() for key, value in heading.items()]
    lines += [" ".join(f"{value:8d}" for value in values[i:i + 8]) for i in range(0, len(values), 8)]
    return "\n".join(lines) + "\n"


def csmip_file():
    """Two channels; the second is half the first, reversed."""
    lines = []
    for channel, factor, direction in ((1, 1.0, "90 Deg"), (2, -0.5, "360 Deg")):
        acceleration = [factor * value for value in short_pulse()]
        velocity = integral(acceleration)
        displacement = integral(velocity)
        title = {
            1: f"Corrected accelerogram   SYNTHETIC, NO EARTHQUAKE  Chan  {channel}: {direction}",
            2: "made by make_records.py", 6: "Station No. 00000   SYNTHETIC",
            8: f"Chan  {channel}: {direction}",
            16: f"{SHORT_COUNT:6d} points of instrument- and baseline-corrected accel, veloc and "
                "displ data",
            17: f"At equally-spaced intervals of {SHORT_STEP:7.3f}  sec.",
        }
        lines += [title.get(line, "") for line in range(1, 26)]
        lines += rows([-999] * 100, "5d", 16) + rows([-999.0] * 100, "10.5f", 8)
        for name, values, unit in (("accel", acceleration, "cm/sec2"),
                                   ("veloc", velocity, "cm/sec"), ("displ", displacement, "cm")):
            lines.append(f"{SHORT_COUNT:6d} points of {name} data equally spaced at {SHORT_STEP:5.3f} "
                         f"sec, in {unit}. (8f10.5)")
            lines += rows(values, "10.5f", 8)
        lines.append(f"/&  ----------  End of data for channel {channel:2d}  ----------")
    return "\n".join(lines) + "\n"


def cosmos_file():
    """An acceleration and a velocity. The fields touch, and the recorder had twice the steps."""
    acceleration = short_pulse()
    lines = []
    for name, values, unit in (("acceleration", acceleration, "cm/sec2(04)"),
                               ("velocity    ", integral(acceleration), "cm/sec (05)")):
        lines += [
            f"Corrected {name} (Format v01.20 with 13 text lines) Src: make_records.py",
            "SYNTHETIC, NO EARTHQUAKE", "Hypocenter: none", "Origin: none",
            "Statn No: 00-    0  Code:XX-NONE  SYNTHETIC", "Coords: none", "Recorder: none",
            "Rcrd start time: none", "Sta Chan   1: 90 deg (Rcrdr Chan  1) Location:",
            "Raw record length =   2.000 sec", "Processed: not at all", "Record filtered: not at all",
            "Values used when parameter or data value is unknown/unspecified:   -999, -999.0",
            " 100 Integer-header values follow on  10 lines, Format= (10I8)",
        ]
        reals = [-999.0] * 100
        reals[33], reals[34] = SHORT_STEP / 2, SHORT_COUNT * SHORT_STEP  # s, of the recorder
        reals[61], reals[62] = 1000 * SHORT_STEP, SHORT_COUNT * SHORT_STEP  # ms and s, of the values
        lines += rows([-999] * 100, "8d", 10)
        lines += [" 100 Real-header values follow on  17 lines, Format= (6F13.6)"]
        lines += rows(reals, "13.6f", 6)
        lines += ['   1 Comment line(s) follow, each starting with a "|":', "| synthetic",
                  f"{SHORT_COUNT:8d} {name.strip()} pts, approx    2 secs, units={unit},"
                  "Format=(10F8.3)"]
        lines += rows(values, "8.3f", 10)
        lines += [f"End-of-data for Chan  1 {name.strip()}"]
    return "\n".join(lines) + "\n"


def smc_file():
    """The fields of negative values touch those before."""
    integers, reals = [-32768] * 48, [1.7e38] * 50
    integers[15], integers[16], reals[1] = 1, SHORT_COUNT, 1 / SHORT_STEP
    lines = ["2 CORRECTED ACCELEROGRAM", "SYNTHETIC, NO EARTHQUAKE", "made by make_records.py"]
    lines += ["*"] * 8
    lines += rows(integers, "10d", 8) + rows(reals, "15.7E", 5) + ["| synthetic"]
    fields = []
    for value in short_pulse():
        mantissa, exponent = f"{value:.4E}".split("E")
        fields.append(f"{mantissa}E{int(exponent):+d}".rjust(10))
    lines += ["".join(fields[i:i + 8]) for i in range(0, len(fields), 8)]
    return "\n".join(lines) + "\n"


def components():
    """Three directions: the pulse, half of it reversed, and a quarter of it."""
    return [[factor * value for value in short_pulse()] for factor in (1.0, -0.5, 0.25)]


def geonet_file():
    """Three components with accelerations, velocities and displacements, in mm, mm/s and mm/s2."""
    lines = []
    for values, name in zip(components(), ("N90E", "N00E", "Up")):
        velocity = integral(values)
        title = {
            1: "Corrected accelerogram SYNTHETIC_NONE_20 no earthquake",
            2: "Site NONE      00 00 00S  000 00 00E", 3: "made by make_records.py",
            13: f"Component {name}",
        }
        lines += [title.get(line, "") for line in range(1, 17)]
        integers, reals = [0] * 40, [0.0] * 60
        integers[30:36] = [SHORT_COUNT, 0, 0] + 3 * [SHORT_COUNT]
        reals[25] = SHORT_STEP
        lines += rows(integers, "8d", 10) + rows(reals, "8.4f", 10)
        for block, form in ((values, "8.1f"), (velocity, "8.1f"), (integral(velocity), "8.1f")):
            lines += rows([10 * value for value in block], form, 10)
    return "\n".join(lines) + "\n"


def table(form, *columns):
    return ["".join(format(value + 0.0, form) for value in row) for row in zip(*columns)]


def afad_file():
    known = {2: "PLACE\t:\tNOWHERE", 13: f"NUMBER OF DATA\t:\t{SHORT_COUNT}",
             14: f"SAMPLING INTERVAL (sec)\t:\t{SHORT_STEP:.6f}", 15: "RAW PGA VALUES (gal)\t:\tnone",
             18: "         N-S         E-W         U-D"}
    lines = ["STRONG GROUND MOTION RECORDS OF TURKIYE"]
    lines += [known.get(line, "SYNTHETIC, NO EARTHQUAKE\t:\t-") for line in range(2, 19)]
    return "\n".join(lines + table("12.6f", *components())) + "\n"


def cwa_file():
    """Upwards is a quarter of the pulse, to the north the pulse itself."""
    east, north, up = components()[1], components()[0], components()[2]
    lines = [
        "#StationCode: NONE", "#InstrumentKind: none (made by make_records.py)",
        "#StartTime: SYNTHETIC", f"#RecordLength(sec): {SHORT_COUNT * SHORT_STEP:8.3f}",
        f"#SampleRate(Hz): {1 / SHORT_STEP:.0f}", "#AmplitudeUnit:  gal. DCoffset(corr)",
        "#DataSequence: Time U(+); N(+); E(+)", "#Data: 4F10.3",
    ]
    times = [i * SHORT_STEP for i in range(SHORT_COUNT)]
    return "\n".join(lines + table("10.3f", times, up, north, east)) + "\n"


def asa_file():
    known = {
        7: "ARCHIVO ESTANDAR DE ACELERACION", 8: "VERSION DEL FORMATO : 2.0",
        17: "CLAVE DE LA ESTACION                : NONE",
        37: "ORIENTACION C1-C6 (rumbo;orientacion): /N00E;L/N90E;T/V;+/",
        47: "INTERVALO DE MUESTREO, C1-C6 (s)    : /0.02/0.02/0.02/",
        72: f"NUM. TOTAL DE MUESTRAS, C1-C6       : /{SHORT_COUNT}/{SHORT_COUNT}/{SHORT_COUNT}/",
        80: "UNIDADES DE LOS DATOS               : ACELERACION (cm/s/s)",
        90: "COMENTARIOS: SYNTHETIC, NO EARTHQUAKE, MADE BY MAKE_RECORDS.PY",
        108: "      N00E      N90E         V",
    }
    lines = [known.get(line, "") for line in range(1, 110)]
    return "\n".join(lines + table("10.3f", *components())) + "\n"


def main():
    folder = Path(__file__).resolve().parent
    for name, text in (("near_fault_pulse.txt", pulse_file()), ("strong_motion.AT2", noise_file()),
                       ("short_pulse.ASC", esm_file()), ("short_pulse.EW", knet_file()),
                       ("short_pulse.V2", csmip_file()), ("short_pulse.V2c", cosmos_file()),
                       ("short_pulse.smc", smc_file()), ("short_pulse.V2A", geonet_file()),
                       ("short_pulse.afad.txt", afad_file()), ("short_pulse.cwa.txt", cwa_file()),
                       ("short_pulse.asa", asa_file())):
        (folder / name).write_bytes(text.encode("ascii"))


if __name__ == "__main__":
    main()
