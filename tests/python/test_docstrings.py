"""Every public name of the package has a docstring, and the page of the API lists it."""

import inspect
from pathlib import Path

import tumble
import tumble.env
import tumble.errors

MODULES = (tumble, tumble.env, tumble.errors)
INDEX = (Path(__file__).resolve().parents[2] / "src/python/docs/index.rst").read_text()


def public_members(kind):
    """The methods and properties that a class of the package defines."""
    for name, member in vars(kind).items():
        if not name.startswith("_") and (callable(member) or isinstance(member, (property, staticmethod, classmethod))):
            yield name, member


def undocumented():
    for module in MODULES:
        for name, value in vars(module).items():
            if name.startswith("_") or not str(getattr(value, "__module__", "")).startswith("tumble"):
                continue
            if not inspect.getdoc(value):
                yield f"{module.__name__}.{name}"
            if inspect.isclass(value):
                yield from (f"{name}.{part}" for part, member in public_members(value) if not inspect.getdoc(member))


def test_everything_public_has_a_docstring():
    assert list(undocumented()) == []


def test_the_api_reference_lists_everything():
    assert [name for name in tumble.__all__ if f"tumble.{name}\n" not in INDEX and name not in vars(tumble.errors)] == []
