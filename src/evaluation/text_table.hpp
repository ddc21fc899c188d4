#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stillmap {

/// A table of text cells, written as Markdown or CSV.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> header) : header_(std::move(header)) {}

  /// Throws std::logic_error when there is not one cell for each column.
  void add_row(std::vector<std::string> cells);
  bool empty() const { return rows_.empty(); }

  std::string markdown() const;
  std::string csv() const;

 private:
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
};

/// "93.94"; "not defined" where there is no value.
std::string cell(const std::optional<double>& value, int decimals = 2);
std::string cell(double value, int decimals = 2);

}  // namespace stillmap
