// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/Advice.h"

#include "base/Bounds.h"
#include "base/Refusal.h"
#include "report/ExpectedTimeAdvice.h"
#include "source/Sanitize.h"
#include "source/Surface.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{

using shapes::serial;
using winding::CloudReport;
using winding::Parameter;
using Advice = std::vector<winding::Message>;

/// Returns the sentences of advice, one after the other.
std::string textOf(const Advice& advice)
{
  std::string text;
  for (const winding::Message& message : advice)
  {
    text += (text.empty() ? "" : "; ") + winding::sentenceOf(message);
  }
  return text;
}

std::string adviceOnCloud(const CloudReport& report)
{
  return textOf(winding::adviceOn(report));
}

/// Returns the parameters that the first piece of advice names, in their order.
std::vector<Parameter> remediesOf(const Advice& advice)
{
  std::vector<Parameter> found;
  for (const winding::Remedy& remedy : advice.at(0).remedies)
  {
    for (const winding::Setting& setting : remedy.settings)
    {
      found.push_back(setting.parameter);
    }
  }
  return found;
}

const std::vector<Parameter> turned = {
  Parameter::insideRule, Parameter::fixOrientation, Parameter::orientFaces};

Advice on(const winding::Surface& surface)
{
  return winding::adviceOn(
    surface, winding::reportOn(surface, winding::edgesOf(surface, serial), serial));
}

std::string adviceOnSurface(const winding::Surface& surface)
{
  return textOf(on(surface));
}

Advice on(const shapes::Mesh& mesh)
{
  return on(winding::sanitize({mesh.view()}, serial));
}

std::string adviceOnMesh(const shapes::Mesh& mesh)
{
  return textOf(on(mesh));
}

/// A cloud without faults.
CloudReport goodReport()
{
  CloudReport report;
  report.points = report.places = 100;
  report.hasNormals = true;
  report.orientation = {1, 0, 1, 0};
  return report;
}

bool has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

TEST(Advice, OnSurfacesSaysWhetherTheyAreClosed)
{
  EXPECT_EQ(
    adviceOnMesh(shapes::cube()), "nothing to mend; closed: every winding number is an integer");
  EXPECT_EQ(adviceOnMesh(shapes::cube().reversed()),
    "inside out: turn the faces; closed: every winding number is an integer");
  EXPECT_EQ(remediesOf(on(shapes::cube().reversed())), turned);
  const std::string open = adviceOnMesh(shapes::openCube().reversed());
  EXPECT_EQ(open.rfind("inside out", 0), 0u) << open;
  EXPECT_EQ(remediesOf(on(shapes::openCube().reversed())), turned);
  EXPECT_TRUE(has(open, "; open: 4 boundary edges in 1 loop")) << open;
  const shapes::Mesh beside = shapes::openCube().reversed().mapped(
    [](const shapes::Point& p) -> shapes::Point { return p + shapes::Point(5, 0, 0); });
  const std::string both = adviceOnMesh(shapes::cube().with(beside));
  EXPECT_EQ(both.rfind("open: 4 boundary edges", 0), 0u) << both;
  EXPECT_TRUE(has(both, "; 1 of 2 solid parts are inside out")) << both;
  EXPECT_EQ(adviceOnMesh(shapes::openCube()),
    "open: 4 boundary edges in 1 loop; near them winding numbers are between integers, and the "
    "volume is that up to the middle of the bounds");
  EXPECT_TRUE(has(adviceOnMesh(shapes::moebiusStrip(10)), "1 edge is inconsistently oriented"));
  EXPECT_TRUE(remediesOf(on(shapes::moebiusStrip(10))).empty());
  EXPECT_TRUE(has(adviceOnMesh(shapes::Mesh()), "nothing to evaluate"));
}

