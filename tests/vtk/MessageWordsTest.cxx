// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/MessageList.h"
#include "vtk/ErrorLog.h"

#include "vtkNew.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberReader.h"
#include "vtkWindingNumberReport.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>

// Every front end has its own names for the same properties. The list of messages holds the words
// of all; these tests see the filters say them.

namespace
{

using Filter = vtkWindingNumberAlgorithm;

/// Returns the only error or warning of a filter that is executed, without VTK's decoration.
template <class Filter> std::string messageOf(Filter* filter, int names)
{
  ErrorLog log(filter);
  filter->SetNamesInMessages(names);
  filter->Update();
  const std::string text = log.errors() + log.warnings();
  const std::size_t begin = text.find("): ");
  return begin == std::string::npos ? text
                                    : text.substr(begin + 3, text.find('\n', begin) - begin - 3);
}

vtkSmartPointer<vtkWindingNumberReader> reading(const std::string& name)
{
  auto reader = vtkSmartPointer<vtkWindingNumberReader>::New();
  reader->SetFileName((WINDING_MESSAGES "/" + name).c_str());
  return reader;
}

/// Returns the message of a field of a mesh or a cloud.
std::string messageOfField(int names, const std::string& file,
  const std::function<void(vtkWindingNumberField*)>& change = {})
{
  vtkNew<vtkWindingNumberField> field;
  field->SetResolution(4);
  field->SetInputConnection(reading(file)->GetOutputPort());
  if (change)
  {
    change(field);
  }
  return messageOf(field.Get(), names);
}

/// Returns what the filters say in each of the cases of the list.
std::map<std::string, std::string> allMessages(int names)
{
  std::map<std::string, std::string> found;
  found["points without normals"] = messageOfField(names, "bare.xyz");
  found["bounds of a single point"] = messageOfField(names, "place.xyz");
  found["a method that points do not have"] = messageOfField(names, "place.xyz",
    [](auto* field)
    {
      field->SetMethod(Filter::PARITY);
      field->UseInputBoundsOff();
    });
  found["a number out of range"] =
    messageOfField(names, "cube.off", [](auto* field) { field->SetPadding(-1); });
  found["mirror planes at an angle"] =
    messageOfField(names, "cube.off", [](auto* field) { field->SetMirror("y=0; 1 1 0 = 0"); });
  found["lines next to faces"] = messageOfField(names, "loose.off");
  found["normals of length 0"] = messageOfField(names, "zeros.xyz");
  found["normals that are equal"] = messageOfField(names, "equal.xyz");
  found["normals where others are wanted"] =
    messageOfField(names, "octahedron.xyz", [](auto* field) { field->EstimateNormalsOn(); });
  const std::string ofReader = messageOf(reading("colours.xyz").Get(), names);
  found["columns of colours"] = ofReader.substr(ofReader.find(": ") + 2);
  found["too many voxels"] =
    messageOfField(names, "cube.off", [](auto* field) { field->SetVoxelSize(1e-12); });
  found["faces that look inward"] = messageOfField(names, "inward.off");
  vtkNew<vtkWindingNumberReport> report;
  report->SetInputConnection(reading("inward.off")->GetOutputPort());
  report->SetNamesInMessages(names);
  report->Update();
  found["the report on faces that look inward"] = report->GetAdvice();
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputConnection(reading("cube.off")->GetOutputPort());
  surface->SetResolution(4);
  surface->UseInputBoundsOff();
  surface->SetSamplingBounds(0.4, 0.6, 0.4, 0.6, 0.4, 0.6);
  found["a solid that is closed at the border"] = messageOf(surface.Get(), names);
  surface->MendSourceOff();
  found["a grid within the solid"] = messageOf(surface.Get(), names);
  vtkNew<vtkWindingNumberSurface> turned;
  turned->SetInputConnection(reading("inward.off")->GetOutputPort());
  turned->SetResolution(4);
  found["faces that are turned"] = messageOf(turned.Get(), names);
  return found;
}

class MessageWords : public testing::TestWithParam<std::pair<const char*, int>>
{
};

TEST_P(MessageWords, AreThoseOfTheList)
{
  const auto [frontEnd, names] = GetParam();
  const auto expected = messagesOf(frontEnd);
  auto found = allMessages(names);
  if (names == Filter::PARAVIEW_NAMES)
  {
    // Panels ask for estimates from the beginning, so that nobody is told of normals that are kept.
    found.erase("normals where others are wanted");
  }
  EXPECT_EQ(expected.size(), found.size());
  for (const auto& [subject, message] : found)
  {
    const auto line = expected.find(subject);
    EXPECT_NE(line, expected.end()) << subject << "\n  " << frontEnd << ": " << message;
    if (line == expected.end())
    {
      continue;
    }
    // Program and package check numbers before filters do, in words of their own.
    if (subject != "a number out of range" || names <= Filter::PARAVIEW_NAMES)
    {
      EXPECT_EQ(message, line->second) << subject;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(FrontEnds, MessageWords,
  testing::Values(std::pair("C++", Filter::CXX_NAMES),
    std::pair("ParaView", Filter::PARAVIEW_NAMES), std::pair("program", Filter::PROGRAM_NAMES),
    std::pair("Python", Filter::PYTHON_NAMES)));

/// ParaView shows about 80 characters of a message: what is wrong, and the first box to use.
TEST(MessagesInParaView, BeginWithWhatIsWrongAndABox)
{
  for (const auto& [subject, line] : messagesOf("ParaView"))
  {
    const std::string fault = line.substr(0, line.find(": "));
    EXPECT_LE(std::count(fault.begin(), fault.end(), ' '), 8) << line;
    EXPECT_EQ(line.find("--"), std::string::npos) << line;
    EXPECT_EQ(line.find("()"), std::string::npos) << line;
  }
}

} // namespace
