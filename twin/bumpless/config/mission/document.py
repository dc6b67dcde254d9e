"""YAML as a tree of nodes that know their place, so that every complaint can name line and column."""

import io
import math
import re
from typing import Any

from ruamel.yaml import YAML
from ruamel.yaml.error import MarkedYAMLError, YAMLError
from ruamel.yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from bumpless.config.problems import Problem

LARGEST_FILE = 32_768  # characters; a mission is a page of text
_DEEPEST = 6
_LARGEST_BITS = 1024  # of a whole number: a larger one has no place among floats and counts as infinite
_DEEPEST_FLOW = 50  # brackets and indicators in a row that cost the YAML scanner more than linear time
_HALF_CHARACTER = re.compile("[\ud800-\udfff]")


class Document:
    """A parsed file with the place of each field that was read and the problems found so far."""

    def __init__(self, text: str, source: str) -> None:
        self.source = source
        self.problems: list[Problem] = []
        self.places: dict[str, tuple[int, int]] = {"": (1, 1)}
        self.root = self._compose(text)

    def _compose(self, text: str) -> Node | None:
        if len(text) > LARGEST_FILE:
            self.refuse("", None, f"the file is longer than {LARGEST_FILE} characters")
            return None
        if _open_brackets(text) > _DEEPEST_FLOW:
            self.refuse("", None, "is nested too deeply")
            return None
        try:
            root = YAML(typ="rt", pure=True).compose(io.StringIO(text))
        except MarkedYAMLError as error:
            mark = error.problem_mark or error.context_mark
            line, column = (mark.line + 1, mark.column + 1) if mark else (0, 0)
            reason = " ".join(str(part) for part in (error.context, error.problem) if part)
            self.problems.append(Problem(self.source, line, column, "", None, f"not valid YAML: {reason}"))
            return None
        except RecursionError:
            self.refuse("", None, "is nested too deeply")
            return None
        except YAMLError as error:
            self.refuse("", None, f"not valid YAML: {str(error).splitlines()[0]}")
            return None
        if not isinstance(root, MappingNode):
            self.refuse("", None, "must hold named fields such as `name: docking`")
            return None
        return None if self._refuse_shape(root, 0, set()) else root

    def _refuse_shape(self, node: Node, depth: int, seen: set[int]) -> bool:
        """Whether the tree is no tree (aliases) or too deep, either of which could make reading endless,
        or holds text that cannot be written down as UTF-8."""
        rule = "is nested too deeply" if depth > _DEEPEST else ""
        if id(node) in seen:
            rule = "anchors and aliases are not used in mission files"
        if isinstance(node, ScalarNode) and _HALF_CHARACTER.search(node.value):
            rule = "holds half of a character (a surrogate), which no text may"
        if rule:
            line, column = node.start_mark.line + 1, node.start_mark.column + 1
            self.problems.append(Problem(self.source, line, column, "", None, rule))
            return True
        seen.add(id(node))
        children: list[Node] = []
        if isinstance(node, MappingNode):
            children = [part for pair in node.value for part in pair]
        elif isinstance(node, SequenceNode):
            children = node.value
        return any(self._refuse_shape(child, depth + 1, seen) for child in children)

    def note(self, path: str, node: Node) -> None:
        """Remember where a field stands."""
        self.places[path] = (node.start_mark.line + 1, node.start_mark.column + 1)

    def refuse(self, path: str, value: Any, rule: str) -> None:
        """Add a problem at the place of `path`, or of the nearest part around it."""
        around = path
        while around not in self.places:
            around = around[: max(around.rfind("."), around.rfind("["), 0)]
        line, column = self.places[around]
        self.problems.append(Problem(self.source, line, column, path, value, rule))

    def items(self, node: Node, path: str) -> dict[str, Node]:
        """Fields of a mapping; a second one of the same name is a problem at its own place."""
        if not isinstance(node, MappingNode):
            self.refuse(path, shown(node), "must hold named fields")
            return {}
        found: dict[str, Node] = {}
        for key_node, value_node in node.value:
            key = str(key_node.value) if isinstance(key_node, ScalarNode) else "?"
            inner = f"{path}.{key}" if path else key
            if key in found:
                line, column = key_node.start_mark.line + 1, key_node.start_mark.column + 1
                first = self.places[inner][0]
                rule = f"appears twice; first on line {first}"
                self.problems.append(Problem(self.source, line, column, inner, shown(value_node), rule))
                continue
            self.note(inner, key_node)
            found[key] = value_node
        return found

    def plain(self, node: Node, path: str) -> Any:
        """A node as plain Python values, for parts whose form is checked elsewhere."""
        if isinstance(node, MappingNode):
            return {key: self.plain(item, f"{path}.{key}") for key, item in self.items(node, path).items()}
        if isinstance(node, SequenceNode):
            for i, item in enumerate(node.value):
                self.note(f"{path}[{i}]", item)
            return [self.plain(item, f"{path}[{i}]") for i, item in enumerate(node.value)]
        return scalar(node)


def _open_brackets(text: str) -> int:
    """How deep brackets nest at most; strings and comments are not told apart, the limit is generous."""
    deepest = depth = 0
    for mark in re.findall(r"[\[\]{}]|(?:[-?] ){2,}", text):
        if len(mark) > 1:
            deepest = max(deepest, len(mark) // 2)
            continue
        depth = depth + 1 if mark in "[{" else max(depth - 1, 0)
        deepest = max(deepest, depth)
    return deepest


def scalar(node: Node) -> Any:
    """The value of a scalar by the YAML 1.2 core schema; text when it is nothing else."""
    kind = str(node.tag).rsplit(":", 1)[-1]
    value: str = node.value
    try:
        if kind == "int":
            number = int(value.replace("_", ""), 0)
            return number if number.bit_length() < _LARGEST_BITS else math.inf if number > 0 else -math.inf
        if kind == "float":
            return float(value.replace("_", "").lower().replace(".inf", "inf").replace(".nan", "nan"))
    except ValueError:
        return value
    if kind == "bool":
        return value.lower() == "true"
    return None if kind == "null" else value


def shown(node: Node) -> Any:
    """What a problem prints for a node."""
    if isinstance(node, MappingNode):
        return "{...}"
    if isinstance(node, SequenceNode):
        return [shown(item) if isinstance(item, SequenceNode) else item.value for item in node.value[:7]]
    return scalar(node) if scalar(node) is not None else "null"
