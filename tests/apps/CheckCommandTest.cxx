#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>

namespace
{

class CheckCommand : public testing::Test
{
protected:
  nlohmann::json check(const std::string& name, const std::string& contents)
  {
    const Outcome run = runProgram({"check", folder.write(name, contents), "--json"});
    EXPECT_EQ(run.status, 0) << run;
    return run.json();
  }

  TemporaryFolder folder;
};

TEST_F(CheckCommand, ClosedSurface)
{
  const nlohmann::json report = check("a.off", asOff(sphere(3)));
  EXPECT_EQ(report["closed"], true);
  EXPECT_EQ(report["euler"], 2);
  EXPECT_NEAR(report["area"], 12.566, 0.3);
  EXPECT_EQ(report["bbox"], nlohmann::json({-1.0, -1.0, -1.0, 1.0, 1.0, 1.0}));
  EXPECT_EQ(report["advice"], "closed: every winding number is an integer");
}

TEST_F(CheckCommand, OpenSurface)
{
  Mesh mesh = sphere(2);
  mesh.triangles.pop_back();
  mesh.triangles.erase(mesh.triangles.begin());
  const nlohmann::json report = check("a.off", asOff(mesh));
  EXPECT_EQ(report["closed"], false);
  EXPECT_EQ(report["boundary_edges"], 6);
  EXPECT_EQ(report["boundary_loops"], 2);
  EXPECT_EQ(report["advice"].get<std::string>().rfind("open: 6 boundary edges in 2 loops", 0), 0u);
}

TEST_F(CheckCommand, FlippedAndDuplicateAndUnusedAndBadTriangles)
{
  Mesh mesh = sphere(2);
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  mesh.triangles.push_back(mesh.triangles[40]);
  mesh.triangles.push_back({7, 7, 8});
  mesh.points.push_back({3, 3, 3});
  mesh.points.push_back({std::nan(""), 0, 0});
  mesh.triangles.push_back({0, 1, static_cast<int>(mesh.points.size()) - 1});
  const nlohmann::json report = check("a.off", asOff(mesh));
  EXPECT_EQ(report["inconsistent_edges"], 3);
  EXPECT_EQ(report["duplicate_faces"], 1);
  EXPECT_EQ(report["nonmanifold_edges"], 3);
  EXPECT_EQ(report["degenerate"], 1);
  EXPECT_EQ(report["unreferenced_vertices"], 1);
  EXPECT_EQ(report["non_finite"], 1);
  EXPECT_EQ(
    report["advice"].get<std::string>().rfind("3 edges are inconsistently oriented", 0), 0u);
}

TEST_F(CheckCommand, Clouds)
{
  const nlohmann::json report =
    check("a.xyz", "0 0 0 0 0 1\n1 0 0 0 0 2\n0 1 0 0 0 0\nnan 0 0 0 0 1\n");
  EXPECT_EQ(report["kind"], "points");
  EXPECT_EQ(report["points"], 4);
  EXPECT_EQ(report["normals"], true);
  EXPECT_EQ(report["non_unit_normals"], 1);
  EXPECT_EQ(report["zero_normals"], 1);
  EXPECT_EQ(report["non_finite"], 1);
  EXPECT_EQ(report["bbox"], nlohmann::json({0.0, 0.0, 0.0, 1.0, 1.0, 0.0}));
  const nlohmann::json bare = check("b.xyz", "0 0 0\n1 0 0\n");
  EXPECT_EQ(bare["normals"], false);
  EXPECT_NE(bare["advice"].get<std::string>().find("vtkPCANormalEstimation"), std::string::npos);
}

TEST_F(CheckCommand, TextEndsWithAdvice)
{
  const Outcome run = runProgram({"check", folder.write("a.off", asOff(sphere(1)))});
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.out.find("\nboundary edges         0\n"), std::string::npos) << run;
  EXPECT_NE(run.out.find("\nclosed: every winding number is an integer\n"), std::string::npos);
}

/// What another program found in the real meshes.
TEST(CheckReference, Manifest)
{
  const std::string shared = WINDING_SHARED_DATA;
  if (!std::filesystem::exists(shared + "/MANIFEST.tsv"))
  {
    GTEST_SKIP() << "there is no " << shared << "/MANIFEST.tsv";
  }
  std::istringstream stream(contentsOf(shared + "/MANIFEST.tsv"));
  const auto row = [&stream]
  {
    std::string line, field;
    std::getline(stream, line);
    std::istringstream fields(line);
    std::vector<std::string> result;
    while (std::getline(fields, field, '\t'))
    {
      result.push_back(field);
    }
    return result;
  };
  const std::vector<std::string> names = row();
  int meshes = 0;
  for (std::vector<std::string> values = row(); !values.empty(); values = row())
  {
    const Outcome run = runProgram({"check", shared + "/" + values[1], "--json"});
    ASSERT_EQ(run.status, 0) << run;
    const nlohmann::json report = run.json();
    ++meshes;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      // "vertices" counts what VTK's OBJ reader makes of corners with different normals, too. The
      // volume of an open surface depends on the origin.
      const bool comparable = report.contains(names[i]) && names[i] != "bbox" &&
                              names[i] != "vertices" &&
                              (names[i] != "volume" || report["closed"] == true);
      if (!comparable)
      {
        continue;
      }
      const nlohmann::json& found = report[names[i]];
      if (names[i] == "volume")
      {
        EXPECT_NEAR(
          found.get<double>(), std::stod(values[i]), 1e-5 * std::abs(std::stod(values[i])));
      }
      else
      {
        EXPECT_EQ(found.is_boolean() ? (found == true ? "yes" : "no") : found.dump(), values[i])
          << names[i] << " of " << values[1];
      }
    }
  }
  EXPECT_EQ(meshes, 18);
}

} // namespace
