# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pages hang together: links, anchors, pictures and the files that they name exist.

Usage: pages_test.py <root of the repository>. Prints one line for each fault, and fails if there is
any.
"""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from pages import pages_of  # noqa: E402

LONGEST_LINE = 100
MOST_WORDS_OF_README = 900
FILE_NAME = re.compile(r"[\w.\-/]*\w\.(?:h|cxx|py|sh|md|txt|xml|json)")
SKIPPED_FOLDERS = {".git", "build", "out"}


def faults_of_links(page, anchors):
    for link in page.links():
        if re.match(r"[a-z]+:", link.target):
            continue
        path, _, anchor = link.target.partition("#")
        target = (page.path.parent / path).resolve() if path else page.path
        if not target.exists():
            yield f"{link.where}: {link.target} does not exist"
        elif anchor and anchor not in anchors.get(target, ()):
            yield f"{link.where}: {link.target} has no such heading"
        if link.is_picture and not link.text:
            yield f"{link.where}: the picture has no text for those who do not see it"


def faults_of_file_names(page, files):
    for where, code in page.code_spans():
        for name in code.split():
            if FILE_NAME.fullmatch(name) and not is_known(name, files):
                yield f"{where}: there is no {name}"


def is_known(name, files):
    return any(file == name or file.endswith("/" + name) for file in files)


def faults_of_lines(page):
    for number, line in enumerate(page.text.splitlines(), 1):
        is_free = line.startswith(("|", "![")) or "](" in line and " " not in line
        if len(line) > LONGEST_LINE and not is_free:
            yield f"{page.name}:{number}: {len(line)} columns"
        if re.search("@[A-Z]+@", line):
            yield f"{page.name}:{number}: a figure is not filled in"


def main(root):
    root = pathlib.Path(root).resolve()
    pages = pages_of(root)
    anchors = {page.path: page.anchors() for page in pages}
    files = {path.relative_to(root).as_posix() for path in root.rglob("*")
             if path.is_file() and path.relative_to(root).parts[0] not in SKIPPED_FOLDERS}

    faults = []
    for page in pages:
        faults += faults_of_links(page, anchors)
        faults += faults_of_file_names(page, files)
        faults += faults_of_lines(page)
    shown = {(page.path.parent / link.target).resolve() for page in pages for link in page.links()}
    for picture in sorted((root / "data" / "pictures").iterdir()):
        if picture not in shown:
            faults.append(f"{picture.name}: no page shows this picture")
    words = len((root / "README.md").read_text(encoding="utf-8").split())
    if words > MOST_WORDS_OF_README:
        faults.append(f"README.md has {words} words; move some to docs/")

    for fault in faults:
        print("FAULT", fault)
    print(f"{len(pages)} pages, {sum(len(page.links()) for page in pages)} links, README {words} "
          "words")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
