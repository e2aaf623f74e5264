"""Doxygen makes the API reference without a warning; of the public headers everything is documented.

Usage: reference_test.py <root of the repository>. Skips, with exit status 77, where there is no Doxygen.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77


def main(root):
    if not shutil.which("doxygen"):
        print("skipped: there is no doxygen; ./dev docs installs it")
        return SKIPPED
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        for name in ("Doxyfile", "Doxyfile.core"):
            text = (pathlib.Path(root) / "docs" / name).read_text(encoding="utf-8")
            run = subprocess.run(["doxygen", "-"], cwd=root, text=True, capture_output=True,
                                 input=f"{text}\nOUTPUT_DIRECTORY = {folder}\n")
            print(f"{name}: exit status {run.returncode}\n{run.stdout}{run.stderr}")
            page = pathlib.Path(folder) / ("core" if "core" in name else "module") / "index.html"
            failures += run.returncode != 0 or bool(run.stderr.strip()) or not page.is_file()
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
