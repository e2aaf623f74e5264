// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Images and grids as queries. Of medical ones the header says where the voxels lie.

#include "apps/Images.h"
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLStructuredGridReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

/// Reads what the program has written. The reader keeps it.
vtkImageData* readImage(vtkXMLImageDataReader* reader, const std::string& fileName)
{
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// Probes the unit sphere at an image, and expects this place for the result: a centre of a voxel
/// and the steps along the indices. Its values have to be the sphere's.
void expectPlace(const std::string& name, const std::string& contents, double tolerance = 1e-12)
{
  SCOPED_TRACE(name);
  const TemporaryFolder folder;
  const std::string out = folder.path("out.vti");
  const Outcome run = runProgram({"probe", folder.write("in.off", asOff(sphere())),
    folder.write(name, contents), "-o", out, "--array", "w"});
  ASSERT_EQ(run.status, 0) << run;
  vtkNew<vtkXMLImageDataReader> reader;
  vtkImageData* const image = readImage(reader, out);
  ASSERT_EQ(image->GetNumberOfPoints(), 7 * 8 * 9);
  for (const std::array<int, 3> index :
    {std::array<int, 3>{0, 0, 0}, {6, 0, 0}, {0, 7, 0}, {3, 4, 8}})
  {
    const std::array<double, 3> expected = voxelOfHead(index);
    double found[3];
    image->TransformIndexToPhysicalPoint(index.data(), found);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(found[axis], expected[static_cast<std::size_t>(axis)], tolerance);
    }
  }
  vtkDataArray* const w = image->GetPointData()->GetArray("w");
  int inside = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* const at = image->GetPoint(i);
    const double radius = std::hypot(at[0], at[1], at[2]);
    if (std::abs(radius - 0.98) > 0.021) // between the faces and the sphere
    {
      ASSERT_EQ(w->GetTuple1(i), radius < 1) << i;
    }
    inside += w->GetTuple1(i) > 0.5;
  }
  EXPECT_GT(inside, 20);
}

TEST(ImageQueries, LieWhereMedicalHeadersSay)
{
  expectPlace("head.mha", asMetaImage());
  expectPlace("head.MHA", asMetaImage());
  expectPlace("head.nrrd", asNrrd("left-posterior-superior"));
  expectPlace("head.nrrd", asNrrd("RAS"));
  expectPlace("head.nrrd", asNrrd("left posterior superior"));
  expectPlace("head.nrrd", asNrrd("3D-Left-Handed"));
  expectPlace("head.nrrd", asNrrd("", "3 7 8 9", "none "));
  // Single precision.
  expectPlace("head.nii", asNifti(NiftiKind::sform), 1e-6);
  expectPlace("head.nii", asNifti(NiftiKind::qform), 1e-6);
  expectPlace("head.nii", asNifti(NiftiKind::bigEndian), 1e-6);
  expectPlace("head.nii", asNifti(NiftiKind::wide));
  expectPlace("head.nii.gz", packedByGzip(asNifti(NiftiKind::sform)), 1e-6);
  expectPlace("head.nii", packedByGzip(asNifti(NiftiKind::sform)), 1e-6);
  // In several parts, of which one is empty, as bgzip and pigz make them.
  const std::string nifti = asNifti(NiftiKind::sform);
  expectPlace("head.nii.gz",
    packedByGzip("") + packedByGzip(nifti.substr(0, 100)) + packedByGzip(nifti.substr(100)), 1e-6);
}

/// Returns a text with its first `before` replaced.
std::string with(std::string text, const std::string& before, const std::string& after)
{
  return text.replace(text.find(before), before.size(), after);
}

TEST(ImageQueries, FieldsOfNrrdHaveNamesInSeveralSpellings)
{
  const std::string nrrd = asNrrd("left-posterior-superior");
  expectPlace("head.nrrd", with(nrrd, "space directions", "Space Directions"));
  expectPlace("head.nrrd", with(nrrd, "space origin", "SPACE ORIGIN"));
  expectPlace("head.nrrd", with(nrrd, "space directions", "spacedirections"));
  expectPlace("head.nrrd", with(nrrd, "space origin", "spaceorigin"));
  expectPlace("head.nrrd", with(with(nrrd, "sizes", "SIZES"), "dimension", "Dimension"));
  expectPlace("head.nrrd", with(nrrd, "kinds", "sizes:=1 1 1\nspace origin:=key of a user\nkinds"));
}

