#include "support_table.hpp"

#include <algorithm>

namespace stillmap {
namespace {

/// The last one is that of a return: support at every level, at the largest rate.
std::vector<SupportTable> tables_by_rank(const std::vector<LevelModel>& models, const Recursion& recursion) {
  std::vector<float> eta(1, 0.0F);
  for (const LevelModel& model : models) {
    const auto rank = static_cast<std::size_t>(model.support_rank);
    eta.resize(std::max(eta.size(), rank + 1));
    eta[rank] = model.eta;
  }
  std::vector<SupportTable> tables;
  tables.reserve(eta.size());
  for (const float rate : eta) tables.emplace_back(rate, models.front().eta_when_dynamic, recursion);
  return tables;
}

}  // namespace

SupportTables::SupportTables(const std::vector<LevelModel>& models, const Recursion& recursion,
                             bool full_on_return)
    : by_rank_(tables_by_rank(models, recursion)),
      returned_(full_on_return ? SupportTable(models.front().eta, models.front().eta, recursion)
                               : by_rank_.back()) {}

}  // namespace stillmap
