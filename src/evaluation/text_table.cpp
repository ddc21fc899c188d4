#include "evaluation/text_table.hpp"

#include <cstdio>
#include <stdexcept>

namespace stillmap {
namespace {

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + quoted(cell);
  return line + "\n";
}

std::string markdown_line(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

}  // namespace

void TextTable::add_row(std::vector<std::string> cells) {
  if (cells.size() != header_.size())
    throw std::logic_error("a row of " + std::to_string(cells.size()) + " cells in a table of " +
                           std::to_string(header_.size()) + " columns");
  rows_.push_back(std::move(cells));
}

std::string TextTable::markdown() const {
  std::string text = markdown_line(header_) + "|";
  for (std::size_t column = 0; column < header_.size(); ++column) text += "---|";
  text += "\n";
  for (const auto& row : rows_) text += markdown_line(row);
  return text;
}

std::string TextTable::csv() const {
  std::string text = csv_line(header_);
  for (const auto& row : rows_) text += csv_line(row);
  return text;
}

std::string cell(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", decimals, value);
  return text;
}

std::string cell(const std::optional<double>& value, int decimals) {
  return value ? cell(*value, decimals) : "not defined";
}

}  // namespace stillmap
