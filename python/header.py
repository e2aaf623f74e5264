# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the structs of winding.h. The package in Python makes structs of ctypes from them.

Usage: header.py <winding.h>. Prints STRUCTS for _built.py.
"""

import pathlib
import re
import sys


def text_of(header):
    return re.sub(r"/\*.*?\*/", "", header.read_text(encoding="utf-8"), flags=re.DOTALL)


def structs_in(text):
    """Yields the names of structs, and the declarations of their members by names, in order."""
    for name, body in re.findall(r"typedef struct (\w+)\s*\{(.*?)\}\s*\1;", text, re.DOTALL):
        members = {}
        for declaration in filter(str.strip, body.split(";")):
            pointer = re.search(r"\(\*\s*(\w+)\)\s*\(", declaration)
            member = pointer or re.search(r"(\w+)\s*(\[[^\]]*\]\s*)*$", declaration)
            members[member[1]] = " ".join(declaration.split())
        yield name, members


def structs_of(header):
    """Returns the declarations of the members of all structs of a header, by names."""
    return {name.replace("winding_", "", 1): list(members.values())
            for name, members in structs_in(text_of(header))}


def structs_for_python(header):
    """Returns the line of _built.py with all structs of a header."""
    return "STRUCTS = " + repr(structs_of(header)).replace("], ", "],\n           ") + "\n"


if __name__ == "__main__":
    print(structs_for_python(pathlib.Path(sys.argv[1])), end="")
