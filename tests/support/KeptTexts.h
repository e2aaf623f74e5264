// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/TableFile.h"

#include <map>
#include <string>
#include <vector>

/// Keeps the texts of a table in vectors.
class KeptTexts final : public winding::TextColumns
{
public:
  void add(std::size_t column, std::size_t rows) override { texts_[column].resize(rows); }
  void set(std::size_t column, std::size_t row, const std::string& text) override
  {
    texts_.find(column)->second[row] = text;
  }

  /// The texts of each column that is one of texts.
  const std::map<std::size_t, std::vector<std::string>>& all() const { return texts_; }

private:
  std::map<std::size_t, std::vector<std::string>> texts_;
};
