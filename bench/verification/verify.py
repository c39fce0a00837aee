# SPDX-License-Identifier: MIT
"""Writes docs/verification.md: results that others have published beside what the program prints.

`./dev verify` runs it. Arguments: the program, the page, and optionally a folder of recorded
accelerations (.AT2), whose rows are written anew; without it those on the page stay.
Exit code 1: a figure is off by more than its bound.
"""

import json
import math
import shlex
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from isolator import G, equivalent_linear, matched_records
from spectra import elastic_spectrum, read_at2

ROOT = Path(__file__).resolve().parents[2]
HEAD = "| quantity | published | stillpoint | off by |\n|---|---|---|---|\n"
REAL = "<!-- records of your own: ./dev verify FOLDER -->\n"


class Program:
    """The program, run at the top of the repository, as the page's commands are."""

    def __init__(self, path):
        self.path = path

    def text(self, command):
        run = subprocess.run([self.path, *shlex.split(command)], cwd=ROOT, capture_output=True,
                             text=True, check=False)
        if run.returncode:
            sys.exit(f"verify: stillpoint {command}\n{run.stderr}")
        return run.stdout

    def report(self, command):
        return json.loads(self.text(command + " --json"))


@dataclass
class Row:
    """A figure as it is published: digits as they stand in the source, which bound the difference
    unless `bound` does."""
    quantity: str
    published: str
    ours: float
    bound: float | None = None

    @property
    def off(self):
        return self.ours - float(self.published)

    @property
    def allowed(self):
        """What was published is rounded, or cut off."""
        mantissa, _, power = self.published.partition("e")
        digits = len(mantissa.partition(".")[2])
        return 10.0 ** (int(power or 0) - digits) if self.bound is None else self.bound

    def __str__(self):
        off = f"{self.off:.0e}" if abs(self.off) > 1e-15 else "0"
        return f"| {self.quantity} | {self.published} | {self.ours:.10g} | {off} |\n"


def table(rows):
    for row in rows:
        if not abs(row.off) <= row.allowed:
            sys.exit(f"verify: {row.quantity}: {row.ours!r} instead of {row.published}")
    return HEAD + "".join(map(str, rows))


def commands(*lines):
    return "".join(f"    stillpoint {line}\n" for line in lines) + "\n"


# --- the checks, one a section ------------------------------------------------------------------


def released_mass(program):
    command = ("simulate --mass 1 --stiffness 1e4 --gravity 10 --velocity 0 --x0-m 0.85mm "
               "--friction-force 1N --delta-m 0")
    report = program.report(command)
    si = report["physical"]
    peaks = [1e3 * si["length_unit_m"] * h["side"] * h["peak"] for h in report["half_cycles"]]
    rows = [Row(f"extreme {i}, mm", text, peaks[i])
            for i, text in enumerate(["-0.65", "0.45", "-0.25"], start=1)]
    rows += [Row("rest, mm", "0.05", si["stop_position_m"] * 1e3),
             Row("stops at, s", "0.12566370614", si["stop_time_s"])]
    return f"""## A mass released with friction

Source: code_aster, Validation, V5.01.100, SDND100: m = 1 kg, k = 10 kN/m, normal force 10 N, mu = 0.1, released at 0.85 mm.
Its reference is analytical; the stop is at 4 pi/100 s.

{commands(command)}{table(rows)}"""


def sliding_power(program):
    base = ("simulate --p 1e-4 --v0 0 --f 1 --delta 0 --excitation harmonic --lambda 6.283185307179586 "
            "--k {} --t-end {}")

    def slid(amplitude, end):
        return program.report(base.format(amplitude, end))["response"]["slip_path"]

    rows = [Row(f"wear power, a = {a} m/s2", text, 10 * (slid(a, 12) - slid(a, 4)) / 8, bound)
            for a, text, bound in [("15", "15.2671", 2e-3), ("1.5", "0.409062", 2e-6),
                                   ("1.01", "2.26164e-4", 2e-7), ("0.99", "0", 0)]]
    return f"""## Wear under a shaking floor

Source: code_aster, Validation, V5.01.104, SDND104: a mass of 1 kg with friction of 1 N and next to no spring on a floor that
shakes with a sin 2 pi t. The wear power is the normal force, 10 N, times the path slid from 4 s to 12 s, divided by 8 s:
the `slip_path` of the reports.

{commands(base.format(15, 12))}{table(rows)}"""


