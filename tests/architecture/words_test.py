# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lines have at most 100 columns, comments open with a verb or their subject, comments of Python's
functions with a verb, and words that make a reader read twice only get fewer.

Usage: words_test.py <root of the repository>. Prints one line for each fault, and fails if there is
any. Whether a comment can be read alone is beyond a test; this one finds those that surely cannot.
"""

import ast
import pathlib
import re
import sys

COLUMNS = 100
FOLDERS = ("apps", "data", "filters", "packages", "paraview-plugin", "python", "tests")
SUFFIXES = (".h", ".cxx", ".py")

# A comment that opens so has its subject in its neighbour, or nowhere.
OPENING = r"(Of|Those|As|What|That|Than|Nor|Which|With|From|But)"
RIDDLE = re.compile(rf"^\s*(///<?|//|/\*\*|\*) {OPENING} ")

# Words to avoid in filters and apps (CONTRIBUTING.md), and how often they may still stand there.
# Lower a number when you have made it fall; never raise one.
MOST = {
    r"(those|that) of": 15,
    r"tells?|told|telling": 21,
    r"beside": 5,
    r"so (many|much|long|far|few)": 17,
    r"of (which|whom)": 14,
    r"but for": 0,
    r"such": 41,
}
COMMENT_MARK = re.compile(r"\s*\n\s*(///?<?|\*)?\s*")


def without_verb(root):
    """Yields functions of Python, except properties, whose comment does not open with a verb."""
    for folder in ("python/vtkwinding", "paraview-plugin/python"):
        for path in sorted((root / folder).rglob("*.py")):
            for node in ast.walk(ast.parse(path.read_text())):
                if not isinstance(node, ast.FunctionDef) or ast.get_docstring(node) is None:
                    continue
                if any("property" in ast.unparse(decorator) for decorator in node.decorator_list):
                    continue
                first = ast.get_docstring(node).split()[0]
                if not re.fullmatch("[A-Z][a-z]*s", first) or first in ("As", "This"):
                    where = f"{path.relative_to(root)}:{node.lineno}"
                    yield f"{where}: {node.name} opens with '{first}'"


def main(root):
    faults, files, texts = [], 0, []
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in SUFFIXES:
                continue
            files += 1
            name = path.relative_to(root)
            text = path.read_text()
            if folder in ("apps", "filters"):
                texts.append(COMMENT_MARK.sub(" ", text))
            for number, line in enumerate(text.splitlines(), 1):
                if len(line) > COLUMNS:
                    faults.append(f"{name}:{number}: {len(line)} columns")
                if RIDDLE.match(line):
                    faults.append(f"{name}:{number}: {line.strip()}")
    faults += without_verb(root)
    if files == 0:
        faults.append(f"no files below {root}")
    for words, most in MOST.items():
        pattern = re.compile(rf"\b({words})\b", re.IGNORECASE)
        count = sum(len(pattern.findall(text)) for text in texts)
        print(f"{count:4} of at most {most:4}: {words}")
        if count > most:
            faults.append(f"{count} times '{words}' in filters and apps, at most {most}")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
