"""Makes a notebook from a script whose cells begin with "# %%": notebook.py tutorial.py tutorial.ipynb."""

import json
import sys
from pathlib import Path


def cells(script):
    """Pairs of the kind of a cell and its text."""
    for part in script.split("# %%")[1:]:
        title, _, body = part.partition("\n")
        text = body.strip("\n")
        if "[markdown]" in title:
            yield "markdown", "\n".join(line.removeprefix("#").removeprefix(" ") for line in text.splitlines())
        else:
            yield "code", text


def notebook(script):
    def cell(index, kind, text):
        extra = {"execution_count": None, "outputs": []} if kind == "code" else {}
        return {"cell_type": kind, "id": f"cell-{index}", "metadata": {}, "source": text.splitlines(keepends=True), **extra}

    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    made = [cell(index, kind, text) for index, (kind, text) in enumerate(cells(script))]
    return {"cells": made, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


if __name__ == "__main__":
    made = notebook(Path(sys.argv[1]).read_text())
    Path(sys.argv[2]).write_text(json.dumps(made, indent=1) + "\n")