TEST(Advice, OnSlitsNamesTheirWidthAndWhetherToWeldThem)
{
  const std::string slit = adviceOnMesh(shapes::cubeWithSlit(1e-12));
  EXPECT_EQ(slit, "closed, except for slits of 1e-12: weld points up to 1.1e-12 from each other; 8 "
                  "boundary edges in 2 loops; "
                  "winding numbers are between integers only next to these");
  const std::string inward = adviceOnMesh(shapes::cubeWithSlit(1e-12).reversed());
  EXPECT_EQ(inward, "inside out: turn the faces; " + slit);
  EXPECT_TRUE(has(adviceOnMesh(shapes::cubeWithSlit(0.01)), "open: 8 boundary edges in 2 loops"));
  // One triangle has a point in the middle of an edge that its neighbour does not have.
  shapes::Mesh mesh = shapes::cubeWithSlit(0);
  const auto middle = static_cast<std::int32_t>(mesh.points.size());
  mesh.points.push_back(
    (mesh.points[mesh.triangles[0][0]] + mesh.points[mesh.triangles[0][1]]) / 2);
  const auto [a, b, c] = mesh.triangles[0];
  mesh.triangles[0] = {a, middle, c};
  mesh.triangles.push_back({middle, b, c});
  EXPECT_EQ(adviceOnMesh(mesh),
    "closed, except for slits of 0; 3 boundary edges in 1 loop; winding numbers are between "
    "integers only next to these; points of one side lie on edges of the other, so that welding "
    "leaves slits");
}

TEST(Advice, OnInvertedSolidsWithCavitiesIsToTurnAll)
{
  const shapes::Mesh shell =
    shapes::cube({0, 0, 0}, {3, 3, 3}).with(shapes::cube({1, 1, 1}, {2, 2, 2}).reversed());
  EXPECT_EQ(adviceOnMesh(shell), "nothing to mend; closed: every winding number is an integer");
  EXPECT_EQ(adviceOnMesh(shell.reversed()).rfind("inside out", 0), 0u)
    << adviceOnMesh(shell.reversed());
  EXPECT_EQ(remediesOf(on(shell.reversed())), turned);
}

TEST(Advice, OnSurfacesNamesNonManifoldEdges)
{
  const std::string cubes = adviceOnMesh(shapes::surfaceOf({{0, 0, 0}, {1, 1, 0}}));
  EXPECT_EQ(cubes.rfind("1 edge is non-manifold", 0), 0u) << cubes;
  EXPECT_TRUE(has(cubes, "; closed: every winding number is an integer")) << cubes;
  // Three membranes in one closed rim use every edge three times.
  shapes::Mesh pages{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}}};
  const std::string open = adviceOnMesh(pages);
  EXPECT_EQ(open.rfind("open, though every edge has two triangles or more", 0), 0u) << open;
  EXPECT_TRUE(has(open, "3 edges are non-manifold")) << open;
  EXPECT_TRUE(has(open, "2 triangles repeat others")) << open;
}

TEST(Advice, OnSurfacesCountsWhatIsLeftOut)
{
  shapes::Mesh mesh = shapes::cube();
  mesh.triangles.push_back({0, 1, 99});
  mesh.points.emplace_back(std::nan(""), 0, 0);
  mesh.triangles.push_back({0, 1, 8});
  const winding::Surface surface = winding::sanitize({mesh.view()}, serial);
  EXPECT_EQ(adviceOnSurface(surface),
    "1 triangle is left out for NaN or infinite coordinates; 1 triangle is left out for points "
    "that do not exist; closed: every winding number is an integer");
}

TEST(Advice, OnCloudsSaysWhatTheyLack)
{
  EXPECT_EQ(adviceOnCloud(goodReport()),
    "nothing to mend; oriented points, outward: winding numbers are approximate, and best away "
    "from the points");
  EXPECT_TRUE(has(adviceOnCloud(CloudReport()), "there are no points"));

  CloudReport bare = goodReport();
  bare.hasNormals = false;
  EXPECT_TRUE(has(adviceOnCloud(bare), "no normals")) << adviceOnCloud(bare);
  EXPECT_EQ(remediesOf(winding::adviceOn(bare)),
    (std::vector{Parameter::estimateNormals, Parameter::orientedNormals}));

  CloudReport zero = goodReport();
  zero.zeroNormals = 100;
  EXPECT_EQ(adviceOnCloud(zero).rfind("all normals have length 0", 0), 0u) << adviceOnCloud(zero);
  EXPECT_EQ(remediesOf(winding::adviceOn(zero)).at(0), Parameter::estimateNormals);
  EXPECT_FALSE(has(adviceOnCloud(zero), "left out for normals of length 0")) << "once is enough";

  CloudReport nothing = goodReport();
  nothing.nonFinite = 100;
  EXPECT_EQ(adviceOnCloud(nothing), "nothing to evaluate: all points are NaN or infinite");

  CloudReport heap = goodReport();
  heap.places = 1;
  heap.duplicates = 99;
  EXPECT_TRUE(has(adviceOnCloud(heap), "points at one place"));
  EXPECT_EQ(remediesOf(winding::adviceOn(heap)), std::vector{Parameter::pointArea});
}

