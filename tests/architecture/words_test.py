"""Lines have at most 100 columns, and comments open with their subject.

Usage: words_test.py <root of the repository>. Prints one line for each fault, and fails if there is
any. Whether a comment can be read alone is beyond a test; this one finds those that surely cannot.
"""

import pathlib
import re
import sys

COLUMNS = 100
FOLDERS = ("apps", "data", "filters", "tests")
SUFFIXES = (".h", ".cxx")

# A comment that opens so has its subject in its neighbour, or nowhere.
OPENING = r"(Of|Those|As|What|That|Than|Nor|Which|With|From|But)"
RIDDLE = re.compile(rf"^\s*(///<?|//|/\*\*|\*) {OPENING} ")


def main(root):
    faults, files = [], 0
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in SUFFIXES:
                continue
            files += 1
            name = path.relative_to(root)
            for number, line in enumerate(path.read_text().splitlines(), 1):
                if len(line) > COLUMNS:
                    faults.append(f"{name}:{number}: {len(line)} columns")
                if RIDDLE.match(line):
                    faults.append(f"{name}:{number}: {line.strip()}")
    if files == 0:
        faults.append(f"no files below {root}")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
