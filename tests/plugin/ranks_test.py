# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""A source that the ranks of a parallel server hold in parts gives what one rank gives: pvbatch
with and without --sym, and a server of several ranks with a client."""
import collections
import glob
import json
import os
import socket
import subprocess
import tempfile
import unittest

here = os.path.dirname(os.path.abspath(__file__))
pipelines = os.path.join(here, "ranks_pipelines.py")
mesh = os.path.join(os.environ["WINDING_SHARED_DATA"], "bunny_10k.obj")
limit = 200  # seconds; a rank that waits for others would wait for ever


def ranks(count, *command):
    return [os.environ["WINDING_MPIRUN"], "--oversubscribe", "-np", str(count), *command]


def facts_in(folder):
    """The facts of each deal: facts of all ranks together, and lists of each rank's facts."""
    facts = collections.defaultdict(dict)
    for path in sorted(glob.glob(os.path.join(folder, "*.json"))):
        deal, *name, _ = os.path.basename(path).rsplit(".json", 1)[0].split(".")
        with open(path) as file:
            found = json.load(file)
        if not name:
            facts[deal].update(found)
        for key, value in found.items() if name else ():
            facts[deal].setdefault(f"{name[0]}.{key}", []).append(value)
    return facts


def facts_of(command):
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [*command, mesh, folder], capture_output=True, text=True, timeout=limit
        )
        if done.returncode != 0:
            raise AssertionError(done.stdout + done.stderr)
        return facts_in(folder)


@unittest.skipUnless(os.path.exists(mesh), f"{mesh} is not there")
class Ranks(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.expected = facts_of(ranks(1, os.environ["WINDING_PVBATCH"], pipelines))["reader"]

    def compare(self, facts, count):
        self.assertEqual(set(facts), {"reader", "RedistributeDataSet", "D3"})
        expected = self.expected
        for deal, found in facts.items():
            with self.subTest(deal=deal):
                for key in ("extent", "inside", "faces", "bounds"):
                    self.assertEqual(found.get(key, expected[key]), expected[key], key)
                for key in ("report.triangles", "report.boundary_edges"):
                    self.assertEqual(found[key], expected[key] * count, key)
                # A closed surface has no other values; a rank may have one side alone.
                for name in ("field.w", "probe.w"):
                    values = {w for span in found[name] for w in span}
                    self.assertEqual(values, {0.0, 1.0}, name)
                area = sum(found["areas.area"])
                self.assertAlmostEqual(area, sum(expected["areas.area"]), delta=1e-9, msg=deal)

    def test_pvbatch(self):
        for count in (2, 4):
            with self.subTest(ranks=count):
                command = ranks(count, os.environ["WINDING_PVBATCH"], pipelines)
                self.compare(facts_of(command), count)

    def test_pvbatch_on_every_rank(self):
        command = ranks(3, os.environ["WINDING_PVBATCH"], "--sym", pipelines)
        self.compare(facts_of(command), 3)

    def test_server_with_a_client(self):
        with socket.socket() as free:
            free.bind(("localhost", 0))
            port = free.getsockname()[1]
        server = subprocess.Popen(
            ranks(3, os.environ["WINDING_PVSERVER"], f"--server-port={port}"),
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        try:
            for line in server.stdout:
                if "Accepting connection" in line:
                    break
            with tempfile.TemporaryDirectory() as folder:
                client = [os.environ["WINDING_PVPYTHON"], pipelines, mesh, folder, str(port)]
                done = subprocess.run(client, capture_output=True, text=True, timeout=limit)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.compare(facts_in(folder), 3)
        finally:
            server.kill()
            server.communicate()


if __name__ == "__main__":
    unittest.main()
