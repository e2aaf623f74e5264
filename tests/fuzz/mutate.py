# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program on mutated files of every format, and fails where it does anything but its
work or a refusal.

Usage: mutate.py <program> [count] [first seed] [folder for failing inputs]

A mutant's seed tells its file, its mutations and its command. A failure is a status other than 0,
1, 2, 3 and 130, more than 10 seconds of the processor, something on standard error that is not the
program's own line, a number that is not finite in an output with status 0, or a file left behind.
"""

import concurrent.futures
import json
import math
import os
import pathlib
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
import outputs  # noqa: E402
import seeds  # noqa: E402

STATUSES = {0, 1, 2, 3, 130}
SECONDS = 10  # of processor time
MOST_SECONDS = 300  # of waiting, on machines that are busy with other things
BYTES = 6 << 30  # of address space
LIMITS = ["prlimit", f"--cpu={SECONDS}", f"--as={BYTES}"]
HARD_WORDS = (
    b"0 1 -1 2 3 4 8 255 256 65536 2147483647 -2147483648 4294967296 9223372036854775807 "
    b"-9223372036854775808 1e9 1e39 1e160 1e300 -1e308 1e-320 1e400 nan inf -inf 0x10 1.5 +1 1,5 "
    b'" x ascii binary list int float vtktypeint64 end_header 42 METADATA FIELD appended'
).split() + [b"", b"\r"]
HARD_BYTES = [
    struct.pack(code, value)
    for code, value in [
        ("<i", -1),
        ("<i", 2**31 - 1),
        (">i", 2**31 - 1),
        ("<q", -1),
        ("<q", 2**62),
        ("<f", math.inf),
        ("<f", math.nan),
        ("<d", math.nan),
        ("<d", 1e300),
        (">f", math.nan),
        (">d", 1e300),
        ("<I", 5),
        ("B", 0),
        ("B", 255),
    ]
]
WORD = re.compile(rb'[^\s"<>,]+')
LINE = re.compile(rb"[^\n]*\n?")


MILD_WORDS = b"0 1 2 3 0.25 -0.5 -3 7.5 1e-3 1e5 1e-30 1e30 nan".split()
NUMBER = re.compile(rb"(?<=[\s,>])-?\d[^\s\"<>,]*(?=[\s,<])")


def with_other_numbers(content, chance):
    """The content with some of its numbers replaced, so that mostly it can still be read."""
    for _ in range(chance.choice((1, 2, 5))):
        places = [m.span() for m in NUMBER.finditer(content)]
        if places:
            a, b = chance.choice(places[len(places) // 4 :])
            content = content[:a] + chance.choice(MILD_WORDS) + content[b:]
    return content


def mutated(content, chance):
    """The content with some changes."""
    if chance.random() < 0.4:
        return with_other_numbers(content, chance)
    for _ in range(chance.choice((1, 1, 1, 2, 3, 6))):
        pieces = [
            m.span()
            for m in (LINE if chance.random() < 0.25 else WORD).finditer(content)
            if m.end() > m.start()
        ]
        if not pieces:
            return content
        (a, b), (c, d) = chance.choice(pieces), chance.choice(pieces)
        kind = chance.randrange(10)
        if kind < 4:
            content = content[:a] + chance.choice(HARD_WORDS) + content[b:]
        elif kind == 4:
            content = content[:a] + content[b:]
        elif kind == 5:
            content = content[:a] + content[c:d] + content[a:]
        elif kind == 6:
            content = content[:a] + content[c:d] + content[b:]
        elif kind == 7:
            content = content[: chance.randrange(len(content) + 1)]
        else:
            place, hard = chance.randrange(len(content)), chance.choice(HARD_BYTES)
            flipped = bytes([content[place] ^ (1 << chance.randrange(8))])
            content = (
                content[:place]
                + (flipped if kind == 8 else hard)
                + content[place + (1 if kind == 8 else len(hard)) :]
            )
    return content


def is_image(name):
    """Whether a file holds an image or a grid, which are for queries alone."""
    return name.endswith((".mha", ".nrrd", ".nii", ".vti", ".vtr", ".vts"))


def command_for(chance, name, other):
    """The arguments that follow the program, and the outputs that they name."""
    grid = chance.choice(
        (["--resolution", str(chance.choice((1, 2, 4, 7)))], ["--dims", "3", "1", "4"])
    )
    method = chance.choice(
        ([], [], ["--method", chance.choice(("rows", "hierarchical", "direct", "parity"))])
    )
    cloud = chance.choice(
        (
            [],
            ["--estimate-normals"],
            ["--estimate-normals", "--normal-estimation", "consistent"],
            ["--estimate-normals", "--toward", "up"],
            ["--columns", "x=1", "y=2", "z=3"],
            ["--points"],
            ["--regularization", "1"],
            ["--areas", "array"],
            ["--tolerance", "1e-6"],
        )
    )
    command = chance.choice(
        (
            "field",
            "field",
            "surface",
            "sharp",
            "boolean",
            "voxels",
            "labels",
            "probe",
            "probe",
            "normals",
            "check",
        )
    )
    if is_image(name) and chance.random() < 0.5:
        output = "out" + chance.choice((".mha", ".nrrd", ".nii", ".vti"))
        command = chance.choice(("field", "labels"))
        return [command, other, "-o", output, "--like", name, *method, *cloud], [output]
    if is_image(name):
        command = "probe"
    if command == "field":
        extra = chance.choice(
            (
                [],
                ["--distance"],
                ["--coverage", "fraction"],
                ["--inside-only"],
                ["--double"],
                ["--verify", "20", "--json"],
                ["--pieces", "2"],
                ["--cells"],
            )
        )
        return ["field", name, "-o", "out.vti", *grid, *method, *cloud, *extra], ["out.vti"]
    if command in ("surface", "voxels"):
        output = "out" + chance.choice((".obj", ".stl", ".ply", ".vtp"))
        more = chance.choice(([], ["--offset", "0.2"], ["--offset=-0.1"], ["--fill-cavities"],
                              ["--fill-cavities", "--gap-width", "0.2"],
                              ["--shell", "0.3", "--shell-side", "centered"],
                              ["--transfer-attributes"], ["--nearest-cells"],
                              ["--transfer-attributes", "--nearest-cells"]))
        extra = more if command == "surface" else []
        return [command, name, "-o", output, *grid, *method, *cloud, *extra], [output]
    if command == "sharp":
        output = "out" + chance.choice((".obj", ".stl", ".ply", ".vtp"))
        extra = chance.choice(([], ["--triangles"], ["--close-border"], ["--fidelity", "20"],
                               ["--distance"] if output == "out.vtp" else []))
        sharp = ["--features", chance.choice(("sharp", "sharp", "voxels")), *extra]
        return ["surface", name, "-o", output, *grid, *method, *cloud, *sharp], [output]
    if command == "boolean":
        output = "out" + chance.choice((".obj", ".stl", ".ply", ".vtp"))
        operation = chance.choice(("union", "intersection", "difference", "xor"))
        extra = chance.choice(([], ["--features", "sharp"], ["--rules", "absolute,signed"],
                               ["--transfer-attributes", "--nearest-cells"],
                               ["--thresholds", "0.3,1.5"], ["--verify", "20", "--json"]))
        pair = chance.choice(([name, other], [other, name], [name, name]))
        if chance.random() < 0.2:
            output, extra = "out" + chance.choice((".vti", ".mha", ".nrrd", ".nii")), []
        return ["boolean", *pair, "-o", output, "--operation", operation, *grid, *method, *cloud,
                *extra], [output]
    if command == "labels":
        output = "out" + chance.choice((".vti", ".vti", ".vtp", ".stl"))
        extra = chance.choice(
            (
                [],
                ["--overlap", chance.choice(("last", "largest", "smallest"))],
                ["--count", "--cells"],
                ["--coverage", "fraction"],
                ["--coverage", "fraction", "--shares", "each"],
                ["--verify", "20"],
                ["--rule", "absolute", "--coverage", "any"],
                ["--json"],
            )
        )
        solids = chance.choice(([name], [name], [name, other], [other, name]))
        return ["labels", *solids, "-o", output, *grid, *method, *cloud, *extra], [output]
    if command == "probe":
        output = "out" + chance.choice((".csv", ".csv", ".vtp", ".vtu"))
        extra = chance.choice(([], ["--extract"], ["--distance"], ["--inside-out"],
                               ["--fraction"] if output.endswith((".vtp", ".vtu")) else []))
        pair = [name, other] if chance.random() < 0.5 and not is_image(name) else [other, name]
        return ["probe", *pair, "-o", output, *method, *cloud, *extra], [output]
    if command == "normals":
        output = "out" + chance.choice((".ply", ".xyz", ".pwn", ".csv", ".vtp", ".vtu"))
        extra = chance.choice(
            ([], ["--replace"], ["--normal-estimation", "consistent"], ["--json"],
             ["--toward", "up"], ["--toward", "0", "0", "-9"])
        )
        return ["normals", name, "-o", output, *extra], [output]
    extra = chance.choice(([], ["--fix-orientation", "-o", "out.ply"], ["--blocks", "out.vtm"]))
    return ["check", name, "--json", *extra], extra[-1:]


def flaw_in(run, folder, inputs, written, arguments):
    """What is wrong with a run, in words; None for nothing."""
    if run.returncode not in STATUSES:
        return f"status {run.returncode}"
    for line in run.stderr.splitlines():
        if line.strip() and not line.startswith(b"winding: "):
            return "standard error has " + line[:100].decode(errors="replace")
    left = {path.name for path in folder.iterdir()} - set(inputs)
    if run.returncode != 0:
        return f"leaves {sorted(left)} behind" if left else None
    for name in written:
        if name.endswith(".vtm"):
            continue
        if name not in left:
            return f"has written no {name}"
        flaw = outputs.flaw_in(folder / name)
        if flaw:
            return flaw
    if "--json" in arguments:

        def refuse(word):
            raise ValueError(word)

        try:
            report = json.loads(run.stdout, parse_constant=refuse)
        except ValueError as error:
            return f"the report has {error}"
        # Samples on the surface and near points are counted apart, and there may be no others;
        # no sample is near to a source without primitives.
        counted_apart = report.get("on_surface", 0) + report.get("beside_points", 0)
        has_others = counted_apart == 0 and report.get("input", {}).get("primitives", 0) > 0
        if has_others and any(
            report.get(name, 0) is None for name in ("max_error", "rms_error", "near_max_error")
        ):
            return "an error is null in the report"
    return None


class Mutants:
    def __init__(self, program, failures):
        self.program, self.failures = program, failures
        self.files = list(seeds.all_files())
        self.sources = [file for file in self.files if not is_image(file[0])]
        self.slowest, self.statuses = (0, None), {}

    def run(self, seed):
        """Runs one mutant. Returns what is wrong with it, or None."""
        chance = random.Random(seed)
        suffix, _, content = chance.choice(self.files)
        other_suffix, _, other_content = chance.choice(self.sources)
        name, other = "in" + suffix, "other" + other_suffix
        arguments, written = command_for(chance, name, other)
        folder = pathlib.Path(tempfile.mkdtemp(prefix="winding_mutant_"))
        try:
            (folder / name).write_bytes(mutated(content, chance))
            (folder / other).write_bytes(other_content)
            start = time.monotonic()
            try:
                run = subprocess.run(
                    [*LIMITS, self.program, *arguments, "--quiet"],
                    cwd=folder,
                    capture_output=True,
                    stdin=subprocess.DEVNULL,
                    timeout=MOST_SECONDS,
                )
                flaw = flaw_in(run, folder, (name, other), written, arguments)
                self.statuses[run.returncode] = self.statuses.get(run.returncode, 0) + 1
            except subprocess.TimeoutExpired:
                flaw = f"takes more than {MOST_SECONDS} s"
            self.slowest = max(self.slowest, (time.monotonic() - start, seed))
            if flaw:
                kept = self.failures / str(seed)
                shutil.rmtree(kept, ignore_errors=True)
                shutil.copytree(folder, kept)
                (kept / "command.txt").write_text(" ".join(arguments) + f" --quiet\n{flaw}\n")
                return f"seed {seed}: {flaw}: winding {' '.join(arguments)} (in {kept})"
            return None
        finally:
            shutil.rmtree(folder, ignore_errors=True)


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    failures = pathlib.Path(sys.argv[4] if len(sys.argv) > 4 else "out/mutants")
    if pathlib.Path("/dev/shm").is_dir():
        tempfile.tempdir = "/dev/shm"
    mutants, failed, start = Mutants(program, failures), 0, time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for flaw in pool.map(mutants.run, range(first, first + count)):
            if flaw:
                failed += 1
                print(flaw, flush=True)
    seconds = time.monotonic() - start
    statuses = ", ".join(
        f"{status}: {mutants.statuses[status]}" for status in sorted(mutants.statuses)
    )
    print(
        f"{count} mutants from seed {first} in {seconds:.0f} s, statuses {statuses}; "
        f"{failed} failures; "
        f"the slowest, seed {mutants.slowest[1]}, took {mutants.slowest[0]:.2f} s"
    )
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
