// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Results that lie on an image, and medical images as outputs. tests/apps/medical_images.py has
/// other programs read them.

#include "apps/Images.h"
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPolyDataReader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace
{

/// A head, whose file has a space, in which the sphere lies around the origin.
struct Head
{
  std::string name, contents;
  bool isRas;
  double tolerance; ///< of places
};

std::vector<Head> heads()
{
  return {{"head.mha", asMetaImage(), false, 1e-12},
    {"head.nrrd", asNrrd("left-posterior-superior"), false, 1e-12},
    {"head.nii.gz", packedByGzip(asNifti(NiftiKind::sform)), true, 1e-6},
    {"head.nii", asNifti(NiftiKind::qform), true, 1e-6}};
}

/// Expects that voxels of an image lie where those of the head do, in a space that may look the
/// other way along x and y.
void expectPlace(vtkImageData* image, bool isTurned, double tolerance)
{
  ASSERT_EQ(image->GetNumberOfPoints(), 7 * 8 * 9);
  for (const std::array<int, 3> index :
    {std::array<int, 3>{0, 0, 0}, {6, 0, 0}, {0, 7, 0}, {3, 4, 8}})
  {
    const std::array<double, 3> expected = voxelOfHead(index);
    double found[3];
    image->TransformIndexToPhysicalPoint(index.data(), found);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double sign = isTurned && axis < 2 ? -1 : 1;
      EXPECT_NEAR(found[axis], sign * expected[static_cast<std::size_t>(axis)], tolerance);
    }
  }
}

TEST(Like, MasksLieOnTheVeryImageInEveryFormat)
{
  for (const Head& head : heads())
  {
    const TemporaryFolder folder;
    const std::string in = folder.write("in.off", asOff(sphere()));
    const std::string like = folder.write(head.name, head.contents);
    const std::string vti = folder.path("mask.vti");
    ASSERT_EQ(runProgram({"field", in, "-o", vti, "--inside-only", "--like", like}).status, 0);
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(vti.c_str());
    reader->Update();
    expectPlace(reader->GetOutput(), false, head.tolerance);
    vtkDataArray* const inside = reader->GetOutput()->GetPointData()->GetArray("Inside");
    ASSERT_NE(inside, nullptr);
    EXPECT_EQ(inside->GetRange()[1], 1);
    for (const std::string suffix : {".mha", ".nrrd", ".nii", ".nii.gz"})
    {
      SCOPED_TRACE(head.name + " to " + suffix);
      const std::string mask = folder.path("mask" + suffix), again = folder.path("again.vti");
      const Outcome run = runProgram({"voxels", in, "-o", mask, "--like", like});
      ASSERT_EQ(run.status, 0) << run;
      ASSERT_EQ(runProgram({"probe", in, mask, "-o", again}).status, 0);
      vtkNew<vtkXMLImageDataReader> placeReader;
      placeReader->SetFileName(again.c_str());
      placeReader->Update();
      // .nrrd has the space of the head, the others their own.
      const bool isRas = suffix == ".nrrd" ? head.isRas : suffix[1] == 'n';
      expectPlace(placeReader->GetOutput(), isRas != head.isRas, 1e-6);
      const std::string voxels = voxelsOf(mask, 7 * 8 * 9);
      ASSERT_EQ(voxels.size(), 7u * 8 * 9);
      for (vtkIdType i = 0; i < inside->GetNumberOfTuples(); ++i)
      {
        ASSERT_EQ(voxels[static_cast<std::size_t>(i)], inside->GetTuple1(i)) << i;
      }
    }
  }
}

