#pragma once

namespace winding
{

/// How refusals speak of what is done.
struct ProbeWords
{
  const char* dataSet; ///< the data set, as a part of a sentence
  const char* remedy;  ///< what to do where memory is short
};

constexpr ProbeWords wordsOfProbe = {
  "the data set to be probed", "probe a part of the data set, or fewer samples"};
constexpr ProbeWords wordsOfClip = {
  "the data set to be clipped", "clip a part of the data set, or a coarser one"};

} // namespace winding
