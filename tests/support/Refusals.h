// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Refusal.h"
#include "support/Named.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace shapes
{

/// Expects that `work` throws a Refusal in one line, with a mention of a number or of the culprit,
/// and with the name of a parameter where one is given.
template <class Work>
void expectRefused(
  const Work& work, const std::string& mention, std::optional<winding::Parameter> parameter = {})
{
  try
  {
    work();
    ADD_FAILURE() << "not refused, though " << mention;
  }
  catch (const winding::Refusal& refusal)
  {
    const std::string message = refusal.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find(mention), std::string::npos) << message;
    EXPECT_TRUE(!parameter || isNamed(refusal.message(), *parameter)) << message;
  }
}

} // namespace shapes
