# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers become text by ways that no locale changes.

Usage: numbers_test.py <root of the repository>. printf() and streams write 0,5 where a host such as
Qt has chosen a locale with commas, and code that reads it again fails; base/Digits.h, and shown()
and exact() of the program, do not. Prints one line for each use, and fails if there is any.
"""

import pathlib
import re
import sys

SHARED = re.compile(r'printf\(.*%[-+ #0-9.*]*[aefg]|"[^"]*%[-+ #0-9.*]*[aefg][^"]*"|ostringstream'
                    r"|\b(stringstream|stod|stof|atof)\b")


def main(root):
    sources = sorted(path for folder in ("filters", "apps") for path in (root / folder).rglob("*")
                     if path.suffix in (".h", ".cxx"))
    faults = [f"{path.relative_to(root)}:{number}: {line.strip()}" for path in sources
              for number, line in enumerate(path.read_text().splitlines(), 1)
              if SHARED.search(line.split("//")[0])]
    assert sources and SHARED.search('snprintf(text, sizeof text, "%.2f and", x)')
    assert SHARED.search('    "w is %.0f") ') and not SHARED.search('printf("%3d %%", share)')
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