TEST(Like, NumbersKeepTheirTypes)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere()));
  const std::string like = folder.write("head.nii", asNifti(NiftiKind::wide));
  constexpr std::size_t count = 7 * 8 * 9;
  for (const std::string suffix : {".mha", ".nrrd", ".nii.gz"})
  {
    const std::string out = folder.path("out" + suffix);
    ASSERT_EQ(runProgram({"field", in, "-o", out, "--like", like}).status, 0);
    float w = 0;
    std::string voxels = voxelsOf(out, count * sizeof w);
    ASSERT_EQ(voxels.size(), count * sizeof w);
    std::memcpy(&w, voxels.data() + count / 2 * sizeof w, sizeof w);
    EXPECT_EQ(w, 1) << "in the middle";
    ASSERT_EQ(runProgram({"field", in, "-o", out, "--like", like, "--double"}).status, 0);
    double wide = 0;
    voxels = voxelsOf(out, count * sizeof wide);
    std::memcpy(&wide, voxels.data() + count / 2 * sizeof wide, sizeof wide);
    EXPECT_EQ(wide, 1);
    ASSERT_EQ(runProgram({"labels", in, "-o", out, "--like", like}).status, 0);
    unsigned short label = 0;
    voxels = voxelsOf(out, count * sizeof label);
    std::memcpy(&label, voxels.data() + count / 2 * sizeof label, sizeof label);
    EXPECT_EQ(label, 1);
  }
}

TEST(Like, HeadersOfItsOwnOutputsComeBack)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere()));
  const std::string first = folder.path("first.nii"), second = folder.path("second.nii");
  ASSERT_EQ(runProgram({"voxels", in, "-o", first, "--resolution", "9"}).status, 0);
  ASSERT_EQ(runProgram({"voxels", in, "-o", second, "--like", first}).status, 0);
  EXPECT_EQ(contentsOf(first), contentsOf(second));
}

TEST(Like, SpacesWithoutAPatientCountAsLps)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1)));
  const auto masksLike = [&](const std::string& space)
  {
    const std::string like = folder.write("head.nrrd", asNrrd(space));
    std::string masks;
    for (const std::string suffix : {".nii", ".mha", ".nrrd"})
    {
      const std::string mask = folder.path("mask" + suffix);
      EXPECT_EQ(runProgram({"voxels", in, "-o", mask, "--like", like, "--overwrite"}).status, 0);
      masks += contentsOf(mask);
    }
    return masks;
  };
  const std::string expected = masksLike("left-posterior-superior");
  for (const std::string space : {"", "scanner-xyz", "3D-right-handed", "3D-left-handed"})
  {
    EXPECT_EQ(masksLike(space), expected) << space;
  }
  EXPECT_NE(masksLike("right-anterior-superior"), expected);
}

TEST(Like, NiftiOfTwoAxesIsASlice)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1)));
  std::string head = asNifti(NiftiKind::sform);
  head[40] = 2; // axes; what stands behind them counts for nothing
  for (const char layers : {1, 0, 7})
  {
    head[46] = layers;
    const Outcome run = runProgram({"field", in, "-o", folder.path("out.vti"), "--like",
      folder.write("slice.nii", head), "--overwrite", "--json"});
    ASSERT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.json()["grid"]["dimensions"][2], 1) << run;
  }
}

TEST(Like, NiftiKeepsTheUnitOfLengths)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1)));
  constexpr std::size_t units = 123; // the place in the header
  const auto maskLike =
    [&](const std::string& name, const std::string& head, const std::string& suffix)
  {
    const std::string mask = folder.path("mask" + suffix);
    const Outcome run = runProgram(
      {"voxels", in, "-o", mask, "--like", folder.write(name, head), "--overwrite", "--quiet"});
    EXPECT_EQ(run.status, 0) << run;
    return contentsOf(mask);
  };
  for (const int unit : {0, 1, 2, 3})
  {
    std::string head = asNifti(NiftiKind::sform), wide = asNifti(NiftiKind::wide);
    head[units] = static_cast<char>(unit | 8); // and seconds
    wide[500] = static_cast<char>(unit | 8);
    EXPECT_EQ(maskLike("head.nii", head, ".nii")[units], unit);
    EXPECT_EQ(maskLike("wide.nii", wide, ".nii")[units], unit);
    const double expected[] = {0.25, 250, 0.25, 0.00025};
    const std::string mha = maskLike("wide.nii", wide, ".mha"), key = "ElementSpacing = ";
    EXPECT_NEAR(std::stod(mha.substr(mha.find(key) + key.size())) / expected[unit], 1, 1e-12);
  }
  EXPECT_EQ(maskLike("head.mha", asMetaImage(), ".nii")[units], 2);
  EXPECT_EQ(maskLike("head.nrrd", asNrrd("RAS"), ".nii")[units], 2);
  const std::string plain = folder.path("plain.nii");
  ASSERT_EQ(runProgram({"voxels", in, "-o", plain, "--resolution", "5", "--quiet"}).status, 0);
  EXPECT_EQ(contentsOf(plain)[units], 0) << "a surface has no unit";
}