def forced_amplitudes(program):
    base = ("simulate --p 1 --v0 0 --delta 0 --excitation harmonic --k 1 --phase 0 --t-end {} "
            "--f {} --lambda {} --damping {} --max-half-cycles 10000")

    def amplitude(f, ratio, damping, end):
        return program.report(base.format(end, f, ratio, damping))["half_cycles"][-2]["peak"]

    rows = [Row(f"amplitude, r = {r}, F/P = {f}, damping {z}", text, amplitude(f, r, z, end), 2e-9)
            for r, f, z, text, end in [("0.6", "0.2", "0", "1.550602854687", 20000),
                                       ("0.8", "0.3", "0", "2.626104875723", 20000),
                                       ("1.5", "0.2", "0", "0.765941686205", 20000),
                                       ("0.8", "0.3", "0.05", "2.346871967", 2000),
                                       ("1", "0.4", "0.1", "2.450073798", 2000),
                                       ("1.5", "0.2", "0.2", "0.615054904", 2000),
                                       ("0.6", "0.2", "0.05", "1.503724845", 2000)]]
    return f"""## Steady vibration with friction

Source: the closed form of J. P. Den Hartog, *Forced vibrations with combined Coulomb and viscous friction*, Transactions of
the ASME 53 (1931), evaluated: amplitude over P/k, for the frequency ratio r, friction F and a load of amplitude P. The
program knows nothing of it: it follows the motion from rest until its peaks settle.

{commands(base.format(2000, "0.3", "0.8", "0.05"))}{table(rows)}"""


def sliding_block(program):
    base = ("simulate --p 1e-4 --v0 0 --delta 0 --excitation harmonic --lambda 1 --k 1 --phase 0 "
            "--t-end {} --f {}")
    limit = 2 / math.sqrt(4 + math.pi**2)

    def stops(share):
        """In its 50th to 60th period."""
        late, early = (program.report(base.format(end * math.tau, repr(share * limit)))["response"]["sticks"]
                       for end in (60, 50))
        return late - early

    rows = [Row("stops in ten periods, friction 0.1 % below the limit", "0", stops(0.999)),
            Row("stops in ten periods, friction 0.1 % above it", "20", stops(1.001))]
    return f"""## A rigid block on a shaking table

Source: a block with next to no spring slides without stops under a sine if and only if its friction, over the largest
acceleration, is below 2/sqrt(4 + pi^2) = {limit:.6f}; a classical result, which follows from a velocity that is linear between turns.

{commands(base.format(377, 0.53644))}{table(rows)}"""


def newmark_block(program):
    base = "simulate --p 1e-4 --v0 0 --delta 0 --excitation rectangle --k 1 --lambda 3.141592653589793 --f {}"
    rows = []
    for f in (0.1, 0.25, 0.5):
        closed = 0.5 / f * (1 - f)
        peak = program.report(base.format(f))["response"]["peak_amplitude"]
        rows.append(Row(f"slip, N/A = {f}", f"{closed:.6g}", peak, 2e-6))
    return f"""## A block under one push

Source: N. M. Newmark, *Effects of earthquakes on dams and embankments*, Géotechnique 15 (1965): a rectangular push of
acceleration A that leaves the velocity V slides a block with yield acceleration N by V^2/(2N) (1 - N/A). Here A = V = 1.

{commands(base.format(0.25))}{table(rows)}"""


def shock_spectra(program):
    """f = Delta = 0: the mass never stops, so the run ends after two periods."""
    base = ("simulate --p 1 --v0 0 --f 0 --delta 0 --excitation {} --k 1 --lambda {} --t-end 13")
    rows = []
    for shape, share, text, formula in [
            ("rectangle", 0.25, "1.41421356", "2 sin(pi/4)"), ("rectangle", 0.5, "2", "2"),
            ("half-sine", 0.5, "1.57079633", "pi/2"), ("half-sine", 1.0, "1.73205081", "sqrt(3)")]:
        peak = program.report(base.format(shape, 1 / (2 * share)))["response"]["peak_amplitude"]
        rows.append(Row(f"{shape} of {share:g} periods: {formula}", text, peak))
    return f"""## Shock spectra

Source: the response to a rectangle and to half a sine without friction, as in A. K. Chopra, *Dynamics of Structures*, chapter
4: the largest displacement over the static one.

{commands(base.format("half-sine", "0.5"))}{table(rows)}"""


PERIODS = [0.2, 0.5, 1, 2, 3]


def spectra_of(program, file):
    """Rows of the program and of `spectra.py`; the largest difference, relative."""
    command = (f"spectrum --record {file} --period {','.join(map(str, PERIODS))} --f 0 --delta-m 0 "
               "--damping 5% --table -")
    ours = [[float(cell or "nan") for cell in line.split(",")] for line in program.text(command).split()[1:]]
    step, values = read_at2(ROOT / file)
    worst = 0.0
    for row, theirs in zip(ours, elastic_spectrum(step, values, PERIODS, 0.05)):
        worst = max(worst, abs(row[2] / theirs[0] - 1), abs(row[4] * G / theirs[1] - 1))
    if worst > 1e-6:
        sys.exit(f"verify: {file}: spectra differ by {worst}")
    return command, worst