TEST(ImageQueries, WithoutDirectionsAreStraight)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1))), out = folder.path("out.vti");
  const std::string meta = "ObjectType = Image\nNDims = 3\nDimSize = 3 4 5\n"
                           "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
  const std::string nrrd = "NRRD0004\n# no directions\ntype: uchar\ndimension: 3\nsizes: 3 4 5\n"
                           "spacings: 1 NaN 1\nkey:=value: of a user\nencoding: raw\n\n";
  for (const std::string& image : {folder.write("a.mha", meta), folder.write("a.nrrd", nrrd)})
  {
    const Outcome run = runProgram({"probe", in, image, "-o", out});
    ASSERT_EQ(run.status, 0) << run;
    vtkNew<vtkXMLImageDataReader> reader;
    const double expected[6] = {0, 2, 0, 3, 0, 4};
    double bounds[6];
    readImage(reader, out)->GetBounds(bounds);
    EXPECT_TRUE(std::equal(bounds, bounds + 6, expected)) << image;
  }
}

TEST(ImageQueries, HeadersHaveSeveralWritings)
{
  const std::string meta = asMetaImage(), nrrd = asNrrd("LPS");
  std::string colons = meta;
  std::replace(colons.begin(), colons.end(), '=', ':');
  expectPlace("head.mha", colons);
  expectPlace("head.mha", with(meta, "ElementSpacing = ", "ElementSpacing = +"));
  expectPlace("head.nrrd", with(nrrd, "kinds", "sizes:=1 1 1\nkinds"));
  // Headers of images in other files, which need not be there.
  expectPlace("head.mhd", with(meta, "LOCAL", "voxels.raw"));
  const std::string inFiles = with(nrrd, "kinds", "data file: voxels.raw\nkinds");
  expectPlace("head.nhdr", inFiles);
  expectPlace("head.nhdr", inFiles.substr(0, inFiles.size() - 1));
  expectPlace("head.nrrd", inFiles.substr(0, inFiles.size() - 1));
  expectPlace("head.nhdr", with(nrrd, "\n\n", "\ndatafile: LIST\na.raw\nb.raw\n"));
  // Steps that the sform makes useless.
  std::string steps = asNifti(NiftiKind::sform);
  steps.replace(80, 4, "\x00\x00\xc0\x7f", 4);
  expectPlace("head.nii", steps, 1e-6);
}

TEST(ImageQueries, MayHaveTwoAxesOrMoreThanThree)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1))), out = folder.path("out.vti");
  const auto expectImage =
    [&](const std::string& name, const std::string& contents, const std::array<double, 6>& bounds)
  {
    const Outcome run = runProgram({"probe", in, folder.write(name, contents), "-o", out});
    ASSERT_EQ(run.status, 0) << run;
    vtkNew<vtkXMLImageDataReader> reader;
    vtkImageData* const image = readImage(reader, out);
    for (std::size_t n = 0; n < 6; ++n)
    {
      EXPECT_NEAR(image->GetBounds()[n], bounds[n], 1e-12) << contents;
    }
    EXPECT_NEAR(image->GetSpacing()[2], 2, 1e-12) << contents;
  };
  const std::string meta = "ObjectType = Image\n", file = "\nElementDataFile = LOCAL\n";
  expectImage("a.mha",
    meta + "NDims = 2\nTransformMatrix = 1 0 0 1\nOffset = 3 4\nElementSpacing = 1 2\n" +
      "DimSize = 5 6" + file,
    {3, 7, 4, 14, 0, 0});
  expectImage("a.mha",
    meta + "NDims = 4\nOffset = 3 4 5 6\nElementSpacing = 1 1 2 9\nDimSize = 5 6 7 8" + file,
    {3, 7, 4, 9, 5, 17});
  const std::string nrrd = "NRRD0004\ntype: uchar\n";
  expectImage("a.nrrd",
    nrrd + "dimension: 2\nspace dimension: 2\nsizes: 5 6\nspace directions: (1,0) (0,2)\n" +
      "space origin: (+3,+4e0)\n\n",
    {3, 7, 4, 14, 0, 0});
  expectImage("a.nrrd",
    nrrd + "dimension: 2\nspace: LPS\nsizes: 5 6\nspace directions: (1,0,0) (0,2,0)\n" +
      "space origin: (3,4,5)\n\n",
    {3, 7, 4, 14, 5, 5});
  expectImage("a.nrrd",
    nrrd + "dimension: 4\nspace: LPST\nsizes: 5 6 7 8\nspace origin: (3,4,5,6)\n" +
      "space directions: (1,0,0,0) (0,1,0,0) (0,0,2,0) (0,0,0,1)\n\n",
    {3, 7, 4, 9, 5, 17});
  const std::string colours = "dimension: 4\nsizes: 3 5 6 7\nspacings: nan 1 1 2\n";
  expectImage(
    "a.nrrd", nrrd + colours + "kinds: RGB-color domain domain domain\n\n", {0, 4, 0, 5, 0, 12});
  expectImage("a.nrrd",
    nrrd + "dimension: 4\nsizes: 5 6 7 8\nspacings: 1 1 2 9\nkinds: domain domain domain time\n\n",
    {0, 4, 0, 5, 0, 12});
  const Outcome run =
    runProgram({"probe", in, folder.write("a.nrrd", nrrd + colours + "\n"), "-o", out});
  EXPECT_TRUE(run.saysInOneLine({"a.nrrd", "more than 3 axes of space"})) << run;
}

