# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""How functions run: errors, warnings, Ctrl-C and threads."""

import copy
import ctypes
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time
import unittest
import warnings

import numpy as np

import vtkwinding
from arrays_test import CORNERS, CUBE, sphere
from vtkwinding import _library, fields

# The direct sum of an open sphere at these points takes two minutes and more.
LONG = """
import os, signal, sys, threading, time
import numpy as np
import vtkwinding
{filter}
signal.signal(signal.SIGINT, signal.default_int_handler) # shells have it ignored in the background
sys.path.insert(0, {folder!r})
from arrays_test import sphere
vertices, faces, _ = sphere(200)
points = np.random.default_rng(1).random((6_000_000, 3))
def work():
    vtkwinding.winding_number(points, vertices, faces[:-5], method="direct",
                              longest_expected_time=0)
{setup}
print("ready", flush=True)
start = time.time()
try:
    {call}
    print("done")
except KeyboardInterrupt:
    print("KeyboardInterrupt")
print(signal.getsignal(signal.SIGINT) is before, flush=True)
os._exit(0)  # a thread that still works must not find Python gone
"""


class ErrorTest(unittest.TestCase):
    def test_errors_are_raised_as_one_line(self):
        for call in (vtkwinding.field, vtkwinding.surface):
            with self.assertRaises(vtkwinding.WindingError) as caught:
                call(CORNERS, CUBE, resolution=100_000)
            self.assertIsInstance(caught.exception, RuntimeError)
            self.assertRegex(str(caught.exception), r"^not enough memory: choose larger voxels "
                                                    r".*[^\n]$")

    def test_each_status_of_the_library_is_raised(self):
        class Library:
            """One whose functions all end with a status and a text."""

            def __getattr__(self, name):
                def function(*arguments):
                    arguments[-1]._obj.text = b"no room"
                    return status

                return getattr(before, name) if name.endswith("_init") else function

        before = _library._library
        self.addCleanup(setattr, _library, "_library", before)
        voxels = "no room: choose larger voxels (resolution=, spacing=)"
        panel = "no room: choose larger voxels (Resolution)"
        for status, name, words, kind, text in (
                (_library.REFUSED, "winding_boolean", 1, vtkwinding.WindingError, "no room"),
                (_library.INTERRUPTED, "winding_boolean", 1, _library.WindingInterrupted,
                 "winding_boolean was interrupted"),
                (_library.NO_MEMORY, "winding_boolean", 1, _library.WindingMemoryError, voxels),
                (_library.NO_MEMORY, "winding_label", 1, _library.WindingMemoryError, voxels),
                (_library.NO_MEMORY, "winding_level_surface", 2, _library.WindingMemoryError,
                 panel),
                (_library.NO_MEMORY, "winding_evaluate_grid", 2, _library.WindingMemoryError,
                 panel),
                (_library.NO_MEMORY, "winding_faces", 1, _library.WindingMemoryError, "no room"),
                (_library.MISUSED, "winding_label", 1, vtkwinding.WindingError,
                 "winding_label: no room (status 4)"),
                (_library.FAILED, "winding_faces", 1, vtkwinding.WindingError,
                 "winding_faces: no room (status 5)")):
            with self.subTest(status=status, name=name):
                _library._library = Library()
                with self.assertRaises(kind) as caught:
                    _library.call(name, words=words)
                _library._library = before
                self.assertIs(type(caught.exception), kind)
                self.assertEqual(str(caught.exception), text)

    def test_warnings_are_those_of_the_caller(self):
        with warnings.catch_warnings(record=True) as notes:
            warnings.simplefilter("always")
            vtkwinding.winding_number(CORNERS, CORNERS, CUBE[:, ::-1])
        self.assertEqual([note.category for note in notes], [vtkwinding.WindingWarning])
        self.assertEqual(notes[0].filename, __file__)

    def test_nothing_stays_behind(self):
        before = signal.getsignal(signal.SIGINT), sys.unraisablehook
        vtkwinding.field(CORNERS, CUBE, resolution=8)
        self.assertEqual((signal.getsignal(signal.SIGINT), sys.unraisablehook), before)

    def test_what_shows_progress_may_end_the_work(self):
        field = vtkwinding.Field(*sphere(60)[:2])
        shares = []

        def fails(share):
            shares.append(share)
            raise ZeroDivisionError("in the bar")

        def work(show):
            grid = field._grid(resolution=100)
            field._on_grid(grid, {"winding": np.dtype("f4")},
                           fields.Sides(0.5, "signed", None, 0), show=show)

        self.assertRaisesRegex(ZeroDivisionError, "in the bar", work, fails)
        self.assertTrue(all(0 <= share <= 1 for share in shares))
        self.assertRaises(_library.WindingInterrupted, work, lambda share: True)
        work(lambda share: False)


