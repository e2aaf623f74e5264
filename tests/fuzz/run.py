# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs fuzzers, as many at a time as there are processors, and prints a line on each.

Usage: run.py <folder of the fuzzers> <folder for corpora> <folder for failing cases> <length>
[target…]

The length is a number of seconds for each fuzzer, or a number of runs as 300x. Fuzzers of files
take five times as many runs, for these are shorter. With a seed in WINDING_FUZZ_SEED, runs by
number on the same corpora find the same on every machine.

A corpus is made by seeds.py, grows with every run, and is begun with the regressions of the target
in regressions/<target>, which regressions/README.md tells about. Fails if any fuzzer does.
"""

import concurrent.futures
import os
import pathlib
import random
import re
import subprocess
import sys

sys.dont_write_bytecode = True
import seeds  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
# Targets whose cases are choices (Choices.h) need nothing but seeds; all others have files.
FILES_OF = {
    "obj": [".obj"],
    "off": [".off"],
    "xyz": [".xyz", ".pwn"],
    "csv": [".csv"],
    "table": [".csv", ".tsv"],
    "ply": [".ply"],
    "stl": [".stl"],
    "vtk": [".vtk"],
    "vtp": [".vtp"],
    "vtu": [".vtu"],
    "gltf": [".gltf"],
    "glb": [".glb"],
    "3mf": [".3mf"],
    "gz": [".xyz.gz"],
    "mha": [".mha"],
    "nrrd": [".nrrd"],
    "nii": [".nii"],
    "vti": [".vti"],
    "vtr": [".vtr"],
    "vts": [".vts"],
    "options": [],
}
ENVIRONMENT = {
    **os.environ,
    # Files may promise more memory than there is, which the program is to notice by itself.
    "ASAN_OPTIONS": "allocator_may_return_null=1:max_allocation_size_mb=1024:detect_leaks=1",
    "LSAN_OPTIONS": (
        f"suppressions={HERE.parent / 'sanitizers' / 'leaks.supp'}:print_suppressions=0"),
    "UBSAN_OPTIONS": "print_stacktrace=1",
}


def fill(corpus, target):
    corpus.mkdir(parents=True, exist_ok=True)
    if target not in FILES_OF:
        for seed in range(64):
            (corpus / f"seed{seed}").write_bytes(random.Random(seed).randbytes(8))
    for suffix, name, content in seeds.all_files():
        if suffix in FILES_OF.get(target, ()):
            (corpus / f"{name}{suffix}").write_bytes(content)
    if target == "options":
        for number, line in enumerate(seeds.COMMANDS):
            (corpus / f"line{number}").write_text(line.replace(" ", "\n"))


def figure(log, name):
    found = re.search(rf"stat::{name}:\s+(\d+)", log)
    return int(found[1]) if found else 0


def limits(length, target):
    """The options that end a fuzzer. Runs by number may be on a busy machine."""
    if not length.endswith("x"):
        return f"-max_total_time={length}", "-timeout=10"
    return f"-runs={int(length[:-1]) * (5 if FILES_OF.get(target) else 1)}", "-timeout=120"


def fuzz(programs, corpora, failures, length, target):
    corpus, kept = corpora / target, failures / target
    fill(corpus, target)
    kept.mkdir(parents=True, exist_ok=True)
    regressions = HERE / "regressions" / target
    folders = [corpus] + ([regressions] if regressions.is_dir() else [])
    largest = 4096 if target in FILES_OF else 512
    seed = os.environ.get("WINDING_FUZZ_SEED")
    run = subprocess.run(
        [
            programs / f"fuzz_{target}",
            *limits(length, target),
            "-rss_limit_mb=3000",
            "-len_control=0",
            f"-max_len={largest}",
            "-print_final_stats=1",
            "-close_fd_mask=1",
            "-verbosity=1",
            f"-artifact_prefix={kept}/",
            *([f"-seed={seed}"] if seed else []),
            *folders,
        ],
        env=ENVIRONMENT,
        capture_output=True,
        stdin=subprocess.DEVNULL,
        check=False,
    )
    log = run.stderr.decode(errors="replace")
    (kept / "log.txt").write_text(log)
    line = (
        f"{target:15} {figure(log, 'number_of_executed_units'):9} runs, "
        f"{figure(log, 'average_exec_per_sec'):6} a second, {figure(log, 'peak_rss_mb'):5} MB, "
        f"{len(list(corpus.iterdir())):6} cases kept"
    )
    if run.returncode != 0:
        words = [
            text
            for text in log.splitlines()
            if re.search(r"ERROR|runtime error|SUMMARY|gives|Test unit", text)
        ]
        line += f"; FAILED, see {kept}\n  " + "\n  ".join(words[:6] or log.splitlines()[-3:])
    return run.returncode == 0, line


def main():
    programs, corpora, failures = (pathlib.Path(folder) for folder in sys.argv[1:4])
    length = sys.argv[4]
    found = sorted(path.name[5:] for path in programs.glob("fuzz_*"))
    targets = sys.argv[5:] or found
    unknown = set(targets) - set(found)
    if unknown or not targets:
        sys.exit(f"there is no target {' '.join(sorted(unknown))}; there are: {' '.join(found)}")
    good = True
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for fine, line in pool.map(
            lambda target: fuzz(programs, corpora, failures, length, target), targets
        ):
            print(line, flush=True)
            good = good and fine
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
