#include "farfield/FarFieldCost.h"
#include "rays/CrossingCost.h"
#include "sums/DirectSumCost.h"

#include <gtest/gtest.h>

using winding::EvaluationCost;
using winding::Primitive;

TEST(EvaluationCost, GrowsWithWhatThereIsToDo)
{
  for (const Primitive kind : {Primitive::triangle, Primitive::point})
  {
    double direct = 0, far = 0;
    for (std::size_t samples = 1000; samples <= 1'000'000'000; samples *= 10)
    {
      const EvaluationCost sum = winding::costOfDirectSum(kind, 10'000, samples);
      const EvaluationCost tree = winding::costOfFarField(kind, 10'000, samples, 5);
      EXPECT_GT(sum.seconds, direct);
      EXPECT_GT(tree.seconds, far);
      EXPECT_GT(tree.bytes, sum.bytes) << "a tree takes memory";
      direct = sum.seconds;
      far = tree.seconds;
    }
    double before = 0;
    for (const int order : {3, 5, 7, 9})
    {
      const double seconds = winding::costOfFarField(kind, 10'000, 1'000'000, order).seconds;
      EXPECT_GT(seconds, before);
      before = seconds;
    }
  }
  for (const std::size_t samples : {1000, 100'000, 1'000'000})
  {
    EXPECT_LT(winding::costOfCrossings(100'000, samples).seconds,
      winding::costOfFarField(Primitive::triangle, 100'000, samples, 5).seconds);
  }
  EXPECT_LT(winding::costOfRows(100'000, 10'000'000).seconds,
    winding::costOfFarField(Primitive::triangle, 100'000, 10'000'000, 3).seconds);
}

TEST(EvaluationCost, HasFewPrimitivesAndFewSamplesSummedDirectly)
{
  for (const Primitive kind : {Primitive::triangle, Primitive::point})
  {
    EXPECT_TRUE(winding::isCheaperDirectly(kind, 1, 5));
    EXPECT_TRUE(winding::isCheaperDirectly(kind, 10, 5));
    EXPECT_FALSE(winding::isCheaperDirectly(kind, 100, 5)) << "measured: from 27 and 37 on";
    EXPECT_FALSE(winding::isCheaperDirectly(kind, 1'000'000, 9));
    EXPECT_TRUE(winding::isCheaperDirectly(kind, 1'000'000, 10, 5)) << "ten samples need no tree";
    EXPECT_FALSE(winding::isCheaperDirectly(kind, 1'000'000, 100'000, 5));
  }
}
