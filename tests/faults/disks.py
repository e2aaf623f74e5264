# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Disks that are full, and folders that are read-only."""

import ctypes
import os
import pathlib
import resource
import shutil
import subprocess
import sys

import program as winding
from program import require

CAP_DAC_OVERRIDE, PR_CAPBSET_DROP = 1, 24


def limits(biggest, steps):
    """Sizes from nothing to what is enough."""
    return sorted({round(biggest * step / steps) for step in range(steps + 1)})


def disturbed(program, folder, job, old, new, **more):
    """A run that may fail: all is as before then, and it says so."""
    job.put(folder, old)
    status, errors = winding.run(program, job, folder, **more)
    winding.require_status(status, errors)
    is_new = winding.require_whole(job, folder, old, new)
    require(not winding.part_files(folder), "left:", winding.part_files(folder))
    if status == winding.DONE:
        require(is_new, "status 0 without the result")
        return True
    winding.require_refusal(status, errors)
    require("cannot be" in errors, "the reason is missing:", errors)
    require(job.files(folder) == old, "an old file was replaced, but the run has failed")
    return False


def limited(program, folder, steps):
    """A limit on the size of files stops writers in the middle, as a full disk does."""
    done = failed = 0
    for job in winding.jobs():
        old, new = winding.old_and_new(program, job, folder)
        # The program looks whether a file can still grow by 64 KiB.
        for size in limits(max(map(len, new.values())) + (1 << 17), steps):
            def limit(size=size):
                resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
            if disturbed(program, folder, job, old, new, preexec_fn=limit):
                done += 1
            else:
                failed += 1
        job.put(folder, {})
    require(done and failed, "limits are to be too small and large enough:", failed, done)
    return f"limits on the size of files: {failed} runs refused, {done} done"


def mounted(program, folder, steps):
    """A small disk of its own, in a mount name space of its own."""
    done = failed = 0
    for job in winding.jobs():
        old, new = winding.old_and_new(program, job, folder)
        needed = 2 * sum(map(len, new.values())) + (1 << 19)
        for size in limits(needed, steps)[1:]:
            disk = folder / "disk"
            disk.mkdir(exist_ok=True)
            subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", disk],
                           check=True)
            try:
                winding.put_inputs(disk)
                job.put(disk, old)
            except OSError:  # not even that fits
                subprocess.run(["umount", disk], check=True)
                continue
            if disturbed(program, disk, job, old, new):
                done += 1
            else:
                failed += 1
            subprocess.run(["umount", disk], check=True)
    require(done and failed, "disks are to be too small and large enough:", failed, done)
    return f"small disks: {failed} runs refused, {done} done"


def in_name_space(program, folder, steps):
    """mounted(), by another Python within a mount name space; None where the system has none."""
    enter = ["unshare", *([] if os.geteuid() == 0 else ["--map-root-user"]), "--mount"]
    mount = [*enter, "mount", "-t", "tmpfs", "tmpfs", folder]
    if not shutil.which("unshare") or subprocess.run(mount, capture_output=True).returncode:
        return None
    inner = subprocess.run([*enter, sys.executable, __file__, program, folder, str(steps)],
                           capture_output=True, text=True)
    require(inner.returncode == 0, inner.stdout, inner.stderr)
    return inner.stdout.strip()


def without_leave_to_write_anywhere():
    """Takes from the superuser what makes permissions idle; nobody else has it."""
    ctypes.CDLL(None).prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0)


def read_only(program, folder):
    for job in winding.jobs():
        old, new = winding.old_and_new(program, job, folder)
        job.put(folder, old)
        folders = [folder, folder / pathlib.Path(job.output).stem]
        for path in folders:
            if path.exists():
                path.chmod(0o555)
        try:
            status, errors = winding.run(program, job, folder,
                                         preexec_fn=without_leave_to_write_anywhere)
            winding.require_refusal(status, errors)
            require("Permission denied" in errors, errors)
            require(job.files(folder) == old, "a file in a read-only folder has changed")
        finally:
            for path in folders:
                if path.exists():
                    path.chmod(0o755)
        job.put(folder, {})
    return f"read-only folders: {len(winding.jobs())} runs refused"


def check(program, folder, runs, **_):
    lines = [limited(program, folder, runs), read_only(program, folder)]
    on_disks = in_name_space(program, folder, runs)
    return lines + [on_disks or "small disks: left out, since this system mounts none for us"]


if __name__ == "__main__":
    print(mounted(sys.argv[1], pathlib.Path(sys.argv[2]), int(sys.argv[3])))
