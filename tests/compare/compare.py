#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What differs between the answers of two builds of the program: ./dev compare COMMIT.

The commit's own pages and scenes are asked of both, so that its program is the oracle. Run times are masked. Without
--tasks: every command of README and docs, every scene under every command in every form, and wrong values of every
option. With --tasks: all JSON numbers of random tasks of all kinds; renamed.json beside this file maps the commit's
fields to those that have another name now, or to null for those that are gone. Exits with 1 if anything differs.
"""

import argparse
import concurrent.futures
import difflib
import json
import math
import os
import random
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

COMMANDS = ("design", "region", "simulate", "spectrum", "sweep", "accuracy")
FORMS = ("", "--verbose", "--json", "--html page.html", "--svg pictures")
MOST_SECONDS = 300  # of one command
# How long something took. Only `accuracy` has such times elsewhere, and no other times that end in these units.
MASKS = (
    (re.compile(r'("[a-z_]*wall_time[a-z_]*": )[^,\n]*'), r'\1"#"'),
    (re.compile(r"(evaluations?, )[0-9.]+\s[a-z]+"), r"\1#"),
    (re.compile(r"^(  time  +|<tr><th>time</th><td>)[0-9.]+\s[a-z]+", re.M), r"\1#"),
)
MASK_OF_ACCURACY = re.compile(r" *[0-9.]+ (?:ns|us|ms|s)\b")


class Program:
    """A build of the program, and the tree that it was built from."""

    def __init__(self, file, tree):
        self.file = str(Path(file).resolve())
        self.tree = Path(tree).resolve()

    def run(self, words, data):
        """What it prints, writes and returns, in a folder of its own that has the data of `data`."""
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(data / "data", Path(folder, "data"))
            Path(folder, "dampers.csv").write_text("f,delta\n0.26,0.37\n0.02,0.02\n")
            given = set(os.listdir(folder))
            try:
                answer = subprocess.run([self.file, *words], cwd=folder, capture_output=True, stdin=subprocess.DEVNULL,
                                        timeout=MOST_SECONDS, check=False,
                                        env={**os.environ, "COLUMNS": "80", "TERM": "dumb"})
                parts = {"exit code": str(answer.returncode), "output": answer.stdout, "messages": answer.stderr}
            except subprocess.TimeoutExpired:
                parts = {"exit code": f"none after {MOST_SECONDS} s"}
            for file in sorted(Path(folder).rglob("*")):
                name = file.relative_to(folder)
                if file.is_file() and name.parts[0] not in given:
                    parts[str(name)] = file.read_bytes()
        return {name: masked(part, words[0]) for name, part in parts.items()}


def masked(part, command):
    text = part if isinstance(part, str) else part.decode("utf-8", "backslashreplace")
    if command == "accuracy":
        text = MASK_OF_ACCURACY.sub(" #", text)
    for pattern, replacement in MASKS:
        text = pattern.sub(replacement, text)
    return text


def commands_of_pages(tree):
    """The commands that the pages show, as the test of pages finds them."""
    pages = [tree / "README.md", tree / "CONTRIBUTING.md", *(tree / "docs").rglob("*.md"), *(tree / "data").rglob("*.md")]
    for page in pages:
        for line in page.read_text().splitlines():
            if match := re.fullmatch(r"    stillpoint (.*?)(?: +#.*)?", line):
                yield shlex.split(match[1])


def forms_of_scenes(tree):
    for scene in sorted((tree / "data" / "scenes").glob("*.json")):
        for command in COMMANDS:
            for form in FORMS:
                yield [command, f"data/scenes/{scene.name}", *form.split()]


def wrong_values(program):
    """Each option of each command, alone, with values that are wrong for most."""
    for command in COMMANDS:
        text = subprocess.run([program.file, "help", command], capture_output=True, text=True, check=True).stdout
        for option in sorted(set(re.findall(r"^  (--[a-z0-9-]+) ", text, re.M))):
            for value in ([], [""], ["nan"], ["-1"], ["2:1"], ["1e999"], ["rubbish"]):
                yield [command, option, *value]


# --- random tasks -----------------------------------------------------------------------------------------------------


def option(dice, chance, name, value):
    return [f"--{name}", value] if dice.random() < chance else []


def number(dice, low, high):
    return repr(math.exp(dice.uniform(math.log(low), math.log(high))))


def around(dice, value, chance):
    """Sometimes a range."""
    if dice.random() >= chance:
        return repr(value)
    reach = dice.uniform(0.01, 0.2)
    return f"{value * (1 - reach)!r}:{value * (1 + reach)!r}"


def limits(dice):
    return [*option(dice, 0.2, "f-max", number(dice, 0.01, 1)), *option(dice, 0.3, "delta-max", number(dice, 0.01, 1)),
            *option(dice, 0.2, "acceleration-max", number(dice, 0.3, 2)),
            *option(dice, 0.3, "tolerance", repr(dice.uniform(0, 0.4))), *option(dice, 0.5, "criterion", "exact")]


def hit(dice):
    v0, p = (float(number(dice, 0.1, 10)) for _ in range(2))
    return ["--v0", around(dice, v0, 0.2), "--p", around(dice, p, 0.2), "--beta", repr(v0 / p * dice.uniform(0.5, 1.5)),
            *option(dice, 0.3, "arrivals", str(dice.randint(1, 6))),
            *option(dice, 0.3, "residual", repr(v0 / p * dice.uniform(0.001, 0.2))), *limits(dice)]


def pulse(dice):
    p = float(number(dice, 0.3, 3))
    return ["--pulse", dice.choice(["half-sine", "full-sine", "rectangle"]),
            "--k", around(dice, float(number(dice, 0.1, 10)), 0.15), "--lambda", around(dice, p * float(number(dice, 0.3, 30)), 0.1),
            "--p", around(dice, p, 0.1), "--beta", number(dice, 0.1, 5), *limits(dice)]


def design_of_hit(dice):
    return ["design", *hit(dice), *option(dice, 0.5, "objective", dice.choice(["robust", "amplitude", "time", "acceleration"])),
            *option(dice, 0.1, "trade-off", "5")]


def design_of_pulse(dice):
    return ["design", *pulse(dice), *option(dice, 0.5, "objective", dice.choice(["robust", "amplitude", "acceleration"]))]


def region_of_hit(dice):
    return ["region", *hit(dice), *option(dice, 0.7, "f", number(dice, 0.01, 1))]


def judged_point(dice):
    return ["region", *(hit if dice.random() < 0.7 else pulse)(dice), "--f", number(dice, 0.01, 1), "--delta", number(dice, 0.01, 1)]


def damper(dice):
    notch = dice.choice([[], [], ["--hold", number(dice, 0.001, 1)], ["--notch-width", number(dice, 0.001, 1)]])
    return ["--f", number(dice, 1e-3, 1), "--delta", dice.choice(["0", number(dice, 1e-3, 1)]), *notch]


def free_motion(dice):
    return ["simulate", "--v0", number(dice, 0.1, 10), "--p", number(dice, 0.1, 10),
            *option(dice, 0.2, "x0", number(dice, 0.01, 1)), *damper(dice)]


def forced_motion(dice):
    load = dice.choice(["harmonic", "half-sine", "full-sine", "rectangle", "record"])
    shape = (["--record", dice.choice(["data/records/near_fault_pulse.txt", "data/records/strong_motion.AT2"])]
             if load == "record" else ["--k", number(dice, 0.05, 3), "--lambda", number(dice, 0.1, 10)])
    return ["simulate", "--v0", dice.choice(["0", number(dice, 0.1, 2)]), "--p", number(dice, 0.3, 3), *damper(dice),
            "--excitation", load, *shape, "--t-end", repr(dice.uniform(1, 100))]


RECORDS = ["--record", "data/records/near_fault_pulse.txt", "--record", "data/records/strong_motion.AT2"]


def design_of_records(dice):
    return ["design", *RECORDS, "--period", number(dice, 1, 4), "--max-displacement", number(dice, 0.1, 0.6),
            *option(dice, 0.5, "residual-m", number(dice, 0.002, 0.05)), *option(dice, 0.3, "delta-max-m", number(dice, 0.001, 0.1)),
            *option(dice, 0.3, "hold", number(dice, 0.01, 0.3)), "--scan-points", "1000"]


def spectrum(dice):
    return ["spectrum", *RECORDS, "--period", "1:4:8", "--f", number(dice, 0.01, 0.2), "--delta-m", number(dice, 0.001, 0.1)]


KINDS = {design_of_hit: 30, region_of_hit: 10, judged_point: 15, design_of_pulse: 12, free_motion: 12, forced_motion: 16,
         spectrum: 3, design_of_records: 2}


def tasks(count, seed):
    dice = random.Random(seed)
    for kind in dice.choices(list(KINDS), list(KINDS.values()), k=count):
        yield [*kind(dice), "--json"]


# --- differences ------------------------------------------------------------------------------------------------------


def leaves(value, path=""):
    """The names and values of a report's numbers, words and truths; indices of arrays are left out of `names`."""
    if isinstance(value, dict):
        for key, each in value.items():
            yield from leaves(each, f"{path}.{key}" if path else key)
    elif isinstance(value, list):
        for index, each in enumerate(value):
            yield from leaves(each, f"{path}[{index}]")
    else:
        yield path, value