class InterruptTest(unittest.TestCase):
    def interrupted(self, setup="before = signal.getsignal(signal.SIGINT)", call="work()",
                    warns=False):
        """What a long evaluation prints that gets Ctrl-C, and the seconds that it then takes. If it
        warns, that is to come before."""
        code = LONG.format(
            folder=str(pathlib.Path(__file__).parent), setup=setup, call=call,
            filter="" if warns else "import warnings; warnings.simplefilter('ignore')")
        process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, text=True)
        self.addCleanup(process.kill)
        self.assertEqual(process.stdout.readline(), "ready\n")
        if warns:
            self.assertIn("WindingWarning: this takes about", process.stdout.readline())
        time.sleep(1)
        start = time.time()
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate(timeout=100)
        self.assertEqual(process.returncode, 0, output)
        return output.split(), time.time() - start

    def test_ctrl_c_ends_an_evaluation(self):
        words, seconds = self.interrupted()
        self.assertEqual(words, ["KeyboardInterrupt", "True"])
        self.assertLess(seconds, 15)  # 0.3 on a machine with nothing else to do

    def test_long_work_is_told_before_it_is_done(self):
        words, _ = self.interrupted(warns=True)
        self.assertEqual(words[-2:], ["KeyboardInterrupt", "True"])

    def test_handlers_of_others_are_asked(self):
        words, seconds = self.interrupted(
            "def before(*_): print('asked'); raise KeyboardInterrupt\n"
            "signal.signal(signal.SIGINT, before)")
        self.assertEqual(words, ["asked", "KeyboardInterrupt", "True"])
        self.assertLess(seconds, 15)

    def test_handlers_that_return_let_the_work_go_on(self):
        field, asked = vtkwinding.Field(*sphere(60)[:2]), []

        def work(show):
            field._on_grid(field._grid(resolution=100), {"winding": np.dtype("f4")},
                           fields.Sides(0.5, "signed", None, 0), show=show)

        def interrupts(_share):
            if not asked:
                signal.raise_signal(signal.SIGINT)

        def interrupts_within(_share):
            vtkwinding.winding_number(CORNERS, CORNERS, CUBE)  # has a handler, too
            interrupts(None)

        before = signal.getsignal(signal.SIGINT)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        for show in (interrupts, interrupts_within):
            signal.signal(signal.SIGINT, lambda *arguments: asked.append(arguments))
            asked.clear()
            work(show)
            self.assertEqual(len(asked), 1)

            def fails(*arguments):
                asked.append(arguments)
                raise ZeroDivisionError("in the handler")

            signal.signal(signal.SIGINT, fails)
            asked.clear()
            self.assertRaisesRegex(ZeroDivisionError, "in the handler", work, show)
            self.assertIs(signal.getsignal(signal.SIGINT), fails)

    def test_work_within_work_is_ended_too(self):
        def fails(*_):
            raise ZeroDivisionError("in the handler")

        before = signal.signal(signal.SIGINT, fails)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        with self.assertRaises(ZeroDivisionError), _library.Interrupt() as outer:
            with self.assertRaises(ZeroDivisionError), _library.Interrupt():
                signal.raise_signal(signal.SIGINT)
            self.assertTrue(outer.is_set())

    def test_the_main_thread_is_free_meanwhile(self):
        words, seconds = self.interrupted(
            "before = signal.getsignal(signal.SIGINT)\n"
            "thread = threading.Thread(target=work, daemon=True)",
            "thread.start(); thread.join()")
        self.assertEqual(words[0], "KeyboardInterrupt")
        self.assertLess(seconds, 15)


