// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "farfield/FarFieldSources.h"

/**
 * @file
 * Costs are the times that the parts of a far field take, each measured alone, on one thread, in
 * processor seconds. Together with how often each is done (FarFieldWork.h) they explain the time of
 * an evaluation.
 */

/// Costs of expansions of one order.
struct FarFieldCosts
{
  double nodeTest;        ///< test of one node by classifyNodes()
  double firstNode;       ///< translation of one node alone by translateMoments()
  double nextNode;        ///< translation of one more node in the same batch
  double receiver;        ///< clearing the sums of translations and adding them up, for a cell
  double shift;           ///< shift of a local expansion to a child
  double polynomial;      ///< conversion of a local expansion to a polynomial
  double polynomialValue; ///< value of a polynomial at one sample by evaluatePolynomial()
  double row;             ///< start of a row, in a cell that is stored row by row
  double rowSample;       ///< one sample in such a row
  double blockSample;     ///< one sample of a small cell: position, polynomial and storing
  double momentValue;     ///< value of a node's moments at one sample by addMomentValues()
  double dipole;          ///< addition of one dipole to a node's moments by addMoments()
};

FarFieldCosts measureFarFieldCosts(int order);

/// Costs of items that are summed exactly.
struct ExactCosts
{
  double sample; ///< cost of a sample, whatever the number of items
  double pair;   ///< cost of one item at one sample
};

/// watching says whether to sum as FarFieldSources::sum() does when it gets isSuspect.
ExactCosts measureExactCosts(const winding::FarFieldSources& sources, bool watching);
