// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/Sentences.h"
#include "Border.h"

using namespace winding::c;

winding_status winding_sentence(const char* sentence, const char* const* values, size_t count,
  const winding_run* run, char* text, size_t size, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      std::vector<std::string> texts;
      for (std::size_t i = 0; i < count; ++i)
      {
        texts.emplace_back(&required((&required(values, "values"))[i], "a value"));
      }
      if (size == 0)
      {
        throw Misuse("text has no room");
      }
      try
      {
        const winding::Message message =
          winding::messageOf(std::string(&required(sentence, "sentence")), texts);
        copyText(winding::lineOf(message, frontEndOf(run)), &required(text, "text"), size);
      }
      catch (const std::out_of_range& unknown)
      {
        throw Misuse(unknown.what());
      }
    });
}
