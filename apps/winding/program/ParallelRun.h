// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "program/Failure.h"

#include <cstddef>
#include <functional>
#include <vector>

/// A Failure that all ranks have thrown at the same place, so that none waits for another.
class AgreedFailure : public Failure
{
public:
  using Failure::Failure;
};

/**
 * @file
 * The program as one of several ranks under mpirun, through VTK's controller for MPI. A program
 * that mpirun has not started, or only once, is a single rank: it starts no MPI, and all of these
 * functions do nothing but the work that they are given. Functions that are collective are called
 * by all ranks, in the same order. They have the names that `Ranks.h` of the filters has.
 */
namespace parallel
{

/// Starts MPI where mpirun has started several ranks. Throws Failure where the program was built
/// without MPI, on the first rank only; the other ranks end there.
void start(int& argc, char**& argv);

/// Ends MPI on a rank that does not leave others waiting. Collective.
void finish();

int count();
int rank();
bool isFirst();
bool isAlone();

/// The ranks on this machine, this one among them.
int countOnHost();

/// Does work on every rank. Where it throws on any, or a signal has come to any, all throw an
/// AgreedFailure with the status and the line of the first of them. Collective; work may be
/// collective, too, and agree on failures of its own. A single rank throws what work throws.
void agree(const std::function<void()>& work);

/// Does work on the first rank only, and agrees as agree() does. Collective.
void agreeOnFirst(const std::function<void()>& work);

/// Waits for all ranks. Collective.
void barrier();

///@{
/// Returns a number of each rank, rank by rank; the largest of them; their sum. Collective.
std::vector<double> allGather(double own);
double maximum(double own);
double sum(double own);
///@}

///@{
/// Bytes go from one rank to another. Both call it, with the same number of bytes.
void send(const void* from, std::size_t bytes, int toRank);
void receive(void* to, std::size_t bytes, int fromRank);
///@}

} // namespace parallel
