# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Several runs that write the same file at the same time."""

import signal
import time

import program as winding
from program import require

WRITERS = 6


def check(program, folder, chance, runs, **_):
    """Each writer has a grid of its own, so that the file shows whose it is."""
    writers = [winding.Job("out.vti", "field", "in.off", "-o", "out.vti", "--quiet",
                           "--resolution", 20 + number) for number in range(WRITERS)]
    winding.put_inputs(folder)
    results = [winding.written_by(program, job, folder)["out.vti"] for job in writers]
    looks, victims, winners = 0, 0, set()
    for number in range(runs):
        if number % 2 == 0:
            (folder / "out.vti").unlink(missing_ok=True)
        processes = [winding.start(program, job, folder) for job in writers]
        victim = chance.randrange(WRITERS) if chance.random() < 0.5 else None
        end = time.monotonic() + chance.uniform(0, 0.3)
        while any(process.poll() is None for process in processes):
            if victim is not None and time.monotonic() > end:
                processes[victim].send_signal(signal.SIGKILL)
                victims += 1
                end = float("inf")
            if (folder / "out.vti").exists():
                require((folder / "out.vti").read_bytes() in results, "the file is partial")
                looks += 1
        for index, process in enumerate(processes):
            status, errors = winding.finish(process)
            allowed = (winding.DONE, -signal.SIGKILL) if index == victim else (winding.DONE,)
            require(status in allowed, "writer", index, "ends with", status, errors)
        final = (folder / "out.vti").read_bytes()
        require(final in results, "the file is partial at the end")
        winners.add(results.index(final))
        status, errors = winding.run(program, writers[0], folder)
        require(status == winding.DONE, "the next run ends with", status, errors)
        require(not winding.part_files(folder), "left:", winding.part_files(folder))
    return [f"{runs} times {WRITERS} writers, {victims} of them killed; {looks} looks at the file "
            f"found it whole; {len(winners)} of them came last at least once"]
