// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Fields of tables in quotation marks, which may have anything in them.

#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataReader.h"

#include <gtest/gtest.h>

namespace
{

class QuotedTables : public testing::Test
{
protected:
  Outcome probe(const std::string& queries, const std::string& out) const
  {
    const std::string source = folder.write("source.off", asOff(sphere(1)));
    return runProgram({"probe", source, folder.write("q.csv", queries), "-o", folder.path(out)});
  }

  const TemporaryFolder folder;
};

TEST_F(QuotedTables, RowsOfSeveralLinesAreKeptAsTheyAre)
{
  for (const std::string end : {"\n", "\r\n"})
  {
    const std::string header = "x,y,\"z\",\"a, \"\"note\"\"" + end + "of two lines\"";
    const std::string inside = "0,0,0,\"first" + end + "second, \"\"third\"\"" + end + "\"";
    const std::string outside = "0,0,\"9\", \"\" ";
    const Outcome run = this->probe(header + end + inside + end + outside + end, "out.csv");
    ASSERT_EQ(run.status, 0) << run;
    const std::string text = contentsOf(folder.path("out.csv"));
    EXPECT_EQ(text.rfind(header + ",WindingNumber,Inside" + end + inside + ",1,1" + end, 0), 0u)
      << text;
    EXPECT_NE(text.find(end + outside + ","), std::string::npos) << text;
  }
}

TEST_F(QuotedTables, FieldsBecomeTheTextThatTheyStandFor)
{
  const std::string queries =
    "x,y,z,\"the \"\"name\"\"\"\n0,0,0,\"a\nb, \"\"c\"\"\"\n1,1,1,5\" pipe\n";
  ASSERT_EQ(this->probe(queries, "out.vtp").status, 0);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.path("out.vtp").c_str());
  reader->Update();
  auto* texts = vtkStringArray::SafeDownCast(
    reader->GetOutput()->GetPointData()->GetAbstractArray("the \"name\""));
  ASSERT_NE(texts, nullptr);
  EXPECT_EQ(texts->GetValue(0), "a\nb, \"c\"");
  EXPECT_EQ(texts->GetValue(1), "5\" pipe");
}

/// Lines are counted in the file, not in the table.
TEST_F(QuotedTables, FaultsAreToldByTheirLine)
{
  const Outcome fields = this->probe("x,y,z,t\n0,0,0,\"\n\n\"\n1,1\n", "out.csv");
  EXPECT_EQ(fields.status, 2);
  EXPECT_TRUE(fields.saysInOneLine({"q.csv: line 5: has 2 fields"})) << fields;
  const Outcome open = this->probe("x,y,z,t\n0,0,0,\"\n\n1,1,1,2\n", "out.csv");
  EXPECT_EQ(open.status, 2);
  EXPECT_TRUE(open.saysInOneLine({"q.csv: line 2: a quotation mark is not closed"})) << open;
  const Outcome number = this->probe("x,y,z\n0,0,0\n1,\"a\nb\",1\n", "out.csv");
  EXPECT_EQ(number.status, 2);
  EXPECT_TRUE(number.saysInOneLine({"q.csv: line 3: ", "in column y is no number"})) << number;
}

} // namespace
