# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The words that users see: tests/messages/words.txt, and the inputs there that lead to them."""

import pathlib

FOLDER = pathlib.Path(__file__).resolve().parents[1] / "messages"


def messages_of(front_end):
    """The lines of a front end ("C++", "ParaView", "program" or "Python"), by what they are
    about."""
    lines, subject = {}, None
    for line in (FOLDER / "words.txt").read_text().splitlines():
        start = f"  {front_end}: "
        if line.startswith(start):
            lines[subject] = line[len(start):]
        elif line and line[0] not in " #":
            subject = line
    return lines
