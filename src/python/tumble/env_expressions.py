"""The expressions of rewards and ends of environments."""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np


class Expression:
    """A number or a truth value from named arrays: + - * / **, comparisons, and, or, not, and a few functions.

    It is compiled once and evaluated for all worlds in one pass. Nothing but these can be in its text.
    """

    FUNCTIONS: dict[str, Callable[..., Any]] = {
        "abs": np.abs, "min": np.minimum, "max": np.maximum, "sqrt": np.sqrt, "exp": np.exp, "sin": np.sin, "cos": np.cos,
        "clip": np.clip, "where": np.where, "sign": np.sign, "tanh": np.tanh,
    }  # fmt: skip
    _ALLOWED = (
        ast.Expression, ast.BinOp, ast.UnaryOp, ast.Compare, ast.BoolOp, ast.Call, ast.Name, ast.Load, ast.Constant, ast.Add,
        ast.Sub, ast.Mult, ast.Div, ast.Pow, ast.USub, ast.UAdd, ast.Not, ast.And, ast.Or, ast.Lt, ast.LtE, ast.Gt, ast.GtE,
        ast.Eq, ast.NotEq,
    )  # fmt: skip

    def __init__(self, text: str, names: set[str], where: str) -> None:
        self.text = text
        try:
            tree = ast.parse(text, mode="eval")
        except SyntaxError as error:
            raise ValueError(f"{where}: {text!r} is not an expression: {error.msg}") from None
        self.names: set[str] = set()
        functions = {id(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call)}
        for node in ast.walk(tree):
            if not isinstance(node, self._ALLOWED):
                raise ValueError(f"{where}: {text!r} may not contain {type(node).__name__}")
            if isinstance(node, ast.Constant) and not isinstance(node.value, (int, float)):
                raise ValueError(f"{where}: {text!r} may only contain numbers")
            if isinstance(node, ast.Call) and (not isinstance(node.func, ast.Name) or node.keywords):
                raise ValueError(f"{where}: {text!r} has a call that is not a function of numbers")
            if isinstance(node, ast.Name):
                known = set(self.FUNCTIONS) if id(node) in functions else names
                if node.id not in known:
                    raise ValueError(f"{where}: there is no '{node.id}'; known are {', '.join(sorted(known))}")
                self.names.add(node.id)
        code = ast.Expression(_Vectorised().visit(tree).body)
        self._code = compile(ast.fix_missing_locations(code), f"<{where}>", "eval")
        self._globals = {"__builtins__": {}, "_and": np.logical_and, "_or": np.logical_or, "_not": np.logical_not,
                         **self.FUNCTIONS}  # fmt: skip

    def __call__(self, values: Mapping[str, Any]) -> Any:
        return eval(self._code, self._globals, dict(values))


class _Vectorised(ast.NodeTransformer):
    """`a and b`, `not a` and `a < b < c` as functions of arrays."""

    @staticmethod
    def _call(name: str, arguments: list[ast.expr]) -> ast.expr:
        result = arguments[0]
        for argument in arguments[1:]:
            result = ast.Call(ast.Name(name, ast.Load()), [result, argument], [])
        return result

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.expr:
        self.generic_visit(node)
        return self._call("_and" if isinstance(node.op, ast.And) else "_or", node.values)

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.expr:
        self.generic_visit(node)
        return ast.Call(ast.Name("_not", ast.Load()), [node.operand], []) if isinstance(node.op, ast.Not) else node

    def visit_Compare(self, node: ast.Compare) -> ast.expr:
        self.generic_visit(node)
        sides = [node.left, *node.comparators]
        parts: list[ast.expr] = [ast.Compare(a, [op], [b]) for a, op, b in zip(sides, node.ops, sides[1:], strict=False)]
        return self._call("_and", parts)
