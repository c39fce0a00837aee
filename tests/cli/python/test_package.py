# SPDX-License-Identifier: MIT
"""What comes with the module: its stub, its examples, its page."""

import ast
import inspect
import re
import subprocess
import sys
import zipfile
from importlib.util import find_spec
from pathlib import Path

from conftest import ROOT

import stillpoint

FOLDER = Path(stillpoint.__file__).parent
LARGEST_MODULE = 3_300_000  # bytes, with what Ubuntu's GCC adds to each function: see docs/python.md


def test_stub_has_every_name_and_argument():
    stub = ast.parse((FOLDER / "__init__.pyi").read_text())
    names = {node.name for node in stub.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    variables = {node.target.id for node in stub.body if isinstance(node, ast.AnnAssign)}
    assert {*stillpoint.__all__, "__version__"} <= names | variables
    assert names <= {*dir(stillpoint)}
    for node in stub.body:
        if isinstance(node, ast.FunctionDef):
            said = [one.arg for one in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs)]
            assert said == [*inspect.signature(getattr(stillpoint, node.name)).parameters], node.name
    assert (FOLDER / "py.typed").exists()


def test_every_function_is_described():
    for name in stillpoint.__all__:
        assert len(inspect.getdoc(getattr(stillpoint, name))) > 40 or name == "outcomes"


def test_module_is_small():
    modules = list(FOLDER.glob("_stillpoint*.so"))
    assert len(modules) == 1 and modules[0].stat().st_size < LARGEST_MODULE


def run(script, *arguments, folder):
    return subprocess.run([sys.executable, ROOT / "docs/python" / script, *arguments], cwd=folder,
                          capture_output=True, text=True, check=False)


def test_region_is_drawn(tmp_path):
    done = run("region.py", "40", "drawn.png", folder=tmp_path)
    assert "% of the dampers stop at x = 0" in done.stdout
    if find_spec("matplotlib"):
        assert done.returncode == 0, done.stderr
        assert (tmp_path / "drawn.png").read_bytes().startswith(b"\x89PNG")
    else:
        assert done.stderr == "without matplotlib there is no picture\n"


def test_design_for_a_suite_of_records(tmp_path):
    records = [ROOT / "data/records/near_fault_pulse.txt", ROOT / "data/records/strong_motion.AT2"]
    done = run("suite.py", *records, folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert len(re.findall(r": peak 0\.\d+ m, rests at", done.stdout)) == 2


def test_histogram_counts_every_row(tmp_path):
    done = run("histogram.py", "1000", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("1000 motions, ") and done.stdout.count(" to ") == 12


def test_page_shows_what_happens(monkeypatch):
    monkeypatch.chdir(ROOT)  # where the files of the page are
    page = (ROOT / "docs/python.md").read_text()
    blocks = re.findall(r"```python\n(.*?)```\n", page, re.DOTALL)
    assert len(blocks) >= 3
    names = {}
    for block in blocks:
        for statement in re.split(r"\n(?=\S)", block.strip()):
            code, _, said = statement.partition("  # -> ")
            if said:
                assert repr(eval(code, names)) == said, code
            else:
                exec(code, names)


def test_wheel_holds_the_package(tmp_path):
    subprocess.run(["cmake", f"-DPACKAGE={FOLDER}", f"-DOUTPUT={tmp_path / 'wheel'}", "-DVERSION=1.2", "-DTAG=a-b-c",
                    f"-DLICENSE={ROOT / 'LICENSE'}", "-P", ROOT / "cli" / "python" / "wheel.cmake"],
                   check=True, capture_output=True)
    with zipfile.ZipFile(tmp_path / "wheel" / "stillpoint-1.2-a-b-c.whl") as wheel:
        record = wheel.read("stillpoint-1.2.dist-info/RECORD").decode().split(",,\n")[:-1]
        assert sorted(record) == sorted(name for name in wheel.namelist() if not name.endswith("/"))
        wheel.extractall(tmp_path / "site")
    path = subprocess.run([sys.executable, "-c", "import stillpoint; print(stillpoint.__file__)"], check=True,
                          capture_output=True, text=True, env={"PYTHONPATH": str(tmp_path / "site")}).stdout
    assert path.startswith(str(tmp_path))