TEST(ImageQueries, OfNrrdMayHaveEndsOfAxes)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1))), out = folder.path("out.vti");
  const auto expectFirst = [&](const std::string& fields, const std::array<double, 3>& expected,
                             const std::string& axes = "dimension: 3\nsizes: 3 4 5\n")
  {
    const std::string image =
      folder.write("a.nrrd", "NRRD0004\ntype: uchar\n" + axes + fields + "\nencoding: raw\n\n");
    const Outcome run = runProgram({"probe", in, image, "-o", out});
    ASSERT_EQ(run.status, 0) << run;
    vtkNew<vtkXMLImageDataReader> reader;
    const double* const first = readImage(reader, out)->GetPoint(0);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(first[axis], expected[axis], 1e-12) << fields;
    }
  };
  // SimpleITK 2.5 says these.
  const std::string spacings = "spacings: 1.1 1.3 1.7\n", mins = "axis mins: 3 -9 0\n";
  expectFirst(spacings + mins + "kinds: domain domain domain", {3.55, -8.35, 0.85});
  expectFirst(spacings + mins + "centerings: cell cell cell", {3.55, -8.35, 0.85});
  expectFirst(spacings + mins + "centers: node cell ???", {3, -8.35, 0.85});
  expectFirst(spacings + "Axis Mins: 3 -9 0\naxismaxs: 9 9 9", {3.55, -8.35, 0.85});
  expectFirst(mins + "axis maxs: 6 3 15", {3.5, -7.5, 1.5});
  expectFirst("spacings: nan 1.1 1.3 1.7\naxis mins: nan 3 -9 0\ncenters: ??? node cell node",
    {3, -8.35, 0}, "dimension: 4\nsizes: 3 3 4 5\nkinds: RGB-color domain domain domain\n");
}

TEST(ImageQueries, OfVtkKeepTheirArrays)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere()));
  const std::string field = folder.path("field.vti"), out = folder.path("out.vti");
  ASSERT_EQ(
    runProgram({"field", in, "-o", field, "--resolution", "9", "--array", "before"}).status, 0);
  const Outcome run = runProgram({"probe", in, field, "-o", out, "--distance"});
  ASSERT_EQ(run.status, 0) << run;
  vtkNew<vtkXMLImageDataReader> reader, expected;
  vtkImageData* const image = readImage(reader, out);
  vtkDataArray* const before = readImage(expected, field)->GetPointData()->GetArray("before");
  for (const char* name : {"before", "WindingNumber", "SignedDistance", "Inside"})
  {
    ASSERT_NE(image->GetPointData()->GetArray(name), nullptr) << name;
  }
  for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(image->GetPointData()->GetArray("before")->GetTuple1(i), before->GetTuple1(i));
    ASSERT_EQ(image->GetPointData()->GetArray("WindingNumber")->GetTuple1(i), before->GetTuple1(i));
  }
  const std::string part = folder.path("part.vtu"), table = folder.path("table.csv");
  EXPECT_EQ(runProgram({"probe", in, field, "-o", part, "--extract"}).status, 0);
  EXPECT_EQ(runProgram({"probe", in, field, "-o", table}).status, 0);
  EXPECT_TRUE(runProgram({"probe", in, in, "-o", out})
                .saysInOneLine({"out.vti", "cannot hold the cells of the queries"}));
}