def linear_spectra(program, folder, old_page):
    command, worst = spectra_of(program, "data/records/strong_motion.AT2")
    text = f"""## Elastic spectra at 5 % of damping

Source: a second integrator, `bench/verification/spectra.py`: the exact matrix of a step with a linear load, as N. C. Nigam and
P. C. Jennings gave it in 1969, each interval of the record in ten parts, and the extremes between by cubic Hermite
interpolation. Periods: {", ".join(map(str, PERIODS))} s. Compared are the largest displacement and the largest absolute
acceleration; the largest relative difference is given.

{commands(command)}| record | largest difference |
|---|---|
| `strong_motion.AT2` (synthetic) | {worst:.0e} |
{REAL}"""
    if folder is None:
        kept = old_page.partition(REAL)[2].partition("\n\n")[0]
        return text + (kept + "\n" if kept else "")
    for file in sorted(folder.glob("*.AT2")):
        text += f"| {file.stem} (recorded) | {spectra_of(program, file)[1]:.0e} |\n"
    return text


def isolator(program):
    method = equivalent_linear(radius=2.24, friction=0.06, one_second=0.9)
    rows = [Row("displacement, m", "0.434047", method.displacement),
            Row("period, s", "2.62402", method.period), Row("damping", "0.15052", method.damping),
            Row("reduction of the spectrum", "1.35156", method.reduction)]
    folder = ROOT / "build" / "verification"
    folder.mkdir(parents=True, exist_ok=True)
    records = list(matched_records(program, folder, one_second=0.9))

    def mean(period, friction, damping):
        """Of the records: the largest displacement in m."""
        command = f"simulate --period {period!r} --velocity 0 --f {friction} --delta-m 0 --damping {damping!r}"
        end = "" if friction else " --end-time 80"
        peaks = [program.report(f"{command} --record {file}{end}")["physical"]["peak_m"] for file in records]
        return sum(peaks) / len(peaks), min(peaks), max(peaks)

    exact, least, most = mean(math.tau * math.sqrt(2.24 / G), 0.06, 0.0)
    replaced = mean(method.period, 0, method.damping)[0]
    elastic = mean(method.period, 0, 0.05)[0]
    return f"""## An isolator by the equivalent linear method

Source: ASCE/SEI 7, chapter 17, equivalent lateral force: a pendulum isolator of radius 2.24 m with mu = 0.06 where
S_M1 = 0.9 g. What was iterated by hand, beside `bench/verification/isolator.py`:

{table(rows).replace("published | stillpoint", "by hand | by the script")}
The exact answer needs records. The script makes seven synthetic ones of 60 s whose elastic spectra at 5 % follow 0.9 g/T from
0.5 s to 5 s within 10 %. Displacements, mean of the seven:

| what moves | m |
|---|---|
| a spring of that period with 5 % of damping | {elastic:.3f} |
| the same by the method's spectrum | {method.displacement * method.reduction:.3f} |
| a spring of that period with the method's damping | {replaced:.3f} |
| the same by the method, the spectrum over its reduction | {method.displacement:.3f} |
| the isolator itself, exactly: {least:.2f} to {most:.2f} | {exact:.3f} |

So the spectrum is met, its reduction for damping is {"cautious" if replaced < method.displacement else "too large"} for such long records, and the rest of the difference is
friction that was replaced by damping. The method is a first estimate; it says nothing of the spread.
"""


def write(program, page, folder):
    sections = [released_mass(program), sliding_power(program), forced_amplitudes(program),
                sliding_block(program), newmark_block(program), shock_spectra(program),
                linear_spectra(program, folder, page.read_text() if page.exists() else ""),
                isolator(program)]
    page.write_text("""# Verification

This page sets results that others have published beside those of stillpoint. `./dev verify` writes it and fails if a figure is
off by more than the last digit that is published, or by more than the bound that stands in `bench/verification/verify.py`.
How exact the program is by its own measure is another page, [accuracy](accuracy.md).

""" + "\n".join(sections) + """
## What could not be compared

The stops in each cycle of H.-K. Hong and C.-S. Liu (2000), the transmissibility of L. Marino and A. Cicirello (2019) and the
decrements of B. F. Feeny and J.-W. Liang (1996) are the closest tests of this model that we know of. Their numbers stand in
papers that are not public; of the first two only the equations that they share with Den Hartog are checked above.
""")


if __name__ == "__main__":
    write(Program(sys.argv[1]), Path(sys.argv[2]), Path(sys.argv[3]).resolve() if len(sys.argv) > 3 else None)