TEST(Like, NiftiKeepsItsCodesAndBothTransforms)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1)));
  constexpr std::size_t codes = 252, quaternion = 256, offsets = 268, rows = 280;
  const auto maskLike = [&](int qform, int sform)
  {
    std::string head = asNifti(NiftiKind::sform);
    head[codes] = static_cast<char>(qform);
    head[codes + 2] = static_cast<char>(sform);
    const float turn[] = {0.6F, 0, 0}, offset[] = {1, 2, 3}; // another place than the sform's
    std::memcpy(&head[quaternion], turn, sizeof turn);
    std::memcpy(&head[offsets], offset, sizeof offset);
    const std::string like = folder.write("head.nii", head), mask = folder.path("mask.nii");
    const Outcome run = runProgram({"voxels", in, "-o", mask, "--like", like, "--overwrite"});
    EXPECT_EQ(run.status, 0) << run;
    const bool saysNothing = qform == 0 && sform == 0;
    EXPECT_EQ(run.err.find("qform_code and sform_code are 0") != std::string::npos, saysNothing)
      << run;
    const std::string made = contentsOf(mask);
    EXPECT_EQ(made.substr(codes, 4), head.substr(codes, 4));
    if (qform > 0 && sform > 0)
    {
      EXPECT_EQ(made.substr(76, 16), head.substr(76, 16)) << "the steps";
      EXPECT_EQ(made.substr(quaternion, rows - quaternion), head.substr(quaternion, 24));
    }
    if (sform > 0)
    {
      EXPECT_EQ(made.substr(rows, 48), head.substr(rows, 48));
    }
  };
  maskLike(0, 0);
  maskLike(0, 4);
  maskLike(2, 0);
  maskLike(1, 4);
}

TEST(Like, NrrdKeepsTheUnitsOfSpace)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1)));
  const auto unitsLike = [&](const std::string& units)
  {
    std::string head = asNrrd("left-posterior-superior");
    head.insert(head.find("kinds"), units.empty() ? "" : "space units: " + units + "\n");
    const std::string mask = folder.path("mask.nrrd");
    const Outcome run = runProgram(
      {"voxels", in, "-o", mask, "--like", folder.write("head.nrrd", head), "--overwrite"});
    EXPECT_EQ(run.status, 0) << run;
    const std::string made = contentsOf(mask), key = "\nspace units: ";
    const std::size_t at = made.find(key);
    return at == std::string::npos
             ? ""
             : made.substr(at + key.size(), made.find('\n', at + 1) - at - key.size());
  };
  EXPECT_EQ(unitsLike(R"("um" "um" "um")"), R"("um" "um" "um")");
  EXPECT_EQ(unitsLike(R"("mm"   "mm" "a b" "s")"), R"("mm" "mm" "a b")");
  EXPECT_EQ(unitsLike(""), "");
  EXPECT_EQ(unitsLike("mm mm mm"), "") << "no units without quotation marks";
}

