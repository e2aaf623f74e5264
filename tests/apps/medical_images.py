# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Masks on medical images lie where nibabel and SimpleITK look for them.

Environment: WINDING_PROGRAM. Without nibabel or SimpleITK nothing is tested, and the status is 77;
the tests of Like have the bytes of all formats without them.
"""

import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import nibabel
    import numpy as np
    import SimpleITK
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

COUNTS, STEPS, CENTER, RADIUS = (20, 24, 17), np.array([0.9, 1.1, 1.7]), np.array([3, 2, 1]), 9
TO_RAS = np.diag([-1, -1, 1, 1])


def directions(is_mirrored):
    """Columns that no axis of space is."""
    a, b, c, d = np.array([1, 2, 3, 4]) / math.sqrt(30)
    columns = np.array([
        [a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
        [2 * (b * c + a * d), a * a + c * c - b * b - d * d, 2 * (c * d - a * b)],
        [2 * (b * d - a * c), 2 * (c * d + a * b), a * a + d * d - b * b - c * c]])
    return columns * ([1, 1, -1] if is_mirrored else 1)


def write_images(folder):
    """Images of every format with the ball in the middle. The names of their files."""
    for is_mirrored in (False, True):
        axes = directions(is_mirrored)
        first = CENTER - axes @ (STEPS * (np.array(COUNTS) - 1) / 2)
        affine = np.eye(4)
        affine[:3, :3], affine[:3, 3] = axes * STEPS, first
        name = "left" if is_mirrored else "right"
        for suffix, sform, qform in ((".nii", 1, 1), (".nii.gz", 1, 0), ("_q.nii", 0, 1)):
            image = nibabel.Nifti1Image(np.zeros(COUNTS, np.int16), affine)
            image.set_sform(affine, sform)
            image.set_qform(affine, qform)
            nibabel.save(image, folder / f"{name}{suffix}")
            yield f"{name}{suffix}"
            image.header.set_xyzt_units("meter", "sec")
            nibabel.save(image, folder / f"{name}_metre{suffix}")
            yield f"{name}_metre{suffix}"
        wide = nibabel.Nifti2Image(np.zeros(COUNTS, np.int16), affine)
        nibabel.save(wide, folder / f"{name}_wide.nii")
        yield f"{name}_wide.nii"
        image = SimpleITK.Image(list(COUNTS), SimpleITK.sitkInt16)
        image.SetOrigin(first.tolist())
        image.SetSpacing(STEPS.tolist())
        image.SetDirection(axes.ravel().tolist())
        for suffix in (".mha", ".nrrd"):
            SimpleITK.WriteImage(image, str(folder / f"{name}{suffix}"), suffix == ".nrrd")
            yield f"{name}{suffix}"


def by_itk(path):
    """The affine transform to RAS, and the voxels."""
    image = SimpleITK.ReadImage(str(path))
    affine = np.eye(4)
    affine[:3, :3] = np.array(image.GetDirection()).reshape(3, 3) * image.GetSpacing()
    affine[:3, 3] = image.GetOrigin()
    return TO_RAS @ affine, SimpleITK.GetArrayFromImage(image).transpose(2, 1, 0)


def by_nibabel(path):
    image = nibabel.load(path)
    return image.affine, np.asarray(image.dataobj)


def write_ball(path):
    turns, heights = 48, 24
    with open(path, "w", encoding="ascii") as file:
        for i in range(heights + 1):
            polar = math.pi * i / heights
            for j in range(turns):
                ring = [math.sin(polar) * math.cos(2 * math.pi * j / turns),
                        math.sin(polar) * math.sin(2 * math.pi * j / turns), math.cos(polar)]
                file.write("v %.9f %.9f %.9f\n" % tuple(CENTER + RADIUS * np.array(ring)))
        for i in range(heights):
            for j in range(turns):
                a, b = i * turns + j + 1, i * turns + (j + 1) % turns + 1
                file.write(f"f {a} {a + turns} {b + turns} {b}\n")


class MedicalImages(unittest.TestCase):
    def test_masks_lie_on_the_image(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_ball(folder / "ball.obj")
            for like in write_images(folder):
                for output in ("mask.mha", "mask.nrrd", "mask.nii", "packed.nii.gz"):
                    for command in (["voxels"], ["field"], ["field", "--double"], ["labels"]):
                        with self.subTest(f"{' '.join(command)} --like {like} -o {output}"):
                            self.check(folder, like, output, command)

    def check(self, folder, like, output, command):
        subprocess.run(
            [os.environ["WINDING_PROGRAM"], command[0], folder / "ball.obj", "-o", folder / output,
             "--like", folder / like, "--quiet", *command[1:]], check=True)
        of_nifti = ".nii" in like
        affine, voxels = (by_nibabel if of_nifti else by_itk)(folder / like)
        ways = [by_itk] + ([by_nibabel] if ".nii" in output else [])
        # The mesh is in the coordinates of the image's file.
        indices = np.stack(np.meshgrid(*map(np.arange, COUNTS), indexing="ij"), -1)
        places = indices @ affine[:3, :3].T
        places = (places + affine[:3, 3]) * (1 if of_nifti else [-1, -1, 1])
        radii = np.linalg.norm(places - CENTER, axis=-1)
        are_clear = np.abs(radii - 0.995 * RADIUS) > 0.006 * RADIUS  # between faces and sphere
        kind = {"voxels": "u1", "labels": "u2"}.get(command[0], "f8" if command[1:] else "f4")
        for read in ways:
            found, mask = read(folder / output)
            # ITK gives mm whatever the unit, and reads no NIfTI-2; nibabel the file's numbers.
            is_plain = of_nifti and (read == by_nibabel or "wide" in like)
            expected = (by_nibabel if is_plain else by_itk)(folder / like)[0]
            unit = 1000 if "metre" in like and read == by_itk else 1
            np.testing.assert_allclose(found, expected, atol=3e-6 * unit)
            self.assertEqual(mask.dtype.newbyteorder("="), np.dtype(kind))
            self.assertEqual(mask.shape, voxels.shape)
            np.testing.assert_array_equal((mask > 0.5)[are_clear], (radii < RADIUS)[are_clear])


if __name__ == "__main__":
    unittest.main()
