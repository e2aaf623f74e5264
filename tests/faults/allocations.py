# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Allocations that fail: one alone, or all from one on."""

import concurrent.futures
import os
import pathlib
import shutil

import program as winding
from program import require

MODES = ("FAULT_ALLOCATION", "FAULT_ALLOCATIONS_FROM")
BACKENDS = ("STDThread", "TBB", "Sequential")  # of vtkSMPTools; the last has one thread


def jobs(threads=1):
    """Small runs; with one thread, allocations come in one order."""
    common = ["--threads", threads, "--quiet"]
    return [winding.Job("out.vti", "field", "in.off", "-o", "out.vti", "--resolution", 4, *common),
            winding.Job("out.stl", "surface", "in.off", "-o", "out.stl", "--resolution", 4,
                        *common),
            winding.Job("out.stl", "surface", "in.off", "-o", "out.stl", "--resolution", 4,
                        "--features", "sharp", "--fidelity", 20, *common),
            winding.Job("out.stl", "surface", "in.off", "-o", "out.stl", "--resolution", 4,
                        "--shell", 0.5, "--fill-cavities", *common),
            winding.Job("out.ply", "surface", "in.off", "-o", "out.ply", "--resolution", 4,
                        "--transfer-attributes", "--nearest-cells", *common),
            winding.Job("out.stl", "boolean", "in.off", "in.off", "-o", "out.stl", "--resolution",
                        4, *common),
            winding.Job("out.vti", "labels", "in.off", "-o", "out.vti", "--resolution", 4,
                        "--overlap", "largest", *common),
            winding.Job("out.csv", "probe", "in.off", "queries.csv", "-o", "out.csv", *common),
            winding.Job("out.vtu", "probe", "in.off", "cells.vtk", "-o", "out.vtu", "--fraction",
                        *common),
            winding.Job("out.ply", "normals", "in.off", "-o", "out.ply", "--replace", *common)]


def one(program, folder, libraries, job, old, new, mode, number, backend):
    where = f"{backend or 'one thread'}: {mode}={number} {' '.join(job.words)}:"
    job.put(folder, old)
    try:
        status, errors = winding.run(program, job, folder, environment={
            "LD_PRELOAD": libraries["allocation_faults"], mode: str(number),
            **({"VTK_SMP_BACKEND_IN_USE": backend} if backend else {})})
        winding.require_status(status, errors)
        is_new = winding.require_whole(job, folder, old, new)
        require(not winding.part_files(folder), "left", winding.part_files(folder))
        if status == winding.DONE:
            require(is_new, "status 0 without the result")
        else:
            # A reader cannot tell whether memory is short or the file asks for too much of it.
            winding.require_refusal(status, errors, (winding.NO_MEMORY, winding.REFUSED))
    except winding.Fault as fault:
        raise winding.Fault(f"{where} {fault}") from None
    return f"{mode}: status {status}"


def allocations_of(program, folder, libraries, job):
    """The numbers of allocations, one for each way through the program that leads to one; and the
    number of all."""
    sites = folder / "sites"
    status, errors = winding.run(program, job, folder, environment={
        "LD_PRELOAD": libraries["allocation_faults"], "FAULT_SITES": str(sites)})
    require(status == winding.DONE, errors)
    numbers = [int(line) for line in sites.read_text().split()]
    sites.unlink()
    return numbers, max(numbers)


def check(program, folder, chance, runs, libraries, **_):
    """All allocations of all jobs on one thread, and a tenth of them with two threads of each
    backend, where runs are enough for them; a random choice otherwise."""
    counts, cases = {}, []
    workers = os.cpu_count() or 1
    for index, (job, on_two) in enumerate(zip(jobs(), jobs(2))):
        places = [folder / f"{index}-{worker}" for worker in range(workers)]
        places[0].mkdir()
        winding.sphere(places[0], rows=6)
        winding.queries(places[0], count=20)
        winding.hexahedra(places[0], per_axis=2)
        new = winding.written_by(program, job, places[0])
        old = {job.output: b"what was there before\n"}
        _, count = allocations_of(program, places[0], libraries, job)
        job.put(places[0], {})
        for place in places[1:]:
            shutil.copytree(places[0], place)
        cases += [(places, job, old, new, mode, number, None)
                  for mode in MODES for number in range(1, count + 1)]
        cases += [(places, on_two, old, new, mode, number, backend)
                  for mode in MODES for backend in BACKENDS
                  for number in chance.sample(range(1, count + 1), -(-count // 10))]
    total = len(cases)
    if runs < total:
        cases = chance.sample(cases, runs)

    def share(worker):
        return [one(program, places[worker], libraries, *case)
                for places, *case in cases[worker::workers]]

    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        for outcomes in pool.map(share, range(workers)):
            for outcome in outcomes:
                counts[outcome] = counts.get(outcome, 0) + 1
    return [f"{len(cases)} of {total} allocations", *(
        f"{count:6}  {outcome}" for outcome, count in sorted(counts.items()))]