TEST(Like, DirectionsMayHaveFourDigits)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1)));
  const auto imageOf = [](const std::string& directions, const std::string& sizes)
  {
    return "ObjectType = Image\nNDims = 3\nTransformMatrix = " + directions +
           "\nElementSpacing = 0.5 0.5 0.5\nDimSize = " + sizes + "\nElementDataFile = LOCAL\n";
  };
  const std::string rounded = "0.7045 0.5934 0.3894 -0.7035 0.6565 0.2722 -0.0942 -0.4657 0.8799";
  for (const std::string suffix : {".mha", ".nrrd", ".nii", ".vti"})
  {
    const std::string like = folder.write("like.mha", imageOf(rounded, "9 9 9"));
    const Outcome run = runProgram(
      {suffix == ".vti" ? "field" : "voxels", in, "-o", folder.path("a" + suffix), "--like", like});
    EXPECT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.err.find("right angles"), std::string::npos) << run;
  }
  // The qform has right angles, and lies up to half of 9e-4 of 900 voxels away.
  const std::string like = folder.write("like.mha", imageOf("1 0 0 9e-4 1 0 0 0 1", "900 900 1"));
  const Outcome nifti = runProgram({"voxels", in, "-o", folder.path("a.nii"), "--like", like});
  EXPECT_EQ(nifti.status, 0) << nifti;
  EXPECT_NE(nifti.err.find("that read the qform see voxels up to 0."), std::string::npos) << nifti;
  const Outcome nrrd = runProgram({"voxels", in, "-o", folder.path("a.nrrd"), "--like", like});
  EXPECT_EQ(nrrd.err.find("qform"), std::string::npos) << nrrd;
}

TEST(Like, LabelsKeepTheirNamesWhereTheFormatHasAPlace)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("liver.off", asOff(sphere(1)));
  const std::string other = folder.write("left kidney.off", asOff(sphere(1)));
  const auto labels = [&](const std::string& name)
  {
    const Outcome run = runProgram(
      {"labels", in, other, "-o", folder.path(name), "--resolution", "9", "--overlap", "first"});
    EXPECT_EQ(run.status, 0) << run;
    return run.err;
  };
  labels("a.nrrd");
  const std::string nrrd = contentsOf(folder.path("a.nrrd"));
  EXPECT_NE(nrrd.find("\nSegment0_ID:=Segment_1\nSegment0_Name:=liver\nSegment0_LabelValue:=1\n"),
    std::string::npos);
  EXPECT_NE(nrrd.find("\nSegment1_Name:=left kidney\n"), std::string::npos);
  labels("a.mha");
  EXPECT_NE(
    contentsOf(folder.path("a.mha")).find("\nSegment1_Name = left kidney\n"), std::string::npos);
  EXPECT_NE(labels("a.nii").find("a.nii: NIfTI has no place for the names"), std::string::npos);
  // Both can be read again.
  for (const std::string name : {"a.nrrd", "a.mha"})
  {
    EXPECT_EQ(runProgram({"voxels", in, "-o", folder.path("b.mha"), "--like", folder.path(name),
                           "--overwrite"})
                .status,
      0);
  }
}

TEST(Like, PiecesAndSurfacesLieOnIt)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere()));
  const std::string like = folder.write("head.mha", asMetaImage());
  const std::string vti = folder.path("a.vti"), pieces = folder.path("b.vti");
  ASSERT_EQ(runProgram({"field", in, "-o", vti, "--like", like}).status, 0);
  ASSERT_EQ(runProgram({"field", in, "-o", pieces, "--like", like, "--pieces", "3"}).status, 0);
  vtkNew<vtkXMLImageDataReader> whole, inPieces;
  whole->SetFileName(vti.c_str());
  whole->Update();
  inPieces->SetFileName(pieces.c_str());
  inPieces->Update();
  expectPlace(whole->GetOutput(), false, 1e-12);
  expectPlace(inPieces->GetOutput(), false, 1e-12);
  vtkDataArray* const a = whole->GetOutput()->GetPointData()->GetArray("WindingNumber");
  vtkDataArray* const b = inPieces->GetOutput()->GetPointData()->GetArray("WindingNumber");
  ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(a->GetTuple1(i), b->GetTuple1(i));
  }
  const std::string surface = folder.path("c.vtp");
  ASSERT_EQ(runProgram({"voxels", in, "-o", surface, "--like", like}).status, 0);
  const Outcome check = runProgram({"check", surface, "--json"});
  EXPECT_EQ(check.json()["closed"], true);
  EXPECT_NEAR(check.json()["volume"], 4.1, 0.4) << "outward, though an axis is mirrored";
}

