# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the repository as the tests see them: prose, links, headings and blocks of code."""

import pathlib
import re
from dataclasses import dataclass

FENCE = re.compile(r"^```(\S*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ +(.+?) *$", re.MULTILINE)
CODE = re.compile(r"`([^`\n]+)`")


@dataclass
class Block:
    """A fenced block of code."""

    where: str  # file:line of its first line
    language: str
    code: str


@dataclass
class Link:
    where: str
    is_picture: bool
    text: str
    target: str


class Page:
    def __init__(self, root, path):
        self.path = path
        self.name = str(path.relative_to(root))
        self.text = path.read_text(encoding="utf-8")
        # Blocks become empty lines, so that lines keep their numbers.
        self.prose = FENCE.sub(lambda block: "\n" * block[0].count("\n"), self.text)

    def where(self, text, offset):
        return f"{self.name}:{text.count(chr(10), 0, offset) + 1}"

    def blocks(self, language):
        return [Block(self.where(self.text, block.start(2)), language, block[2])
                for block in FENCE.finditer(self.text) if block[1] == language]

    def links(self):
        return [Link(self.where(self.prose, link.start()), bool(link[1]), link[2], link[3])
                for link in LINK.finditer(self.prose)]

    def anchors(self):
        """What links to its headings are called: as GitHub makes them."""
        return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
                for heading in HEADING.findall(self.prose)}

    def code_spans(self):
        """Code within sentences, as pairs of a place and the code."""
        return [(self.where(self.prose, span.start()), span[1])
                for span in CODE.finditer(self.prose)]


def pages_of(root):
    """All pages that people read. Those of other folders belong to who builds there."""
    root = pathlib.Path(root).resolve()
    found = [*root.glob("*.md"), *root.glob("docs/*.md"), *root.glob("data/**/*.md")]
    return [Page(root, path) for path in sorted(found)]
