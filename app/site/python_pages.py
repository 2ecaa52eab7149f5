"""The page of the Python package: signatures from its stub, and sentences from its binding, so that no build is needed."""

import ast
import collections
import pathlib
import re

STRING = r'R"\((?:.|\n)*?\)"|"(?:[^"\\\n]|\\.)*"'
CALL = re.compile(r'(?P<class>py::class_<[^;"]*?>\s*\w*\s*\()|(?P<module>\bmodule)?\s*\.def(?:_property_readonly|_readonly|_static)?\(')


def arguments(text, start):
    """The arguments of a call; the first one begins at `start`."""
    parts, depth, begin, at = [], 0, start, start
    while depth >= 0:
        string = re.compile(STRING + r"|//[^\n]*|'(?:[^'\\]|\\.)'").match(text, at)
        if string:
            at = string.end()
            continue
        if text[at] in "([{":
            depth += 1
        elif text[at] in ")]}":
            depth -= 1
        if depth < 0 or (depth == 0 and text[at] == ","):
            parts.append(text[begin:at].strip())
            begin = at + 1
        at += 1
    return parts


def string_of(code):
    """The text of adjacent C++ string literals, or None if the code has anything else."""
    if not re.fullmatch(rf"(?:(?:{STRING})\s*)+", code):
        return None
    return "".join(s[3:-2] if s[0] == "R" else ast.literal_eval(s) for s in re.findall(STRING, code))


def sentences():
    """The docstrings in the binding, by "function", "Class" or "Class.member"; one for each overload, in order."""
    said = collections.defaultdict(list)
    for path in sorted(pathlib.Path("app/python/binding").glob("*.cpp")):
        text, owner = path.read_text(), ""
        for call in CALL.finditer(text):
            parts = arguments(text, call.end())
            if call["class"]:
                owner, name = string_of(parts[1]), ""
            else:
                name = "__init__" if parts[0].startswith("py::init") else string_of(parts[0])
            key = ".".join(part for part in ("" if call["module"] else owner, name) if part)
            if (doc := string_of(parts[-1])) and len(parts) > 1:
                said[key].append(doc)
        # Members that a loop adds from a list of names and docstrings.
        for name, doc in re.findall(rf"^ *\{{({STRING}), ({STRING})\}},$", text, flags=re.M):
            said[f"{owner}.{string_of(name)}"].append(string_of(doc))
    return said


def block(directive, signature, doc, inside="", option=""):
    """A directive of MyST; its fence is longer than the fences inside."""
    fence = "`" * (3 + max((len(run) for run in re.findall(r"`{3,}", inside)), default=2) - 2)
    escaped = re.sub(r"([*_<\[`])", r"\\\1", doc)
    if directive == "py:property":
        signature, _, type_ = signature.partition(" -> ")
        option = f":type: {type_}\n"
    return f"{fence}{{{directive}}} {signature}\n{option}\n{escaped}\n\n{inside}{fence}\n\n"


def signature(function, is_member):
    arguments_ = function.args
    if is_member:
        arguments_.args = arguments_.args[1:]
    return f"{function.name}({ast.unparse(arguments_)})" + (f" -> {ast.unparse(function.returns)}" if function.returns else "")


def python_page():
    package = ast.parse(pathlib.Path("app/python/scb/__init__.py").read_text())
    errors = ast.parse(pathlib.Path("app/python/scb/errors.py").read_text())
    said, missing, result = sentences(), [], []

    def doc_of(key):
        if not said[key]:
            missing.append(key)
            return ""
        return said[key].pop(0) if len(said[key]) > 1 else said[key][0]

    listed = set()
    for node in ast.parse(pathlib.Path("app/python/scb/_scb.pyi").read_text()).body:
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            # Links lead to the first overload.
            option = ":noindex:\n" if node.name in listed else ""
            listed.add(node.name)
            result.append(block("py:function", signature(node, False), doc_of(node.name), option=option))
        elif isinstance(node, ast.ClassDef):
            members, start, doc = "", "", doc_of(node.name)
            for member in (m for m in node.body if isinstance(m, ast.FunctionDef)):
                key = f"{node.name}.{member.name}"
                if member.name == "__init__":
                    start = signature(member, True).removeprefix("__init__").removesuffix(" -> None")
                    doc += "\n\n" + doc_of(key)
                elif not member.name.startswith("_"):
                    is_property = any(ast.unparse(d) == "property" for d in member.decorator_list)
                    text = signature(member, True)
                    members += block(
                        "py:property" if is_property else "py:method", text.replace("()", "") if is_property else text, doc_of(key)
                    )
            result.append(block("py:class", node.name + start, doc, members))
    for node in errors.body:
        if isinstance(node, ast.ClassDef):
            result.append(block("py:exception", node.name, ast.get_docstring(node) or ""))
    if missing:
        raise SystemExit(f"app/python/binding says nothing of {', '.join(missing)}.")
    return (
        "# The module `scb`\n\n" + ast.get_docstring(package).replace("The manual is\napp/python/README.md of the project.", "")
        + "[The manual](../app/python/index.md) has examples.\n\n```{py:module} scb\n```\n\n" + "".join(result)
    )