TEST(Like, IsReported)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere()));
  const std::string like = folder.write("head.mha", asMetaImage());
  const Outcome run =
    runProgram({"field", in, "-o", folder.path("a.vti"), "--like", like, "--json"});
  const nlohmann::json grid = run.json()["grid"];
  EXPECT_EQ(grid["dimensions"], nlohmann::json({7, 8, 9}));
  EXPECT_EQ(grid["like"], like);
  EXPECT_EQ(grid["space"], "left-posterior-superior");
  EXPECT_NEAR(grid["origin"][0], voxelOfHead({0, 0, 0})[0], 1e-12);
  EXPECT_EQ(grid["directions"].size(), 9u);
}

TEST(Like, WhatMakesNoSenseIsRefused)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1)));
  const std::string like = folder.write("head.mha", asMetaImage());
  const auto refuses = [&](std::vector<std::string> arguments, int status, const std::string& words)
  {
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, status) << words;
    EXPECT_TRUE(run.saysInOneLine({words})) << words << "\n" << run;
  };
  const std::string vti = folder.path("out.vti"), mha = folder.path("out.mha");
  refuses({"field", in, "-o", vti, "--like", like, "--resolution", "3"}, 1, "excludes");
  refuses(
    {"field", in, "-o", folder.path("out.pvti"), "--like", like}, 2, "would lose the directions");
  refuses({"field", in, "-o", vti, "--like", in}, 2, "is no image to lie on");
  refuses({"field", in, "-o", vti, "--like", folder.path("none.nii")}, 2, "no such file");
  refuses({"field", in, "-o", like, "--like", like}, 2, "the input");
  refuses({"field", in, "-o", mha, "--distance"}, 1, "--distance adds an array");
  refuses({"field", in, "-o", mha, "--inside"}, 1, "--inside adds an array");
  refuses({"field", in, "-o", mha, "--cells"}, 1, "--cells");
  refuses({"field", in, "-o", mha, "--pieces", "2"}, 1, "--pieces");
  refuses({"labels", in, "-o", mha, "--count"}, 1, "--count adds an array");
  refuses({"surface", in, "-o", mha, "--distance"}, 1, "--distance is for surfaces");
  std::string askew = asMetaImage();
  const std::string key = "TransformMatrix = ";
  askew.replace(askew.find(key), key.size(), key + "1 0.1 0 0 1 0 0 0 1\nx = ");
  refuses({"field", in, "-o", vti, "--like", folder.write("askew.mha", askew)}, 2,
    "askew.mha: its axes are not at right angles");
}

TEST(Like, WhatNiftiCannotHoldIsSaidBeforeAnythingIsComputed)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1))), nii = folder.path("out.nii");
  // These voxels would take 400 TB.
  const Outcome large =
    runProgram({"voxels", in, "-o", nii, "--dims", "40000", "10000", "1000000", "--quiet"});
  EXPECT_EQ(large.status, 2);
  EXPECT_TRUE(large.saysInOneLine({nii, "cannot hold 1000000 voxels along an axis"})) << large;
  const auto likeAt = [&](const std::string& first, const std::string& output)
  {
    const std::string head = asMetaImage(), key = "Offset = ";
    const std::size_t at = head.find(key) + key.size();
    const std::string like =
      folder.write("like.mha", head.substr(0, at) + first + head.substr(head.find('\n', at)));
    return runProgram({"voxels", in, "-o", folder.path(output), "--like", like, "--overwrite"});
  };
  // Rounding moves by 0.3 %, 1.8 % and 100 % of a step of 0.25.
  const std::string words = "single precision, which moves voxels by up to";
  EXPECT_EQ(likeAt("10000.2 10000.2 0", "out.nii").err.find(words), std::string::npos);
  const Outcome far = likeAt("100000.2 100000.2 0", "out.nii.gz");
  EXPECT_EQ(far.status, 0);
  EXPECT_NE(far.err.find("out.nii.gz: its places are in " + words), std::string::npos) << far;
  const Outcome farther = likeAt("431257.3 5411768.3 302", "out.nii");
  EXPECT_EQ(farther.status, 2);
  EXPECT_TRUE(farther.saysInOneLine({"out.nii", words, ".nrrd"})) << farther;
  EXPECT_EQ(likeAt("431257.3 5411768.3 302", "out.nrrd").status, 0);
}

} // namespace
