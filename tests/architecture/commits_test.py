# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Commits say what they do as CONTRIBUTING.md asks: `area: imperative`, at most 72 characters.

Usage: commits_test.py <root of the repository>. Looks at all commits behind the last one of the
former style, merges excepted. Prints one line for each fault, and fails if there is any. Exits with
77 where there is no history to look at, as in an archive of the sources.
"""

import re
import subprocess
import sys

LAST_OF_FORMER_STYLE = "9037f3690781edd2659ef048c90827dc4853eea5"
LONGEST = 72
SUBJECT = re.compile(r"[a-z][a-z0-9 /,._-]*: [a-z][\w'-]*( .*)?")
SKIPPED = 77


def faults_of(subject):
    """What is wrong with a subject, one line each."""
    if len(subject) > LONGEST:
        yield f"{len(subject)} characters, not {LONGEST} or fewer"
    if not SUBJECT.fullmatch(subject):
        yield "not of the form `area: imperative`"
    elif re.search(r"(ed|ing)$", subject.split(": ", 1)[1].split()[0]):
        yield "begins with no imperative"
    if ";" in subject or subject.endswith("."):
        yield "several topics, or a full stop"


def main(root):
    run = subprocess.run(
        ["git", "-C", root, "log", "--no-merges", "--format=%h %s",
         f"{LAST_OF_FORMER_STYLE}..HEAD"],
        capture_output=True, text=True)
    if run.returncode != 0:
        print("no history:", run.stderr.strip())
        return SKIPPED
    assert list(faults_of("Something was done; and more."))
    assert not list(faults_of("core: sort edges"))
    faults = [f"{line}: {fault}" for line in run.stdout.splitlines()
              for fault in faults_of(line.split(" ", 1)[1])]
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
