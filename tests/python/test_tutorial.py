"""The tutorial runs, its notebook has the same cells, and what it says is so."""

import json
import runpy
from pathlib import Path

import numpy as np
import pytest

TUTORIAL = Path(__file__).resolve().parents[2] / "src" / "python" / "tutorial"


def test_the_tutorial_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    end = runpy.run_path(str(TUTORIAL / "tutorial.py"))
    # The ball bounces from 4 m: at 0.8 of the speed of sqrt(2 g 3.5 m) it rises by 0.64 of 3.5 m.
    heights = end["heights"]
    lowest = heights.index(min(heights))
    assert 0.5 <= heights[lowest] < 0.5 + np.sqrt(2 * 10 * 3.5) / 60
    assert max(heights[lowest:]) == pytest.approx(0.5 + 0.64 * 3.5, abs=2e-3)
    assert end["hinge"].speed == pytest.approx(1.5, abs=0.01)
    assert end["hit"].body == end["target"]
    assert end["run"].passed
    assert end["gap"].distance == 2
    assert end["careful"] > 590 > 400 > end["lazy"]


def test_the_notebook_is_made_from_the_script():
    notebook = runpy.run_path(str(TUTORIAL / "notebook.py"))["notebook"]
    made = notebook((TUTORIAL / "tutorial.py").read_text())
    assert json.loads((TUTORIAL / "tutorial.ipynb").read_text()) == made


def test_the_cells_of_the_notebook_run_in_order():
    names = {}
    for cell in json.loads((TUTORIAL / "tutorial.ipynb").read_text())["cells"]:
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), cell["id"], "exec"), names)
    assert names["careful"] > 590
