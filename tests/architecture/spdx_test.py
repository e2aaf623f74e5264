# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every source says whose it is and under which licence, in the words of SPDX.

Usage: spdx_test.py <root of the repository>. Prints one line for each source that does not.
"""

import pathlib
import re
import subprocess
import sys

SOURCE = re.compile(r"(\.(h|cxx|c|h\.in|def|inc|py|cmake|sh|module|plugin|cmake\.in|py\.in|map)|"
                    r"/CMakeLists\.txt|/dev)$")
LINES = ("SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors",
         "SPDX-License-Identifier: BSD-3-Clause")


def main(root):
    listed = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True)
    if listed.returncode != 0:
        return 77  # no repository, as in an archive of the sources
    sources = [name for name in listed.stdout.splitlines()
               if SOURCE.search("/" + name) and (root / name).is_file()]
    without = []
    for name in sources:
        head = "\n".join((root / name).read_text(encoding="utf-8").splitlines()[:3])
        if not all(line in head for line in LINES):
            without.append(name)
    print(f"{len(sources)} sources")
    for name in without:
        print("FAULT", name, "does not begin with the lines of SPDX")
    return 1 if without or len(sources) < 1000 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
