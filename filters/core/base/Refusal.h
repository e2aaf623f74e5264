// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"

#include <stdexcept>
#include <utility>

namespace winding
{

/**
 * Thrown where input or parameters cannot be worked with. message() says what is wrong, what to do
 * about it, and where; what() is its sentence without the names of parameters. Nothing is left
 * allocated or changed.
 */
class Refusal : public std::runtime_error
{
public:
  explicit Refusal(Message message)
    : std::runtime_error(sentenceOf(message))
    , message_(std::move(message))
  {
  }

  explicit Refusal(const std::string& sentence)
    : Refusal(Message(sentence))
  {
  }

  const Message& message() const { return message_; }

private:
  Message message_;
};

} // namespace winding
