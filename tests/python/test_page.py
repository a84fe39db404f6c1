"""The examples of the page run."""

import re
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
EXAMPLES = re.findall(r"```python\n(.*?)```", (PROJECT / "src/python/README.md").read_text(), re.DOTALL)


def test_the_page_has_examples():
    assert len(EXAMPLES) == 5


def test_a_custom_environment_takes_thirty_lines():
    (example,) = [example for example in EXAMPLES if '"custom"' in example and "Scene({" in example]
    assert sum(bool(line.strip()) for line in example.splitlines()) <= 30
    assert '"format": 1' in example  # so that the scene may be pasted into a file


@pytest.mark.parametrize("example", range(len(EXAMPLES)))
def test_an_example_of_the_page_runs(example, tmp_path, monkeypatch):
    (tmp_path / "scenes").symlink_to(PROJECT / "scenes")
    monkeypatch.chdir(tmp_path)
    exec(compile("import tumble\n" + EXAMPLES[example], f"example {example}", "exec"), {})