TEST(ImageQueries, MayBeGridsOfOtherKinds)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere()));
  const std::string curved = folder.write("in.vts", asCurvedGrid());
  const std::string straight = folder.write("in.vtr", asRectilinearGrid());
  const std::string vts = folder.path("out.vts"), vtr = folder.path("out.vtr");
  ASSERT_EQ(runProgram({"probe", in, curved, "-o", vts}).status, 0);
  ASSERT_EQ(runProgram({"probe", in, straight, "-o", vtr}).status, 0);
  vtkNew<vtkXMLStructuredGridReader> curvedReader;
  curvedReader->SetFileName(vts.c_str());
  curvedReader->Update();
  vtkNew<vtkXMLRectilinearGridReader> straightReader;
  straightReader->SetFileName(vtr.c_str());
  straightReader->Update();
  const double expected[8] = {1, 0, 0, 0, 0, 0, 0, 0}; // the first point alone is inside
  for (vtkDataSet* data : {static_cast<vtkDataSet*>(curvedReader->GetOutput()),
         static_cast<vtkDataSet*>(straightReader->GetOutput())})
  {
    ASSERT_EQ(data->GetNumberOfPoints(), 8);
    for (vtkIdType i = 0; i < 8; ++i)
    {
      EXPECT_NEAR(
        data->GetPointData()->GetArray("WindingNumber")->GetTuple1(i), expected[i], 1e-12);
    }
  }
}

TEST(ImageQueries, AreNoSources)
{
  const TemporaryFolder folder;
  const std::string image = folder.write("in.mha", asMetaImage());
  const Outcome run = runProgram({"field", image, "-o", folder.path("out.vti")});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.saysInOneLine({"in.mha", "is an image or a grid", "contour it first"})) << run;
}

