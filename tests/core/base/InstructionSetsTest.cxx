// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Views.h"
#include "source/PointCloud.h"
#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "sums/ReferenceSum.h"
#include "support/FarFields.h"
#include "support/Samples.h"
#include "support/Serial.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <bitset>

/**
 * @file
 * Kernels are chosen by what the processor can do. These tests take each choice that there is on
 * the machine at hand.
 */
namespace
{

using namespace shapes;

/// Makes kernels use one instruction set until the end of the test.
class InstructionSets : public testing::Test
{
protected:
  ~InstructionSets() override { this->use(0); }

  /// Chooses an instruction set (hwy/targets.h); 0 chooses the best.
  void use(std::int64_t target)
  {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

} // namespace

TEST_F(InstructionSets, AllKeepTheirPromises)
{
  SCOPED_TRACE("seeds 601, 602");
  const winding::Surface surface = clean(icosphere(3).part(0, 1000));
  const winding::PointCloud cloud = clean(randomCloud(2000, 601));
  const std::vector<double> areas(cloud.positions.size(), 0.01);
  const std::vector<Point> samples = randomPoints(3000, -1.2, 1.2, 602);
  winding::PointCloud regularized = cloud;
  regularized.regularizationLengths.assign(cloud.positions.size(), 0.1);
  std::vector<double> exact, exactOfCloud, exactOfRegularized;
  std::vector<Point> gradients;
  for (const Point& q : samples)
  {
    exact.push_back(winding::referenceSum<double>(surface, q));
    exactOfCloud.push_back(winding::referenceSum<double>(cloud, areas, q));
    exactOfRegularized.push_back(winding::referenceSum<double>(regularized, areas, q));
  }
  const winding::VectorsView view(samples[0].data(), samples.size());
  std::vector<double> values(samples.size());
  winding::FieldOutput output;
  output.doubleValues = values.data();

  const std::int64_t all = hwy::SupportedTargets();
  int tried = 0;
  for (std::int64_t target = 1; target > 0 && target <= all; target <<= 1)
  {
    if ((all & target) == 0)
    {
      continue;
    }
    this->use(target);
    SCOPED_TRACE(hwy::TargetName(target));
    ++tried;
    EXPECT_LT(largestDifference(valuesOf(winding::TriangleSum(surface), samples), exact), 1e-12);
    EXPECT_LT(
      largestDifference(valuesOf(winding::DipoleSum(cloud, areas), samples), exactOfCloud), 1e-11);
    const winding::DipoleSum ofRegularized(regularized, areas);
    EXPECT_LT(largestDifference(valuesOf(ofRegularized, samples), exactOfRegularized), 1e-12);
    const std::vector<Point> found = gradientsOf(ofRegularized, samples);
    gradients = gradients.empty() ? found : gradients;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      // The expected gradients come from the first instruction set; RegularizationTest.cxx
      // compares with the right ones.
      ASSERT_LT((found[i] - gradients[i]).norm(), 1e-11);
    }
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
    {
      const winding::FarFieldAccuracy accuracy = winding::FarFieldAccuracy::of(tolerance);
      const auto evaluate = [&](std::unique_ptr<winding::FarFieldSources> sources)
      {
        winding::FarField(std::move(sources), accuracy, serial).evaluate(view, output, serial);
      };
      evaluate(
        winding::farFieldSources(surface.vertices, surface.triangles, surface.bounds, {}, serial));
      EXPECT_LT(largestDifference(values, exact), tolerance);
      evaluate(winding::farFieldSources(cloud, areas, serial));
      // Values are large near points, and so is their rounding to float.
      EXPECT_LT(largestDifference(values, exactOfCloud), tolerance + 1e-5); // measured: 5.5e-6
      evaluate(winding::farFieldSources(regularized, areas, serial));
      EXPECT_LT(largestDifference(values, exactOfRegularized), tolerance);
    }
  }
  record("instructionSets", tried);
  EXPECT_GE(tried, 1);
}
