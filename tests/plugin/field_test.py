# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter Winding Number Field in ParaView."""
import math
import os
import tempfile
import unittest

from paraview import servermanager, simple

from support import (errors_of, information, result, run_tests, sphere_points, unit_sphere,
                     value_at, warnings_of)


class TestField(unittest.TestCase):
    def test_sphere(self):
        field = simple.WindingNumberField(Input=unit_sphere(), Resolution=20, GenerateInside=1)
        image = result(field)
        self.assertEqual(image.GetDimensions(), (20, 20, 20))
        self.assertEqual(image.GetPointData().GetScalars().GetName(), "WindingNumber")
        self.assertAlmostEqual(value_at(image, (0, 0, 0)), 1, places=6)
        self.assertAlmostEqual(value_at(image, (0.95, 0.95, 0.95)), 0, places=6)
        self.assertEqual(value_at(image, (0, 0, 0), "Inside"), 1)
        self.assertEqual(value_at(image, (0.95, 0.95, 0.95), "Inside"), 0)
        self.assertEqual(information(field, "Status"), 0)
        self.assertTrue(information(field, "MethodUsed"))
        self.assertTrue(information(field, "MethodReason"))

    def test_signed_distance(self):
        field = simple.WindingNumberField(
            Input=unit_sphere(), Resolution=21, Padding=0.5, GenerateSignedDistance=1
        )
        image = result(field)
        # The faces of the sphere are up to 0.01 inside of it.
        self.assertAlmostEqual(value_at(image, (0, 0, 0), "SignedDistance"), -1, delta=0.02)
        corner = image.GetPoint(0)
        beyond = math.dist(corner, (0, 0, 0)) - 1
        self.assertAlmostEqual(value_at(image, corner, "SignedDistance"), beyond, delta=0.02)
        field.DistanceBand = 2
        image = result(field)
        band = 2 * image.GetSpacing()[0]
        self.assertAlmostEqual(value_at(image, (0, 0, 0), "SignedDistance"), -band, places=6)
        self.assertAlmostEqual(value_at(image, corner, "SignedDistance"), band, places=6)

    def test_sampling_bounds_start_as_those_of_the_input(self):
        sphere = simple.Sphere(Center=(5, 6, 7), Radius=1, ThetaResolution=4, PhiResolution=3)
        sphere.UpdatePipeline()
        field = simple.WindingNumberField(Input=sphere)
        for actual, expected in zip(field.SamplingBounds, (4, 6, 5, 7, 6, 8)):
            self.assertAlmostEqual(actual, expected, places=5)

    def test_sampling_bounds_and_dimensions(self):
        field = simple.WindingNumberField(
            Input=unit_sphere(),
            UseInputBounds=0,
            SamplingBounds=(0, 4, 0, 2, 0, 1),
            SamplingDimensions=(4, 4, 1),
            OutputAssociation="Cells",
            OutputScalarType="Double",
            ResultArrayName="w",
        )
        warnings = warnings_of(field)
        image = result(field)
        self.assertEqual(len(warnings), 1)
        self.assertIn("the source is thinner than three voxels", warnings[0])
        self.assertEqual(image.GetBounds(), (0, 4, 0, 2, 0, 1))
        self.assertEqual(image.GetDimensions(), (5, 5, 2))
        self.assertEqual(image.GetCellData().GetArray("w").GetDataTypeAsString(), "double")

    def test_composite_input_is_one_source(self):
        group = simple.GroupDatasets(Input=[unit_sphere(), unit_sphere(Center=(3, 0, 0))])
        field = simple.WindingNumberField(Input=group, Resolution=40)
        image = result(field)
        self.assertTrue(image.IsA("vtkImageData"))
        for center in ((0, 0, 0), (3, 0, 0)):
            self.assertAlmostEqual(value_at(image, center), 1, places=6)
        self.assertAlmostEqual(value_at(image, (1.5, 0, 0)), 0, places=6)

    def test_unstructured_grid(self):
        grid = simple.AppendDatasets(Input=unit_sphere())
        image = result(simple.WindingNumberField(Input=grid, Resolution=10))
        self.assertAlmostEqual(value_at(image, (0, 0, 0)), 1, places=6)

    def test_threshold_and_resolution_keep_what_was_prepared(self):
        sphere = unit_sphere()
        field = simple.WindingNumberField(Input=sphere, Resolution=8)
        field.UpdatePipeline()
        self.assertGreater(information(field, "PrepareSeconds"), 0)
        field.Resolution = 9
        field.WindingThreshold = 0.25
        field.UpdatePipeline()
        self.assertEqual(information(field, "PrepareSeconds"), 0)
        sphere.Radius = 2
        field.UpdatePipeline()
        self.assertGreater(information(field, "PrepareSeconds"), 0)

    def test_cloud(self):
        with sphere_points(2000, True) as reader:
            renamed = simple.Calculator(Input=reader, ResultArrayName="Orientation")
            renamed.Function = "2*Normals"
            sized = simple.Calculator(Input=renamed, ResultArrayName="Size")
            sized.Function = f"{4 * math.pi / 2000}"
            cloud = simple.PassArrays(Input=sized, PointDataArrays=["Orientation", "Size"])
            cloud.UpdatePipeline()
        field = simple.WindingNumberField(
            Input=cloud,
            Resolution=11,
            EstimateNormals=0,
            NormalsArray="Orientation",
            PointAreaMethod="Array",
            AreaArray="Size",
        )
        self.assertAlmostEqual(value_at(result(field), (0, 0, 0)), 1, delta=0.01)
        self.assertEqual(list(field.GetProperty("NormalsArray").Available),
                         ["Active Normals", "Orientation"])
        self.assertEqual(list(field.GetProperty("AreaArray").Available), ["Size"])

        # No array named: the active normals, of which there are none.
        errors = errors_of(field)
        for field.NormalsArray in ("", "Active Normals", "None"):
            field.UpdatePipeline()
            self.assertTrue(errors)
            for error in errors:
                self.assertIn("the points have no normals: use Estimate Normals", error)
            self.assertEqual(information(field, "Status"), 1)
            errors.clear()

    def test_none_takes_the_active_normals(self):
        with sphere_points(2000, True) as cloud:
            field = simple.WindingNumberField(Input=cloud, Resolution=11)
            self.assertEqual(field.NormalsArray, "Active Normals")
            self.assertAlmostEqual(value_at(result(field), (0, 0, 0)), 1, delta=0.01)

    def test_mesh_as_points(self):
        sphere = unit_sphere(ThetaResolution=64, PhiResolution=64)
        field = simple.WindingNumberField(Input=sphere, Resolution=11, InputAsPoints=1)
        for field.PointAreaMethod in ("Voronoi", "Mesh", "Constant"):
            with self.subTest(field.PointAreaMethod):
                field.PointArea = 4 * math.pi / (64 * 62 + 2)
                self.assertAlmostEqual(value_at(result(field), (0, 0, 0)), 1, delta=0.01)

    def test_cloud_with_default_areas(self):
        path = os.path.join(os.environ.get("WINDING_SHARED_DATA", ""), "kitten_points_normals.ply")
        if not os.path.exists(path):
            self.skipTest(f"{path} is not there")
        field = simple.WindingNumberField(Input=simple.OpenDataFile(path), Resolution=32)
        image = result(field)
        self.assertAlmostEqual(value_at(image, (0, 0, 0)), 1, delta=0.01)
        self.assertAlmostEqual(image.GetPointData().GetScalars().GetTuple1(0), 0, delta=0.01)

    def test_normals_are_estimated_unless_users_say_no(self):
        with sphere_points(2000, False) as cloud:
            field = simple.WindingNumberField(Input=cloud, Resolution=11, EstimateNormals=0)
            errors = errors_of(field)
            field.UpdatePipeline()
            self.assertTrue(errors)
            for error in errors:
                self.assertIn("the points have no normals: use Estimate Normals", error)
            field.EstimateNormals = 1
            image = result(field)
        self.assertAlmostEqual(value_at(image, (0, 0, 0)), 1, delta=0.01)
        self.assertAlmostEqual(value_at(image, (0.9, 0.9, 0.9)), 0, delta=0.01)

    def test_verification(self):
        field = simple.WindingNumberField(Input=unit_sphere(), Resolution=16, VerifySamples=50)
        field.OutputScalarType = "Double"
        field.UpdatePipeline()
        for name in ("MaxError", "RMSError", "NearMaxError"):
            self.assertLess(information(field, name), 1e-3)
        self.assertGreater(information(field, "MaxError"), 0)

    def test_parity(self):
        field = simple.WindingNumberField(Input=unit_sphere(), Resolution=16, Method="Ray Parity")
        self.assertEqual(value_at(result(field), (0, 0, 0)), 1)
        self.assertEqual(information(field, "MethodUsed"), "parity")

    def test_time(self):
        with tempfile.TemporaryDirectory() as folder:
            for time in (0, 1):
                sphere = unit_sphere(Radius=1 + time)
                simple.CreateWriter(os.path.join(folder, f"{time}.vtp"), sphere).UpdatePipeline()
            series = os.path.join(folder, "series.pvd")
            with open(series, "w", encoding="ascii") as file:
                file.write('<VTKFile type="Collection"><Collection>')
                file.writelines(f'<DataSet timestep="{t}" file="{t}.vtp"/>' for t in (0, 1))
                file.write("</Collection></VTKFile>")
            growing = simple.OpenDataFile(series)
            field = simple.WindingNumberField(
                Input=growing, UseInputBounds=0, SamplingBounds=(-3, 3, -3, 3, -3, 3), Resolution=24
            )
            following = simple.WindingNumberField(Input=growing, Resolution=22)
            for time, expected in ((0, 0), (1, 1), (0, 0)):
                field.UpdatePipeline(time)
                image = servermanager.Fetch(field)
                self.assertAlmostEqual(value_at(image, (1.375, 0.125, 0.125)), expected, places=5)
                following.UpdatePipeline(time)
                spacing = servermanager.Fetch(following).GetSpacing()[0]
                self.assertAlmostEqual(spacing, 0.1 * (1 + time), delta=0.01)
            executive = field.GetClientSideObject().GetExecutive()
            steps = executive.GetOutputInformation(0).Get(executive.TIME_STEPS())
            self.assertEqual(steps, (0, 1))

    def test_grid_follows_animations(self):
        sphere = unit_sphere()
        field = simple.WindingNumberField(Input=sphere, Resolution=22)
        surface = simple.WindingNumberSurface(Input=sphere, Resolution=22)
        report = simple.WindingNumberReport(Input=sphere)
        track = simple.GetAnimationTrack("Radius", proxy=sphere)
        first, last = simple.CompositeKeyFrame(), simple.CompositeKeyFrame()
        first.KeyTime, first.KeyValues = 0, [1]
        last.KeyTime, last.KeyValues = 1, [3]
        track.KeyFrames = [first, last]
        scene = simple.GetAnimationScene()
        scene.PlayMode = "Sequence"
        scene.StartTime, scene.EndTime = 0, 1
        for time in (0, 1, 0.5):
            scene.AnimationTime = time
            radius = 1 + 2 * time
            for proxy in (field, surface, report):
                proxy.UpdatePipeline(time)
            image = servermanager.Fetch(field)
            self.assertAlmostEqual(image.GetSpacing()[0], radius / 10, delta=0.01)
            self.assertAlmostEqual(value_at(image, (0, 0, 0)), 1, places=5)
            self.assertAlmostEqual(value_at(image, image.GetPoint(0)), 0, places=5)
            top = servermanager.Fetch(surface).GetBounds()[5]
            self.assertAlmostEqual(top, radius, delta=0.05 * radius)
            area = servermanager.Fetch(report).GetFieldData().GetArray("area").GetValue(0)
            self.assertAlmostEqual(area, 4 * math.pi * radius**2, delta=0.1 * area)

    def test_hopeless_waits_are_refused(self):
        sphere = unit_sphere(ThetaResolution=300, PhiResolution=300)
        field = simple.WindingNumberField(Input=sphere, Resolution=512, Method="Direct Sum")
        errors = errors_of(field)
        field.UpdatePipeline()
        self.assertEqual(len(errors), 1)
        self.assertRegex(errors[0], "this takes about .* (hours|days): "
                                    "use Method: Automatic, behind the gear, or ")
        self.assertIn("(Longest Expected Time, behind the gear)", errors[0])
        self.assertEqual(information(field, "Status"), 1)

    def test_progress_and_abort(self):
        field = simple.WindingNumberField(Input=unit_sphere(), Resolution=64, NumberOfThreads=1)
        vtk_object = field.GetClientSideObject()
        progress = []

        def abort(*_):
            progress.append(vtk_object.GetProgress())
            # What the button of ParaView 6 calls.
            if hasattr(vtk_object, "SetAbortExecuteAndUpdateTime"):
                vtk_object.SetAbortExecuteAndUpdateTime()
            else:
                vtk_object.SetAbortExecute(1)

        observer = vtk_object.AddObserver("ProgressEvent", abort)
        field.UpdatePipeline()
        self.assertEqual(information(field, "Status"), 3)
        self.assertLess(progress[0], 1)

        vtk_object.RemoveObserver(observer)
        vtk_object.SetAbortExecute(0)  # VTK's own filters, too, stay aborted until then
        field.Resolution = 20
        self.assertAlmostEqual(value_at(result(field), (0, 0, 0)), 1, places=6)
        self.assertEqual(information(field, "Status"), 0)
        self.assertEqual(vtk_object.GetProgressText(), "Evaluating")

    def test_all_filters_can_be_aborted(self):
        sphere = unit_sphere(ThetaResolution=200, PhiResolution=200)
        wavelet = simple.Wavelet(WholeExtent=[-40, 40] * 3)
        for proxy in (
            simple.WindingNumberField(Input=sphere, Resolution=128),
            simple.WindingNumberSurface(Input=sphere, Resolution=128),
            simple.WindingNumberProbe(Input=wavelet, Source=sphere),
            simple.WindingNumberClip(Input=wavelet, Source=sphere),
        ):
            with self.subTest(proxy.GetXMLName()):
                vtk_object = proxy.GetClientSideObject()
                vtk_object.AddObserver("ProgressEvent", lambda *_: vtk_object.SetAbortExecute(1))
                proxy.UpdatePipeline()
                self.assertEqual(information(proxy, "Status"), 3)
                self.assertEqual(servermanager.Fetch(proxy).GetNumberOfPoints(), 0)


if __name__ == "__main__":
    run_tests()
