// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/Sentences.h"

#include <gtest/gtest.h>

#include <stdexcept>

using winding::messageOf;
using winding::Sentence;

TEST(Sentences, HaveTheValuesOfACase)
{
  const winding::Message message = messageOf(Sentence::noLabels, {"{1}", "7.5"});
  EXPECT_EQ(message.fault, "'{1}' is no array of labels") << "texts of values stay as they are";
  EXPECT_EQ(message.facts, "labels are integers from 0 to 65535, and it has the value 7.5");
  ASSERT_EQ(message.remedies.size(), 2u);
  EXPECT_EQ(message.remedies[1].settings[0].parameter, winding::Parameter::byLabel);
  EXPECT_EQ(
    messageOf(Sentence::equalArrayNames, {}).fault, "two arrays of the result are named '{0}'");
}

TEST(Sentences, AreFoundByTheirNames)
{
  EXPECT_EQ(messageOf(std::string("noSource"), {}).fault, messageOf(Sentence::noSource).fault);
  EXPECT_EQ(messageOf(std::string("equalNames"), {"2", "5"}).fault,
    messageOf(Sentence::equalNames, {"2", "5"}).fault);
  EXPECT_THROW(messageOf(std::string("noSuch"), {}), std::out_of_range);
}