def renamed(path, table):
    """The name of a field now: the longest beginning that the table has is replaced; None if it is gone."""
    plain = re.sub(r"\[\d+\]", "[]", path)
    for known in sorted(table, key=len, reverse=True):
        if plain == known or plain.startswith((known + ".", known + "[")):
            if table[known] is None:
                return None
            indices = iter(re.findall(r"\[\d+\]", path))
            new = re.sub(r"\[\]", lambda _: next(indices, "[0]"), table[known] + plain[len(known):])
            return new
    return path


def same(old, new, relative):
    numbers = all(isinstance(each, (int, float)) and not isinstance(each, bool) for each in (old, new))
    if numbers and relative > 0:
        return abs(old - new) <= relative * max(abs(old), abs(new))
    return old == new


def differing_fields(old, new, table, relative):
    """Of two answers in JSON: the fields of the old one that the new one lacks or has with another value."""
    try:
        old, new = json.loads(old), json.loads(new)
    except ValueError:
        return [] if old == new else [f"{old[:200]!r} -> {new[:200]!r}"]
    now = dict(leaves(new))
    found = []
    for path, value in leaves(old):
        target = renamed(path, table)
        if target is None or value == "#":
            continue
        if path in now:  # of a command whose fields have their old names
            target = path
        if target not in now and value is None:  # an object that does not exist has no fields
            continue
        if target not in now:
            found.append(f"{path}: {value!r} -> no field {target}")
        elif not same(value, now[target], relative):
            found.append(f"{path}: {value!r} -> {now[target]!r}")
    return found