TEST(ImageQueries, DamagedHeadersAreRefusedInOneLine)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1))), out = folder.path("out.vti");
  const auto refuses =
    [&](const std::string& name, const std::string& contents, const std::string& words)
  {
    const Outcome run = runProgram({"probe", in, folder.write(name, contents), "-o", out});
    EXPECT_EQ(run.status, 2) << run;
    EXPECT_TRUE(run.saysInOneLine({name, words})) << words << "\n" << run;
  };
  const std::string meta = asMetaImage(), nrrd = asNrrd("LPS"), nifti = asNifti(NiftiKind::sform);
  refuses("a.mha", with(meta, "NDims = 3", "NDims = 2"), "3 numbers in 'DimSize', not 2");
  refuses("a.mha", with(meta, "NDims = 3", "NDims = 1"), "number of axes in 'NDims'");
  refuses("a.mha", with(meta, "NDims", "Dims"), "no 'NDims'");
  refuses("a.mha", with(meta, "DimSize", "Size"), "no 'DimSize'");
  refuses("a.mha", with(meta, "DimSize = 7", "DimSize = 0"), "no number of voxels");
  refuses("a.mha", with(meta, "DimSize = 7", "DimSize = 1e99"), "no number of voxels");
  const std::string tooMany = "more voxels than there can be";
  refuses("a.mha", with(meta, "DimSize = 7", "DimSize = 100000001"), tooMany);
  refuses("a.mha", with(meta, "DimSize = 7 8 9", "DimSize = 100001 100001 100001"), tooMany);
  refuses("a.nrrd", with(nrrd, "sizes: 7 8 9", "sizes: 7 2147483647 9"), tooMany);
  refuses("a.mha", with(meta, "DimSize = 7", "DimSize ="), "has 2 numbers in 'DimSize', not 3");
  refuses("a.mha", with(meta, "0.25", "x"), "no number in 'ElementSpacing'");
  refuses("a.mha", with(meta, "0.25", "0"), "no size along an axis");
  refuses("a.mha", with(meta, "0.25", "nan"), "no number");
  refuses("a.mha", with(meta, "TransformMatrix = ", "TransformMatrix = 1 0 0 1 0 0 0 0 1\nx = "),
    "lie in a plane");
  refuses("a.mha", meta.substr(0, 60), "no end");
  refuses("a.nrrd", nrrd.substr(4), "does not begin like NRRD");
  refuses("a.nrrd", with(nrrd, "(", "["), "no vectors");
  refuses("a.nrrd", with(nrrd, "(", "none ("), "more vectors in 'space directions' than axes");
  refuses("a.nrrd", with(nrrd, "(", "(1,0,0,0,"), "7 numbers in 'space directions', not 3");
  refuses("a.nrrd", with(asNrrd(""), "space dimension: 3", "space dimension: 2"), "3 numbers in");
  refuses("a.nrrd", asNrrd("LPS", "7 8 9 2", "(1,0,0) "), "more than 3 axes of space");
  refuses("a.nrrd", asNrrd("LPST", "7 8 9 2", "(1,0,0,1) "), "space and time are mixed");
  refuses("a.nrrd", asNrrd("LPS", "7 8 9 2", "none none "), "more vectors");
  refuses("a.nrrd", with(nrrd, "dimension: 3", "dimension: 4"), "not 4");
  refuses("a.nrrd", with(nrrd, "sizes: 7 8 9\n", ""), "no 'sizes'");
  refuses("a.nrrd", with(nrrd, "sizes", "size"), "has 'size', which is no field");
  refuses("a.nrrd", with(nrrd, "space origin:", "space origin"), "which is no field");
  refuses("a.nrrd", with(nrrd, "kinds", "axis mins: 1 2 3\nkinds"), "'axis mins'");
  refuses("a.nrrd", asNrrd("right-anterior-inferior"), "space 'right-anterior-inferior'");
  refuses("a.nrrd", asNrrd("left"), "space 'left'");
  const std::string straight = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 7 8 9\n\n";
  refuses("a.nrrd", with(straight, "\n\n", "\naxis mins: 1 2 3\n\n"), "no 'spacings'");
  refuses("a.nrrd", with(straight, "\n\n", "\naxis maxs: 1 2 3\n\n"), "number in 'axis mins'");
  refuses("a.nrrd", with(straight, "\n\n", "\nspacings: 1 1 1\naxis mins: 1 nan 3\n\n"),
    "number in 'axis mins'");
  refuses("a.nrrd", with(nrrd, "kinds", "spacings: 1 1 1\nkinds"), "'spacings'");
  refuses("a.nrrd", with(straight, "\n\n", "\nspacings: 1 2\n\n"), "2 numbers in 'spacings'");
  refuses("a.nrrd", with(straight, "\n\n", "\ncenters: cell x cell\n\n"), "'x' in 'centers'");
  refuses("a.nrrd", with(nrrd, "kinds", "Sizes: 7 8 9\nkinds"), "has 'Sizes' twice");
  refuses("a.nrrd", nrrd.substr(0, nrrd.find("kinds")), "no end");
  refuses("a.nii", nifti.substr(0, 347), "ends before its header does");
  refuses("a.nii", nifti.substr(0, 3), "does not begin like NIfTI");
  refuses("a.nii", with(nifti, "n+1", "xxx"), "Analyze");
  const std::string packed = packedByGzip(nifti);
  refuses("a.nii.gz", packed.substr(0, 30), "ends before it is unpacked");
  refuses("a.nii.gz", packed.substr(0, packed.size() - 30), "ends before it is unpacked");
  refuses("a.nii.gz", packed.substr(0, 10) + std::string(50, 'x'), "cannot be unpacked");
  refuses("a.nii.gz", packedByGzip(""), "cannot be unpacked; it is damaged, or packs nothing");
  refuses("a.nii.gz", packedByGzip(nifti.substr(0, 347)), "ends before its header does");
  refuses("a.nii", "x" + nifti, "does not begin like NIfTI");
  std::string infinite = nifti;
  infinite.replace(280, 4, "\x00\x00\x80\x7f", 4);
  refuses("a.nii", infinite, "not finite");
  refuses("a.vti", "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\">", "a.vti");
}

} // namespace
