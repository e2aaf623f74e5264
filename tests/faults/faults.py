# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the program does when the machine and other programs fail it: nothing final is ever partial,
no old file is lost, no hidden file stays, and every status is one of 0, 1, 2, 3 and 130.

Usage: faults.py <the program winding> <folder of the libraries> [kind…] [--runs N] [--seed S]

Kinds: interrupted, writers, disks, vanishing, allocations; all of them by default. --runs is the
number of interrupted runs (1000); the other kinds take numbers that go with it, and from 1000 on
every allocation of five small runs fails once.
"""

import argparse
import pathlib
import random
import sys
import tempfile
import time

import allocations
import disks
import interrupted
import program as winding
import vanishing
import writers

KINDS = {
    "interrupted": (interrupted, lambda runs: runs),
    "writers": (writers, lambda runs: max(2, runs // 20)),
    "disks": (disks, lambda runs: max(3, min(40, runs // 10))),
    "vanishing": (vanishing, lambda runs: runs),
    "allocations": (allocations, lambda runs: 5 * runs if runs < 1000 else sys.maxsize),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, usage=argparse.SUPPRESS,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda name: str(pathlib.Path(name).resolve()))
    parser.add_argument("libraries", type=pathlib.Path)
    parser.add_argument("kinds", nargs="*")
    parser.add_argument("--runs", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(1 << 32))
    options = parser.parse_intermixed_args()
    libraries = {name: str((options.libraries / f"lib{name}.so").resolve())
                 for name in ("allocation_faults", "file_faults")}
    failures = 0
    for kind in options.kinds or KINDS:
        module, runs = KINDS[kind]
        print(f"{kind}, seed {options.seed}", flush=True)
        start = time.monotonic()
        with tempfile.TemporaryDirectory(prefix="winding-faults-") as folder:
            try:
                lines = module.check(program=options.program, folder=pathlib.Path(folder),
                                     chance=random.Random(options.seed), libraries=libraries,
                                     runs=runs(options.runs))
            except winding.Fault as fault:
                lines = [f"FAULT {fault}"]
                failures += 1
        print("\n".join(lines))
        print(f"{time.monotonic() - start:.0f} s", flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