TEST(Advice, OnCloudsWarnsOfNormalsThatContradictEachOther)
{
  CloudReport report = goodReport();
  report.oppositeNeighbors = 0.15;
  EXPECT_EQ(adviceOnCloud(report), adviceOnCloud(goodReport()));
  report.oppositeNeighbors = 0.456;
  EXPECT_EQ(adviceOnCloud(report).rfind("46 % of neighbours have opposite normals", 0), 0u);
}

TEST(Advice, OnCloudsSaysWhatTheFieldSaysOfTheirNormals)
{
  CloudReport report = goodReport();
  report.orientation = {0, -1, 0, 0.9};
  EXPECT_EQ(adviceOnCloud(report).rfind("oriented points, but inside out", 0), 0u)
    << adviceOnCloud(report);
  EXPECT_EQ(remediesOf(winding::adviceOn(report)), std::vector{Parameter::insideRule});
  report.orientation = {0.456, -0.543, 0.1, 0.2};
  const std::string unclear = "the field tells inside from outside at 20 % of the points (it is "
                              "mostly 0.46 and -0.54 behind and before them)";
  EXPECT_EQ(adviceOnCloud(report).rfind(unclear, 0), 0u) << adviceOnCloud(report);
}

TEST(Advice, OnCloudsCountsDuplicatesAndWhatIsLeftOut)
{
  CloudReport report = goodReport();
  report.duplicates = 1;
  report.zeroNormals = 2;
  report.nonFinite = 3;
  const std::string advice = adviceOnCloud(report);
  EXPECT_TRUE(has(advice, "; 1 point lies where others do")) << advice;
  EXPECT_TRUE(has(advice, "; 2 points are left out for normals of length 0")) << advice;
  EXPECT_TRUE(has(advice, "; 3 points are left out for NaN or infinite values")) << advice;
}

TEST(Advice, OnCloudsNamesOutliers)
{
  CloudReport report = goodReport();
  report.spacing = {0.9, 1, 1, 90};
  report.bounds = winding::Bounds(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(100, 100, 1));
  EXPECT_EQ(adviceOnCloud(report), adviceOnCloud(goodReport()));
  report.spacing.largest = 110;
  EXPECT_TRUE(has(adviceOnCloud(report), "; at least one point is far from all others"));
  // A gap that is small for the bounds makes no outlier.
  report.bounds.extend(Eigen::Vector3d(1000, 0, 0));
  EXPECT_EQ(adviceOnCloud(report), adviceOnCloud(goodReport()));
}

/// Returns the message by which `work` is refused; an empty one where it is not.
winding::Message refusalOf(const winding::ExpectedWork& work)
{
  try
  {
    winding::expectedTimeAdvice({}, work);
    ADD_FAILURE() << work.seconds << " s are not refused where " << work.limit << " are allowed";
    return {};
  }
  catch (const winding::Refusal& refusal)
  {
    return refusal.message();
  }
}

TEST(Advice, SaysTimesAsPeopleDo)
{
  const std::pair<double, const char*> times[] = {{0.00421, "0.0042 seconds"}, {0.3, "0.3 seconds"},
    {1.02, "1 second"}, {1.5, "1.5 seconds"}, {9.97, "10 seconds"}, {119.4, "119 seconds"},
    {150, "2.5 minutes"}, {6900, "115 minutes"}, {7200, "2 hours"}, {1e7, "116 days"}};
  for (const auto& [seconds, words] : times)
  {
    EXPECT_EQ(refusalOf({seconds, seconds / 2}).fault, std::string("this takes about ") + words);
  }
}

TEST(Advice, AnnouncesMoreThanAMinuteAndRefusesMoreThanTheLimit)
{
  using winding::expectedTimeAdvice;
  EXPECT_FALSE(expectedTimeAdvice({}, {60}));
  EXPECT_FALSE(expectedTimeAdvice({}, {60, 60}));
  EXPECT_TRUE(expectedTimeAdvice({}, {60.1}));
  EXPECT_TRUE(expectedTimeAdvice({}, {70, 70}));
  for (const double limit : {0.5, 60.0, 70.0})
  {
    const winding::Message message = refusalOf({1.01 * limit, limit});
    ASSERT_FALSE(message.remedies.empty());
    EXPECT_EQ(
      message.remedies.back().settings.front().parameter, winding::Parameter::longestExpectedTime);
  }
}
