"""How functions run: errors, warnings, Ctrl-C and threads."""

import contextlib
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
from vtkmodules.vtkCommonCore import vtkObject, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource

import vtkwinding
from arrays_test import CORNERS, CUBE, sphere
from vtkwinding import _run
from vtkwinding_native.vtkFiltersWinding import vtkSurfaceReport, vtkWindingNumberField

# The direct sum of an open sphere at so many points takes half a minute and more.
LONG = """
import os, signal, sys, threading, time
import numpy as np
import vtkwinding
{filter}
signal.signal(signal.SIGINT, signal.default_int_handler) # shells have it ignored in the background
sys.path.insert(0, {folder!r})
from arrays_test import sphere
vertices, faces, _ = sphere(200)
points = np.random.default_rng(1).random((1_000_000, 3))
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


def field_of(source):
    field = vtkWindingNumberField()
    field.SetInputConnection(source.GetOutputPort())
    return field


class ErrorTest(unittest.TestCase):
    def test_errors_are_raised_as_one_line(self):
        field = field_of(vtkSphereSource())
        field.SetResolution(-1)
        with self.assertRaisesRegex(vtkwinding.WindingError, r"^resolution is -1") as caught:
            _run.run(field)
        self.assertIsInstance(caught.exception, RuntimeError)
        self.assertNotIn("\n", str(caught.exception))
        self.assertNotIn("0x", str(caught.exception))

    def test_errors_are_raised_where_vtk_shows_none(self):
        before = vtkObject.GetGlobalWarningDisplay()
        self.addCleanup(vtkObject.SetGlobalWarningDisplay, before)
        vtkObject.GlobalWarningDisplayOff()
        for call in (vtkwinding.field, vtkwinding.surface):
            self.assertRaises(vtkwinding.WindingError, call, CORNERS, CUBE, resolution=100_000)
        with self.assertWarns(vtkwinding.WindingWarning):
            vtkwinding.winding_number(CORNERS, CORNERS, CUBE[:, ::-1])
        self.assertEqual(vtkObject.GetGlobalWarningDisplay(), 0)

    def test_errors_of_the_pipeline_are_raised(self):
        report = vtkSurfaceReport()
        report.SetInputDataObject(vtkImageData())
        self.assertRaises(vtkwinding.WindingError, _run.run, report)
        self.assertRaises(vtkwinding.WindingError, _run.run, vtkWindingNumberField())

    def test_warnings_are_those_of_the_caller(self):
        field = vtkWindingNumberField()
        field.SetInputData(vtkPolyData())
        with warnings.catch_warnings(record=True) as notes:
            warnings.simplefilter("always")
            _run.run(field)
        self.assertEqual([note.category for note in notes], [vtkwinding.WindingWarning])
        self.assertEqual(notes[0].filename, __file__)

    def test_nothing_stays_behind(self):
        field = field_of(vtkSphereSource())
        before = signal.getsignal(signal.SIGINT)
        _run.run(field)
        for event in ("ErrorEvent", "WarningEvent", "ProgressEvent"):
            self.assertFalse(field.HasObserver(event))
        self.assertIs(signal.getsignal(signal.SIGINT), before)

    def test_what_fails_in_an_observer_ends_the_filter(self):
        class Bar:
            n = 0

            def update(self, _progress):
                raise ZeroDivisionError("in the bar")

        @contextlib.contextmanager
        def bar(_message):
            yield Bar()

        original, _run._bar = _run._bar, bar
        self.addCleanup(setattr, _run, "_bar", original)
        self.assertRaisesRegex(ZeroDivisionError, "in the bar", _run.run,
                               field_of(vtkSphereSource()), progress_bar=True)


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
        words, _ = self.interrupted(
            "def before(*_): print('asked')\nsignal.signal(signal.SIGINT, before)")
        self.assertEqual(words, ["asked", "KeyboardInterrupt", "True"])

    @unittest.skipIf(vtkVersion.GetVTKMajorVersion() * 100 + vtkVersion.GetVTKMinorVersion() < 907,
                     "VTK holds Python's lock while it works")
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
@unittest.skipIf(vtkVersion.GetVTKMajorVersion() * 100 + vtkVersion.GetVTKMinorVersion() < 907,
                 "VTK's threads are those of the system's backend")
class ForkTest(unittest.TestCase):
    def test_children_of_fork_work(self):
        """VTK's threads, which the parent has started, do not live on in a child."""
        vertices, faces, _ = sphere(60)
        expected = vtkwinding.field(vertices, faces[:-5], resolution=20).values
        child = os.fork()
        if child == 0:
            found = vtkwinding.field(vertices, faces[:-5], resolution=20).values
            os._exit(0 if np.array_equal(found, expected) else 3)
        end, status = time.time() + 60, None
        while status is None and time.time() < end:
            done, code = os.waitpid(child, os.WNOHANG)
            status = code if done else time.sleep(0.05)
        if status is None:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
        self.assertEqual(status, 0)


if __name__ == "__main__":
    unittest.main()
