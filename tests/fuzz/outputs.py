# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Looks into the files that the program writes for numbers that are not finite."""

import math
import re
import struct


def unpacked_lz4(packed, size):
    """The bytes of a block of LZ4."""
    out, at = bytearray(), 0

    def length(first):
        nonlocal at
        total = first
        while first == 15 or (total >= 15 and packed[at - 1] == 255):
            total += packed[at]
            at += 1
            first = 0
        return total

    while at < len(packed) and len(out) < size:
        token = packed[at]
        at += 1
        literals = length(token >> 4)
        out += packed[at : at + literals]
        at += literals
        if at >= len(packed):
            break
        offset = packed[at] | packed[at + 1] << 8
        at += 2
        for _ in range(length(token & 15) + 4):
            out.append(out[-offset])
    return bytes(out)


def image_numbers(content):
    """The numbers of all arrays of real numbers in an image that the program has written."""
    mark = content.index(b'<AppendedData encoding="raw">')
    start = content.index(b"_", mark) + 1
    for tag in re.findall(rb"<DataArray [^>]*>", content[:mark]):
        kind = re.search(rb'type="Float(\d+)"', tag)
        if not kind:
            continue
        at = start + int(re.search(rb'offset="(\d+)"', tag)[1])
        blocks, size, last = struct.unpack_from("<3Q", content, at)
        packed = struct.unpack_from(f"<{blocks}Q", content, at + 24)
        at += 24 + 8 * blocks
        for number, length in enumerate(packed):
            whole = last if last and number + 1 == blocks else size
            data = unpacked_lz4(content[at : at + length], whole)
            code = "f" if kind[1] == b"32" else "d"
            yield from struct.unpack(f"<{len(data) // struct.calcsize(code)}{code}", data)
            at += length


def table_numbers(content):
    """The results in a table, for queries that are finite."""
    lines = content.decode(errors="replace").splitlines()
    head = lines[0].split(",")
    if '"' in content.decode(errors="replace") or "WindingNumber" not in head:
        return
    first = head.index("WindingNumber")
    for line in lines[1:]:
        fields = line.split(",")
        try:
            queries = [float(field) for field in fields[:first]]
            results = [float(field) for field in fields[first:]]
        except ValueError:
            continue
        if all(map(math.isfinite, queries)):
            yield from results


def flaw_in(path):
    """The first number of an output that is not finite, in words; None if there is none."""
    content = path.read_bytes()
    if path.suffix == ".vti":
        numbers = image_numbers(content)
    elif path.suffix == ".csv":
        numbers = table_numbers(content)
    elif path.suffix == ".obj":
        numbers = (
            float(word)
            for line in content.splitlines()
            if line.startswith(b"v")
            for word in line.split()[1:]
        )
    elif path.suffix == ".stl" and len(content) >= 84:
        count = struct.unpack_from("<I", content, 80)[0]
        numbers = (
            value
            for i in range(count)
            for value in struct.unpack_from("<12f", content, 84 + 50 * i)
        )
    else:
        return None
    bad = [number for number in numbers if not math.isfinite(number)]
    return f"{bad[0]} in {path.name}" if bad else None
