// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/Options.h"

#include <CLI/CLI.hpp>

#include <string>
#include <utility>
#include <vector>

/**
 * @file
 * Options that several commands have. Each function adds some of them to a command, whose name may
 * show in their descriptions.
 */

/// The words that an option takes, and the numbers that they stand for.
using Choices = std::vector<std::pair<std::string, int>>;

/// Turns a word into its number. The validator's name is all the words, with blanks between them.
/// (CLI11's own transformer would take numbers too, and say less.)
CLI::Validator oneOf(const Choices& choices);

/// The words for the inside rules.
CLI::Validator rules();

/// Adds one or several inputs. They are a solid each for labels and booleans, and one source for
/// others.
void addInputs(CLI::App* command, Options& options);

/// Adds inputs that are one source, and behind them the file of queries.
void addInputsAndQueries(CLI::App* command, Options& options);
void addOutput(CLI::App* command, Options& options, const std::string& suffixes);

/// Adds `--overwrite`.
void addOverwrite(CLI::App* command, Options& options);

/// Adds the input of commands that work on points: a mesh is one of its points there.
void addPointsInput(CLI::App* command, Options& options);

/// Adds how the areas of points are found, by the words that the command takes, from how many
/// neighbours, and how normals are estimated.
void addPointAreas(
  CLI::App* command, Options& options, const std::string& description, const Choices& methods);

/// Adds which cells of a mesh are its surface.
void addSurfaceCells(CLI::App* command, Options& options);

/// Adds what a surface lacks by its owner's word.
void addCompletion(CLI::App* command, Options& options);
void addMethod(CLI::App* command, Options& options);

/// Adds `--as-is`, for commands that make solids.
void addMending(CLI::App* command, Options& options);

/// Adds the options of commands that make a field: grid, method and verification.
void addFieldOptions(CLI::App* command, Options& options);

void addThreshold(CLI::App* command, Options& options);

/// Adds how a surface is made: edges of its source, the border of the grid, and the precision.
void addFeatures(CLI::App* command, Options& options);

/// Adds how a surface is compared with its source.
void addShape(CLI::App* command, Options& options);
void addComparison(CLI::App* command, Options& options);

void addNearestCells(CLI::App* command, Options& options);

/// Adds what a surface takes over from its source.
void addNearest(CLI::App* command, Options& options);
void addCoverage(CLI::App* command, Options& options);
void addDistance(CLI::App* command, Options& options);
void addArrayName(CLI::App* command, Options& options);

void addThreads(CLI::App* command, Options& options);
void addLongestTime(CLI::App* command, Options& options);
void addReporting(CLI::App* command, Options& options);
