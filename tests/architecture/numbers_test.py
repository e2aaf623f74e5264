# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers become text by ways that no locale changes.

Usage: numbers_test.py <root of the repository>. printf() and streams write 0,5 where a host such as
Qt has chosen a locale with commas, and code that reads it again fails; base/Digits.h, and shown()
and exact() of the program, do not. Words become numbers by from_chars(), or by streams of the
classic locale. Prints one line for each other use, and fails if there is any.
"""

import pathlib
import re
import sys

SHARED = re.compile(r'printf\(.*%[-+ #0-9.*]*[aefg]|"[^"]*%[-+ #0-9.*]*[aefg][^"]*"|ostringstream'
                    r"|\b(stringstream|stod|stof|stold|atof|strtod|strtof|strtold)\b")
STREAM = re.compile(r"\bistringstream\b\s*(\w*)")


def reads_numbers(name, text):
    """Whether a stream `name`, empty for one without a name, may read more than words in a text."""
    if name and re.search(rf"\b{name}\.imbue\(std::locale::classic\(\)\)", text):
        return False
    return not name or any(not re.search(rf"std::string (\w+, )*{read}\b", text)
                           for read in re.findall(rf"\b{name} >> (\w+)", text))


def faults_in(text):
    """Pairs of the number of a line and the line."""
    return [(number, line.strip()) for number, line in enumerate(text.splitlines(), 1)
            if SHARED.search(line.split("//")[0])
            or any(reads_numbers(name, text) for name in STREAM.findall(line.split("//")[0]))]


def main(root):
    sources = sorted(path for folder in ("filters", "apps") for path in (root / folder).rglob("*")
                     if path.suffix in (".h", ".cxx"))
    faults = [f"{path.relative_to(root)}:{number}: {line}" for path in sources
              for number, line in faults_in(path.read_text())]
    assert sources and SHARED.search('snprintf(text, sizeof text, "%.2f and", x)')
    assert SHARED.search('    "w is %.0f") ') and not SHARED.search('printf("%3d %%", share)')
    stream = "std::istringstream words(text);\n{}double x; std::string word; words >> {};"
    assert faults_in(stream.format("", "x")) and faults_in("std::istringstream(text) >> word;")
    assert not faults_in(stream.format("", "word")) and faults_in("x = std::strtod(a, &end);")
    assert not faults_in(stream.format("words.imbue(std::locale::classic()); ", "x"))
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