class ThreadTest(unittest.TestCase):
    def test_two_threads_at_once_give_the_bits_of_one(self):
        vertices, faces, normals = sphere(60)
        points = np.random.default_rng(2).random((3000, 3)) - 0.5
        calls = [lambda: vtkwinding.winding_number(points, vertices, faces[:-5]),
                 lambda: vtkwinding.signed_distance(points, vertices, faces),
                 lambda: vtkwinding.field(vertices, faces, resolution=40, n_threads=1).values,
                 lambda: vtkwinding.field(vertices, faces[:-5], resolution=20).values,
                 lambda: vtkwinding.winding_number(points, vertices, normals=normals)]
        expected = [call() for call in calls]
        faults = []

        def work(turn):
            for step in range(20):
                index = (step + turn) % len(calls)
                if not np.array_equal(calls[index](), expected[index]):
                    faults.append((turn, step))

        threads = [threading.Thread(target=work, args=(turn,)) for turn in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(faults, [])


@unittest.skipUnless(hasattr(os, "fork"), "there is no fork here")
class ForkTest(unittest.TestCase):
    def test_children_of_fork_work(self):
        """Threads that the parent has started do not live on in a child."""
        vertices, faces, _ = sphere(60)
        expected = vtkwinding.field(vertices, faces[:-5], resolution=20).values
        self.check_child(lambda: np.array_equal(
            vtkwinding.field(vertices, faces[:-5], resolution=20).values, expected))

    def test_children_may_ask_what_a_thread_of_their_parent_builds(self):
        vertices, faces, _ = sphere(200)
        field = vtkwinding.Field(vertices, faces, method="hierarchical")
        copied = copy.copy(field)
        for asked in (field, copied):
            builds, goes_on = threading.Event(), threading.Event()

            def hold(asked=asked, builds=builds, goes_on=goes_on):
                with asked._lock:
                    builds.set()
                    goes_on.wait()

            thread = threading.Thread(target=hold)
            thread.start()
            builds.wait()
            try:
                self.check_child(lambda asked=asked: asked.contains([[0, 0, 0]])[0])
            finally:
                goes_on.set()
                thread.join()
            self.assertTrue(asked.contains([[0, 0, 0]])[0])

    def check_child(self, holds):
        """Fails unless `holds()` is true in a child of fork(), within a minute."""
        child = os.fork()
        if child == 0:
            os._exit(0 if holds() else 3)
        end, status = time.time() + 60, None
        while status is None and time.time() < end:
            done, code = os.waitpid(child, os.WNOHANG)
            status = code if done else time.sleep(0.05)
        if status is None:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
        self.assertEqual(status, 0)


class StructsTest(unittest.TestCase):
    """The structs of ctypes lie in memory as a compiler of C has them."""

    @unittest.skipUnless(sys.maxsize > 2**32, "places are listed for addresses of 64 bits")
    def test_members_are_where_c_has_them(self):
        listed = pathlib.Path(__file__).resolve().parents[1] / "c/interface_1.txt"
        found = 0
        for line in listed.read_text(encoding="utf-8").splitlines():
            kind, name, *numbers = line.split()
            struct = _library._MEMBERS.get(name.split(".")[0])
            if kind == "member":
                member = getattr(struct, name.split(".")[1])
                self.assertEqual([member.offset, member.size], list(map(int, numbers[:2])), line)
                found += 1
            elif kind == "struct":
                self.assertEqual(ctypes.sizeof(struct), int(numbers[0]), line)
        self.assertGreater(found, 150)


if __name__ == "__main__":
    unittest.main()
