# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program `winding` under mpirun: results are as on one rank, and failures are one line.

Usage: program_test.py <the program winding> <mpirun> <number of ranks> <compare_images>. Prints
what it runs, and fails at the first fault.
"""

import filecmp
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import inputs  # noqa: E402

LONGEST_END = 20  # seconds until all ranks have ended after one was killed; 2.3 to 4.1 measured


class Runs:
    def __init__(self, program, mpirun, ranks, compare, folder):
        self.program, self.mpirun, self.ranks = program, mpirun, ranks
        self.compare, self.folder = compare, folder

    def command(self, words, ranks):
        launcher = [self.mpirun, "--oversubscribe", "-np", str(ranks)] if ranks else []
        return [*launcher, self.program, *words]

    def run(self, words, ranks=0, status=0):
        """Runs the program with `ranks` ranks, 0 for one without mpirun."""
        print(ranks, "ranks: winding", *words, flush=True)
        run = subprocess.run(self.command(words, ranks), cwd=self.folder, capture_output=True,
                             text=True, timeout=120)
        assert run.returncode == status, (run.returncode, run.stderr)
        return run

    def of_ranks(self, *words, status=0):
        return self.run(words, self.ranks, status)

    def alone(self, *words):
        return self.run(words)

    def share(self, cases):
        """Every second case: runs on two ranks take one half and runs on four the other, as each
        start takes MPI a second."""
        return list(cases)[self.ranks // 2 % 2 :: 2]

    def require_same(self, name, other):
        """Images have the same grid, arrays and values."""
        run = subprocess.run([self.compare, name, other], cwd=self.folder, capture_output=True,
                             text=True)
        assert run.returncode == 0 and not run.stderr, run.stderr
        assert float(run.stdout) == 0, run.stdout


def own_lines(run):
    """What the program says on standard error, without the words of mpirun."""
    return [line for line in run.stderr.splitlines() if line.startswith("winding:")]


def test_fields(runs):
    for source, options in runs.share((
            ("closed.obj", ["--inside"]),
            ("closed.obj", ["--cells", "--coverage", "fraction", "--dims", "30", "20", "2"]),
            ("closed.obj", ["--double", "--dims", "20", "20", "1"]),
            ("closed.obj", ["--distance", "--resolution", "40"]),
            ("scan.obj", []),
            ("soup.obj", ["--method", "hierarchical"]),
            ("cloud.xyz", []))):
        runs.alone("field", source, "-o", "one.vti", *options, "--quiet")
        for output in (["all.vti"], ["all.pvti"], ["all.pvti", "--pieces", "3"]):
            run = runs.of_ranks("field", source, "-o", *output, *options)
            assert run.stdout.count("wrote") == 1, run.stdout
            # A grid of few layers cannot be cut into three pieces for each rank.
            is_flat = "--dims" in options and "--pieces" in output
            lines = [line for line in own_lines(run) if "thinner than three voxels" not in line]
            assert len(lines) <= is_flat, run.stderr
            for line in lines:
                assert f"--pieces 3 on each of {runs.ranks} ranks is more than" in line, line
            runs.require_same("one.vti", output[0])
        assert filecmp.cmp(runs.folder / "one.vti", runs.folder / "all.vti", shallow=False)


def test_verification(runs):
    """Samples are the whole grid's, whichever rank compares them."""
    (runs.folder / "cube.off").write_text(
        "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
        "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n")
    # Centres of voxels lie on all faces of the cube.
    words = ["field", "cube.off", "-o", "v.vti", "--dims", "13", "13", "13", "--bounds",
             *("-0.3125", "1.3125") * 3, "--verify", "500", "--json"]
    alone, of_ranks = (json.loads(run(*words).stdout) for run in (runs.alone, runs.of_ranks))
    assert alone["on_surface"] > 100, alone
    names = ("on_surface", "beside_points", "max_error", "near_max_error", "inside")
    for name in names:
        assert of_ranks[name] == alone[name], (name, of_ranks[name], alone[name])
    # Errors of this size distinguish ranks, and the worst sample is of the first or the last one.
    for bounds in ("-1.5 1.5 -1.5 1.5 -3 1.2", "-1.5 1.5 -1.5 1.5 -1.2 3"):
        for source in runs.share(("closed.obj", "cloud.xyz")):
            words = ["field", source, "-o", "v.vti", "--dims", "21", "14", "34", "--bounds",
                     *bounds.split(), "--verify", "300", "--json", "--inside", "--method",
                     "hierarchical", "--tolerance", "0.01"]
            alone = json.loads(runs.alone(*words).stdout)
            of_ranks = json.loads(runs.of_ranks(*words).stdout)
            assert alone["max_error"] > 1e-6, alone
            for name in (*names, "beside_points_max_error"):
                assert of_ranks[name] == alone[name], (name, of_ranks[name], alone[name])
            assert abs(of_ranks["rms_error"] / alone["rms_error"] - 1) < 1e-9, (of_ranks, alone)