def differing_parts(old, new):
    found = []
    for name in sorted(old.keys() | new.keys()):
        if old.get(name) != new.get(name):
            lines = difflib.unified_diff(old.get(name, "").splitlines(), new.get(name, "").splitlines(), "", "", "", "", 0, "")
            found += [f"{name}:", *(line for line in lines if not line.startswith(("---", "+++", "@@")))]
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", help="the commit's program")
    parser.add_argument("old_tree")
    parser.add_argument("new", help="the work tree's program")
    parser.add_argument("new_tree")
    parser.add_argument("--tasks", type=int, metavar="N", help="compare the JSON of N random tasks")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--relative", type=float, default=0, help="numbers may differ by this much; default 0, by no bit")
    parser.add_argument("--only", default="", metavar="TEXT", help="only commands that contain this")
    parser.add_argument("--lines", type=int, default=12, help="shown of each difference; default 12")
    given = parser.parse_args()

    old = Program(given.old, given.old_tree)
    new = Program(given.new, given.new_tree)
    table = json.loads(Path(__file__).with_name("renamed.json").read_text())
    if given.tasks:
        asked = list(tasks(given.tasks, given.seed))
    else:
        asked = [*commands_of_pages(old.tree), *forms_of_scenes(old.tree), *wrong_values(old)]
    asked = [words for words in asked if given.only in shlex.join(words)]

    def difference(words):
        one, other = (program.run(words, old.tree) for program in (old, new))
        if "--json" not in words or one["exit code"] not in ("0", "3"):
            return differing_parts(one, other)
        codes = [] if one["exit code"] == other["exit code"] else [f"exit code: {one['exit code']} -> {other['exit code']}"]
        return codes + differing_fields(one["output"], other["output"], table, given.relative)

    differing = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for words, found in zip(asked, pool.map(difference, asked)):
            if found:
                differing += 1
                print(f"\nstillpoint {shlex.join(words)}")
                print("\n".join(f"  {line}" for line in found[:given.lines]))
                if len(found) > given.lines:
                    print(f"  ... and {len(found) - given.lines} more lines")
    print(f"\n{len(asked)} commands, {differing} differ" + (f"; seed {given.seed}" if given.tasks else ""))
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
