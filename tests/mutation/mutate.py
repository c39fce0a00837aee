#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Faults planted in the sources, and whether a test sees each: ./dev mutate.

mutants.tsv has a row for each: a file, an expression in it, and the wrong expression that takes its place. All are built
into one copy of the tree, where the environment variable STILLPOINT_MUTANT chooses one, so that only the tests run
again. An expression that stands more than once in its file is [[marked]] in what is
around it, where \\n ends a line. The tests of the
room come first, then those of the program. Exits with 1 if a mutant survives.
"""

import argparse
import json
import os
import re
import resource
import subprocess
import sys
from pathlib import Path

# For one test, of processor time and memory: a mutant that hangs or fills the machine is seen as well.
LIMITS = ((resource.RLIMIT_CPU, 120), (resource.RLIMIT_AS, 4 << 30))
SWITCH = """// SPDX-License-Identifier: MIT
#pragma once
#include <cstdlib>
inline bool stillpoint_mutant(int which) {
  static const char* const chosen = std::getenv("STILLPOINT_MUTANT");
  static const int number = chosen == nullptr ? 0 : std::atoi(chosen);
  return number == which;
}
"""
# Of a file in this folder: the executables whose tests may see it, the likely ones first.
ROOMS = (
    ("core/motion", ("free_tests", "forced_tests", "exact_tests", "design_tests")),
    ("core/records", ("records_tests", "cli_tests", "refusal_tests")),
    ("design/damper", ("design_tests", "sweep_tests", "cli_tests")),
    ("design/sweep", ("sweep_tests", "cli_tests")),
)


def mutants(table):
    with open(table, encoding="utf-8") as lines:
        rows = [line.rstrip("\n").replace("\\n", "\n").split("\t") for line in lines if not line.startswith("#")]
    return [(number, *row) for number, row in enumerate(rows, 1)]


def plant(tree, rows):
    """Writes all mutants into the tree."""
    tree.joinpath("mutant.hpp").write_text(SWITCH)
    texts = {}
    for number, file, right, wrong in rows:
        text = texts.setdefault(file, tree.joinpath(file).read_text())
        before, expression, after = re.fullmatch(r"(?s)(?:(.*)\[\[)?(.*?)(?:\]\]([^\]]*))?", right).groups("")
        around = before + expression + after
        if text.count(around) != 1:
            sys.exit(f"mutants.tsv, mutant {number}: '{around}' stands {text.count(around)} times in {file}")
        switch = f"(stillpoint_mutant({number}) ? ({wrong}) : ({expression}))"
        texts[file] = text.replace(around, before + switch + after)
    for file, text in texts.items():
        tree.joinpath(file).write_text(text)


def tests_of(build):
    answer = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], capture_output=True, text=True, check=True)
    found = {}
    for test in json.loads(answer.stdout)["tests"]:
        if "command" in test:
            found.setdefault(Path(test["command"][0]).name, []).append(test)
    return found


def limit():
    for what, most in LIMITS:
        resource.setrlimit(what, (most, most))


def fails(test, number):
    folder = next((each["value"] for each in test.get("properties", []) if each["name"] == "WORKING_DIRECTORY"), None)
    return subprocess.run(test["command"], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL, check=False, preexec_fn=limit,
                          env={**os.environ, "STILLPOINT_MUTANT": str(number)}).returncode != 0


def killer(number, file, tests, seen):
    """The test that sees the mutant. `seen` counts the kills of each, so that the sharpest come first."""
    for executable in next(names for folder, names in ROOMS if file.startswith(folder)):
        for test in sorted(tests[executable], key=lambda each: -seen.get(each["name"], 0)):
            if fails(test, number):
                seen[test["name"]] = seen.get(test["name"], 0) + 1
                return test["name"]
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("step", choices=("plant", "run"))
    parser.add_argument("tree", type=Path, help="the copy of the tree")
    parser.add_argument("only", nargs="*", type=int, help="numbers of mutants; default all")
    given = parser.parse_args()
    rows = mutants(Path(__file__).with_name("mutants.tsv"))
    if given.step == "plant":
        plant(given.tree, rows)
        return 0

    tests = tests_of(given.tree / "build" / "mutants")
    survivors = 0
    seen = {}
    chosen = [row for row in rows if not given.only or row[0] in given.only]
    for number, file, right, wrong in chosen:
        found = killer(number, file, tests, seen)
        survivors += found is None
        print(f"{number:3} {file}: {' '.join(right.split())} -> {wrong}: {'seen by ' + found if found else 'SURVIVES'}",
              flush=True)
    print(f"{len(chosen)} mutants, {survivors} survive")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