def test_pieces(runs):
    """The folder holds the pieces of the last run, and no more."""
    runs.alone("field", "closed.obj", "-o", "p.pvti", "--pieces", "9")
    assert len(list((runs.folder / "p").iterdir())) == 9
    run = runs.of_ranks("field", "closed.obj", "-o", "p.pvti", "--json")
    assert sorted(path.name for path in (runs.folder / "p").iterdir()) == [
        f"p_{rank}.vti" for rank in range(runs.ranks)]
    report = json.loads(run.stdout)
    if runs.ranks > 1:
        assert report["ranks"] == runs.ranks
        assert report["peak_memory"] == max(report["peak_memory_of_ranks"])
        assert len(report["peak_memory_of_ranks"]) == runs.ranks
        assert report["threads"] <= max(1, os.cpu_count() // runs.ranks)


def test_on_an_image(runs):
    """All ranks lie on the image that the first one has read."""
    words = ["scan.obj", "--like", "ct.nii", "-o"]
    runs.alone("field", *words, "one.vti")
    runs.alone("labels", *words, "one.nii")
    runs.of_ranks("field", *words, "all.vti")
    runs.require_same("one.vti", "all.vti")
    runs.of_ranks("field", *words, "all.pvti", status=2)
    runs.of_ranks("labels", *words, "all.nii")
    assert filecmp.cmp(runs.folder / "one.nii", runs.folder / "all.nii", shallow=False)


def test_probe_and_surface(runs):
    for words, suffix in runs.share((
                          (["probe", "closed.obj", "points.csv"], ".csv"),
                          (["probe", "closed.obj", "points.csv", "--extract"], ".csv"),
                          (["probe", "closed.obj", "mesh.vtu", "--distance"], ".vtu"),
                          (["probe", "closed.obj", "mesh.vtu", "--extract"], ".vtu"),
                          (["probe", "closed.obj", "cloud.xyz", "--inside-out"], ".vtp"),
                          (["probe", "scan.obj", "points.csv", "--method", "direct"], ".csv"),
                          (["surface", "closed.obj"], ".vtp"),
                          (["surface", "closed.obj", "--verify", "100"], ".ply"))):
        runs.alone(*words, "-o", "one" + suffix)
        run = runs.of_ranks(*words, "-o", "all" + suffix)
        assert run.stdout.count("wrote") == 1 and not run.stderr, (run.stdout, run.stderr)
        assert filecmp.cmp(runs.folder / ("one" + suffix), runs.folder / ("all" + suffix),
                           shallow=False), words


def test_broken_queries(runs):
    """Queries that a probe refuses are refused on any number of ranks, in the same words."""
    (runs.folder / "broken.vtk").write_text(
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
        "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 99\n")
    words = ["probe", "closed.obj", "broken.vtk", "-o", "q.vtp"]
    alone, of_ranks = runs.run(words, status=2), runs.of_ranks(*words, status=2)
    assert own_lines(alone) == own_lines(of_ranks) and len(own_lines(alone)) == 1, of_ranks.stderr


def test_labels(runs):
    for sources, options in runs.share((
            (["part.obj", "closed.obj"], ["--count", "--overlap", "smallest"]),
            (["part.obj", "closed.obj"], ["--coverage", "fraction", "--cells"]),
            (["part.obj", "scan.obj"], ["--coverage", "fraction", "--shares", "each"]),
            (["part.obj"], ["--overlap", "largest"]))):
        words = ["labels", *sources, "--resolution", "24", *options]
        alone = json.loads(runs.alone(*words, "-o", "one.vti", "--json").stdout)
        for output in (["all.vti"], ["all.pvti"], ["all.pvti", "--pieces", "2"]):
            run = runs.of_ranks(*words, "-o", *output, "--json")
            runs.require_same("one.vti", output[0])
            report = json.loads(run.stdout)
            is_whole = output[0] == "all.vti"
            for label, own in zip(report["labels"], alone["labels"], strict=True):
                assert label["name"] == own["name"] and label["label"] == own["label"]
                assert not is_whole or label["voxels"] == own["voxels"], (label, own)
            assert {key: report["solids"][key] for key in ("count", "empty", "open")} == {
                key: alone["solids"][key] for key in ("count", "empty", "open")}
        assert filecmp.cmp(runs.folder / "one.vti", runs.folder / "all.vti", shallow=False)
        for suffix in (".vtp", ".stl"):
            runs.alone(*words, "-o", "one" + suffix)
            runs.of_ranks(*words, "-o", "all" + suffix)
            assert filecmp.cmp(runs.folder / ("one" + suffix), runs.folder / ("all" + suffix),
                               shallow=False), words


def test_failures(runs):
    (runs.folder / "broken.obj").write_text("v 0 0\nf 1 2 3\n")
    (runs.folder / "broken.vtu").write_text("<VTKFile")
    (runs.folder / "other").mkdir()
    (runs.folder / "other" / "mine.txt").write_text("mine")
    # The piece of the last rank alone cannot be written.
    (runs.folder / "last" / f"last_{runs.ranks - 1}.vti").mkdir(parents=True)
    commands = [(["field", "none.obj", "-o", "f.vti"], 2),
                (["field", "broken.obj", "-o", "f.pvti"], 2),
                (["field", "points.xyz", "-o", "f.pvti"], 2),
                (["field", "closed.obj", "-o", "none/f.vti"], 2),
                (["field", "closed.obj", "-o", "none/f.pvti"], 2),
                (["field", "closed.obj", "-o", "other.pvti"], 2),
                (["field", "closed.obj", "-o", "last.pvti"], 2),
                (["probe", "closed.obj", "broken.vtu", "-o", "f.vtu"], 2),
                (["probe", "closed.obj", "none.csv", "-o", "f.csv"], 2),
                (["surface", "closed.obj", "-o", "none/f.vtp"], 2),
                (["labels", "closed.obj", "none.obj", "-o", "f.vti"], 2),
                (["labels", "cloud.xyz", "-o", "f.pvti"], 2),
                (["labels", "closed.obj", "-o", "none/f.vtp"], 2),
                (["surface", "closed.obj", "-o", "f.vtp", "--tolerance", "-1"], 1),
                (["field", "closed.obj"], 1)]
    if runs.ranks > 1:
        commands += [(["voxels", "closed.obj", "-o", "f.vtp"], 1), (["check", "closed.obj"], 1),
                     (["normals", "cloud.xyz", "-o", "f.xyz"], 1),
                     (["field", "closed.obj", "-o", "f.vti", "--pieces", "2"], 1),
                     (["labels", "closed.obj", "-o", "f.vti", "--pieces", "2"], 1)]
    for words, status in runs.share(commands):
        run = runs.of_ranks(*words, status=status)
        lines = own_lines(run)
        assert len(lines) == 1 and lines[0].startswith("winding: error: "), run.stderr
        assert not run.stdout.strip(), run.stdout
    left = [str(path) for path in runs.folder.rglob("*")
            if path.name.startswith("f.") or ".part" in path.name or path.suffix == ".pvti"]
    assert not [name for name in left if not name.endswith(("all.pvti", "p.pvti"))], left
    assert (runs.folder / "other" / "mine.txt").read_text() == "mine"
    assert runs.of_ranks("field", "--help").stdout.count("winding field [OPTIONS]") == 1
    assert runs.of_ranks("--version").stdout.count("\n") == 1


def children_of(process):
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = path.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if int(fields[1]) == process:
            found.append(int(path.parent.name))
    return sorted(found)


def test_killed_ranks(runs):
    """Where one rank dies all do, no file bears its final name, and the next run clears the
    rest."""
    for output in ("end.vti", "end.pvti"):
        signals = ((signal.SIGKILL, True), (signal.SIGINT, True), (signal.SIGINT, False))
        for signal_number, is_rank in signals if output == "end.vti" else runs.share(signals):
            words = ["field", "soup.obj", "-o", output, "--method", "direct", "--resolution", "400"]
            with subprocess.Popen(runs.command(words, runs.ranks), cwd=runs.folder,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                  text=True) as process:
                wait_for_work(runs, process)
                print("signal", int(signal_number), "to", "a rank" if is_rank else "mpirun", output,
                      flush=True)
                os.kill(children_of(process.pid)[-1] if is_rank else process.pid, signal_number)
                start = time.monotonic()
                errors = process.communicate(timeout=LONGEST_END)[1]
                print(f"ended after {time.monotonic() - start:.1f} s", flush=True)
            assert process.returncode != 0
            assert errors.count("winding: interrupted") <= 1, errors
            if signal_number == signal.SIGINT and is_rank:
                assert process.returncode == 130, process.returncode
            assert not (runs.folder / output).exists()
            assert not list((runs.folder / "end").glob("end_*.vti"))
        runs.of_ranks("field", "closed.obj", "-o", output, "--quiet")
        left = [path.name for path in runs.folder.rglob("*") if ".part" in path.name]
        assert not left, left
        (runs.folder / output).unlink()
        for path in (runs.folder / "end").glob("*"):
            path.unlink()


def wait_for_work(runs, process):
    """Waits until all ranks are there and have worked for a while."""
    while len(children_of(process.pid)) < runs.ranks:
        assert process.poll() is None, process.communicate()
        time.sleep(0.1)
    time.sleep(2)


def main(program, mpirun, ranks, compare):
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        inputs.main(folder)
        runs = Runs(program, mpirun, int(ranks), compare, folder)
        for test in (test_fields, test_verification, test_pieces, test_on_an_image,
                     test_probe_and_surface, test_broken_queries, test_labels, test_failures,
                     test_killed_ranks):
            test(runs)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
