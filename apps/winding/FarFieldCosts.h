#pragma once

#include "farfield/FarFieldSources.h"

/**
 * @file
 * What the parts of a far field take, each measured alone, on one thread, in seconds. Together with
 * how often each is done (FarFieldWork.h) they explain the time of an evaluation.
 */

/// Of expansions of one order.
struct FarFieldCosts
{
  double nodeTest;        ///< one node by classifyNodes()
  double firstNode;       ///< one node alone by translateMoments()
  double nextNode;        ///< another one in the same batch
  double receiver;        ///< sums of translations cleared and added up
  double shift;           ///< a local expansion for a child
  double polynomial;      ///< a polynomial from a local expansion
  double polynomialValue; ///< of a polynomial at one sample by evaluatePolynomial()
  double row;             ///< of a cell stored row by row
  double rowSample;       ///< a sample in such a row
  double blockSample; ///< a sample of a small cell: its position, the polynomial, and storing it
  double momentValue; ///< one node at one sample by addMomentValues()
  double dipole;      ///< of a node's moments, by addMoments()
};

FarFieldCosts measureFarFieldCosts(int order);

/// Of items that are summed exactly.
struct ExactCosts
{
  double sample; ///< once, whatever the number of items
  double pair;   ///< one item at one sample
};

/// watching: as FarFieldSources::sum() does with isSuspect.
ExactCosts measureExactCosts(const winding::FarFieldSources& sources, bool watching);
