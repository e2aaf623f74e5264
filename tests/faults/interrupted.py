# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are ended by signals at random moments."""

import signal
import time

import program as winding
from program import require

# Pairs of a name and the signals that are sent, one after the other.
ENDINGS = {
    "SIGINT": [signal.SIGINT],
    "SIGTERM": [signal.SIGTERM],
    "two SIGINTs": [signal.SIGINT, signal.SIGINT],
    "SIGKILL": [signal.SIGKILL],
}


def begins_before_main(status, signals):
    """Whether a signal has ended the program while it was being loaded, before it does anything."""
    return status == -signals[0]


def one(program, folder, job, old, new, moments, ending, chance):
    signals = ENDINGS[ending]
    before = old if chance.random() < 0.7 else {}
    job.put(folder, before)
    process = winding.start(program, job, folder)
    time.sleep(chance.uniform(*moments))
    for number in signals:
        process.send_signal(number)
        time.sleep(chance.choice((0, 0.0005, 0.005)))
    status, errors = winding.finish(process)

    is_new = winding.require_whole(job, folder, before, new)
    left = winding.part_files(folder)
    if status == winding.DONE:
        require(is_new, "status 0 without the result")
        require(not left, "status 0 leaves", left)
        return "done before"
    if signal.SIGKILL in signals:
        require(status == -signal.SIGKILL, "SIGKILL gives status", status, errors)
        return "killed"
    require(not left, "a signal that is handled leaves", left)
    if begins_before_main(status, signals):
        require(job.files(folder) == before, "a program that was not yet loaded has written")
        return "ended while loading"
    require(status == winding.INTERRUPTED, "status", status, errors)
    require("interrupted" in errors, "no word of the interruption:", errors)
    # A second signal may come when the result already has its name.
    require(not is_new or len(signals) > 1, "an interrupted run has replaced the old result")
    return "interrupted"


def moments_of(program, folder, job):
    """The first and the last moment for a signal: most of the loading of the program is left
    out."""
    start = time.monotonic()
    winding.run(program, winding.Job("", "--version"), folder)
    loaded = time.monotonic()
    winding.written_by(program, job, folder)
    return 0.8 * (loaded - start), 1.1 * (time.monotonic() - loaded)


def check(program, folder, chance, runs, **_):
    jobs = winding.jobs(size=80)
    prepared = [(job, *winding.old_and_new(program, job, folder),
                 moments_of(program, folder, job)) for job in jobs]
    brief = winding.jobs(size=4)[0]
    outcomes = {}
    for number in range(runs):
        job, old, new, moments = chance.choice(prepared)
        ending = chance.choice(list(ENDINGS))
        try:
            outcome = one(program, folder, job, old, new, moments, ending, chance)
            if winding.part_files(folder):
                # Any run clears the folder that it writes into; blocks have a folder of their own.
                follower = job if job.output.endswith(".vtm") else brief
                status, errors = winding.run(program, follower, folder)
                require(status == winding.DONE, "the next run ends with", status, errors)
                require(not winding.part_files(folder), "the next run leaves",
                        winding.part_files(folder))
                outcome += ", part file cleared by the next run"
                follower.put(folder, {})
        except winding.Fault as fault:
            raise winding.Fault(f"run {number}, {ending}, {' '.join(job.words)}: {fault}") from None
        key = f"{ending}: {outcome}"
        outcomes[key] = outcomes.get(key, 0) + 1
    return [f"{count:6}  {outcome}" for outcome, count in sorted(outcomes.items())]
