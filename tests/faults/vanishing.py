# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that vanish, or are cut, between one opening of them and the next."""

import program as winding
from program import require

MOST_OPENINGS = 12


def formats(program, folder):
    """The input in formats that are read in different ways."""
    winding.put_inputs(folder)
    for suffix in ("vtp", "ply", "stl", "obj"):
        job = winding.Job(f"in.{suffix}", "surface", "in.off", "-o", f"in.{suffix}", "--resolution",
                          6)
        status, errors = winding.run(program, job, folder)
        require(status == winding.DONE, errors)
    return ["in.off", "in.vtp", "in.ply", "in.stl", "in.obj", "queries.csv"]


def check(program, folder, libraries, **_):
    counts = {}
    for name in formats(program, folder):
        contents = (folder / name).read_bytes()
        words = (("probe", "in.off", name) if name.endswith(".csv")
                 else ("probe", name, "queries.csv"))
        job = winding.Job("out.csv", *words, "-o", "out.csv", "--quiet")
        for action in ("unlink", "truncate"):
            for opening in range(1, MOST_OPENINGS):
                (folder / name).write_bytes(contents)
                job.put(folder, {})
                status, errors = winding.run(program, job, folder, environment={
                    "LD_PRELOAD": libraries["file_faults"], "FAULT_FILE": name,
                    "FAULT_OPENING": str(opening), "FAULT_ACTION": action})
                where = f"{action} at opening {opening} of {name}:"
                is_disturbed = not (folder / name).exists() or (
                    (folder / name).read_bytes() != contents)
                require(status in winding.STATUSES, where, "status", status, errors)
                require(not winding.part_files(folder), where, "left", winding.part_files(folder))
                if status == winding.DONE:
                    require(job.files(folder), where, "status 0 without the result")
                else:
                    winding.require_refusal(status, errors)
                    require(not job.files(folder), where, "refused, with a result")
                key = f"{action}: status {status}" if is_disturbed else "not opened so often"
                counts[key] = counts.get(key, 0) + 1
                if not is_disturbed:
                    break
            else:
                raise winding.Fault(f"{name} is opened {MOST_OPENINGS} times and more")
        (folder / name).write_bytes(contents)
    require(any(key.startswith("unlink: status 2") for key in counts), "nothing has vanished",
            counts)
    return [f"{count:6}  {key}" for key, count in sorted(counts.items())]
