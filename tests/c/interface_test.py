# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""winding.h still has all that version 1 of the interface had, where programs look for it.

Usage: interface_test.py <winding.h> <compiler of C> [--write]. interface_1.txt holds what programs
of version 1 rely on: functions and members of structs with their types, constants, and the places
of members on machines with addresses of 64 bits. What is new may be added; --write adds it once it
is released.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
KEPT = HERE / "interface_1.txt"
sys.path.insert(0, str(HERE.parents[1] / "python"))
from header import structs_in, text_of  # noqa: E402


def functions_in(text):
    for prototype in re.findall(r"WINDING_API\s+([^;{}]+);", text):
        yield "function " + " ".join(prototype.split())


def constants_in(text):
    for name, value in re.findall(r"\b(WINDING_\w+)\s*=\s*(-?\d+)", text):
        yield f"constant {name} {value}"
    for name, value in re.findall(r"^#define (WINDING_\w+) (-?\d+)$", text, re.MULTILINE):
        yield f"constant {name} {value}"


def places_of(structs, header, compiler):
    """Lines with the places and sizes of members; and sizes of structs that tell none
    themselves."""
    lines = []
    for name, members in structs:
        for member, declaration in members.items():
            lines.append(f'printf("member {name}.{member} %zu %zu {declaration}\\n", '
                         f"offsetof({name}, {member}), sizeof((({name}*)0)->{member}));")
        if "size" not in members:
            lines.append(f'printf("struct {name} %zu\\n", sizeof({name}));')
    code = "\n".join(["#include <winding.h>", "#include <stddef.h>", "#include <stdio.h>",
                      "int main(void) {", *lines, "return 0; }"])
    with tempfile.TemporaryDirectory() as folder:
        source, program = pathlib.Path(folder) / "places.c", pathlib.Path(folder) / "places"
        source.write_text(code, encoding="utf-8")
        subprocess.run([compiler, "-std=c99", f"-I{header.parent}", source, "-o", program],
                       check=True)
        found = subprocess.run([program], check=True, capture_output=True, text=True)
    return found.stdout.splitlines()


def end_of(lines, struct):
    """Where the members of a struct end."""
    return max((int(place) + int(size) for place, size in (
        line.split()[2:4] for line in lines if line.startswith(f"member {struct}."))), default=0)


def faults_of(found, kept):
    for line in sorted(set(kept) - set(found)):
        yield f"{line}: it is no more, or is another"
    for line in sorted(set(found) - set(kept)):
        kind, name, *numbers = line.split()
        struct = name.split(".")[0]
        if kind == "member" and int(numbers[0]) < end_of(kept, struct):
            yield f"{line}: new members stand behind those that programs know"


def main(header, compiler, *options):
    if sys.maxsize < 2**32:
        return 77
    header = pathlib.Path(header)
    text = text_of(header)
    structs = list(structs_in(text))
    found = [*functions_in(text), *constants_in(text), *places_of(structs, header, compiler)]
    if options == ("--write",):
        KEPT.write_text("\n".join(found) + "\n", encoding="utf-8")
    kept = KEPT.read_text(encoding="utf-8").splitlines()
    faults = list(faults_of(found, kept))
    print(f"{len(kept)} things are promised, {len(found)} are there")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults or len(kept) < 300 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
