# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page docs/options.md is what filters/Options.def makes of it.

Usage: options_page.py <root of the repository> [--write]. Compares the page with the list, and
fails if they differ; with --write, writes it anew.
"""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from options import options_in  # noqa: E402

BEGIN = """# All options

What each option is called in C++ (a property, as `SetTolerance()`), in ParaView's panels, in the
program `winding` and in Python. Members of structs in C have most of these names in small letters:
`fill_cavities`. An empty place means that a front end has no name for it, or that it is an
argument of a function or another command: `boolean(…, "union")`. Not every filter and command has
every option: panels, `--help` and the [reference](reference.md) show what one of them has. Panels
show options with a \\* among the advanced ones, behind the gear, and begin with other values for a
few. This page is made of `filters/Options.def`.
"""
HEAD = """
| option | default | C++ | ParaView | program | Python |
|---|---|---|---|---|---|
"""


def default_of(option):
    """Returns the default in words: that of a choice in the program's, or else in ParaView's."""
    if option.kind == "flag":
        return "on" if option.default == "1" else "off"
    if option.kind == "text":
        return option.default and f"`{option.default}`"
    _, label, word = option.choices.get(option.default, ("", option.default, ""))
    return f"`{word}`" if word else label


def row_of(option):
    """Returns the line of an option: what it is for, its choices, and its names."""
    words = [word or label for _, label, word in option.choices.values()]
    text = option.help + (": " + ", ".join(words) if len(words) > 1 else "")
    if option.unit and option.unit not in text.lower():
        text += f" [{option.unit}]"
    names = [f"`{option.property}`", option.label.replace("*", "\\*"),
             option.option and f"`{option.option}`", option.keyword and f"`{option.keyword}`"]
    return re.sub(" +", " ", f"| {' | '.join([text, default_of(option), *names])} |\n")


def page(root):
    """Returns the text of the page: a table for each part of the list."""
    path = root / "filters" / "Options.def"
    options = {option.name: option for option in options_in(path)}
    text = BEGIN
    # A heading is a comment between empty lines and options.
    for line in re.findall(r"^(?<=\n\n)// .*(?=\nOPTION)|^OPTION\(\w+", path.read_text(),
                           re.MULTILINE):
        if line.startswith("//"):
            text += f"\n## {line[3:]}\n{HEAD}"
        else:
            text += row_of(options[line.partition("(")[2]])
    return text


def main(root, is_to_be_written=False):
    target = root / "docs" / "options.md"
    if is_to_be_written:
        target.write_text(page(root))
    if target.read_text() != page(root):
        print("FAULT docs/options.md is not what filters/Options.def makes: "
              "python3 tests/docs/options_page.py . --write")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), "--write" in sys.argv[2:]))
