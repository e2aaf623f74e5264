# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of filters/Options.def."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')


class Option:
    def __init__(self, text):
        fields = STRING.findall(text)
        self.name = text.split(",")[0].strip()
        self.kind = text.split(",")[2].strip()
        self.property, self.default, self.help = fields[0], fields[1], fields[-1]
        self.label, self.option, self.keyword = fields[-4], fields[-3], fields[-2]
        self.highest = float(re.search(r'", *[^",]+, *([^",]+),\s*"', text)[1])
        self.unit = fields[2]
        self.choices = {}


def options_in(path=ROOT / "filters" / "Options.def"):
    """All options; of choices by number the constant in C++, the entry in ParaView, and the
    word."""
    options, text = [], re.sub(r"//.*", "", path.read_text())
    for kind, body in re.findall(r"^(OPTION|CHOICE)\((.*?)\)$", text, re.MULTILINE | re.DOTALL):
        if kind == "OPTION":
            options.append(Option(body))
        else:
            name, number, rest = body.split(",", 2)
            assert options[-1].name == name.strip(), body
            options[-1].choices[number.strip()] = STRING.findall(rest)
    return options
