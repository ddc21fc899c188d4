#include "evaluation/confusion.hpp"

#include <cmath>

namespace stillmap {

Percent percent(std::size_t part, std::size_t whole) {
  if (whole == 0) return std::nullopt;
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

Confusion& Confusion::operator+=(const Confusion& other) {
  for (std::size_t column = 0; column < static_.size(); ++column) {
    static_[column] += other.static_[column];
    dynamic_[column] += other.dynamic_[column];
  }
  return *this;
}

Figures Confusion::figures(Uncertain uncertain) const {
  const std::size_t wrong = static_removed(uncertain), right = dynamic_removed(uncertain);
  Figures figures;
  figures.pr = percent(static_points() - wrong, static_points());
  figures.rr = percent(right, dynamic_points());
  if (figures.pr && figures.rr) {
    const double sum = *figures.pr + *figures.rr, product = *figures.pr * *figures.rr;
    figures.score = sum > 0 ? 2 * product / sum : 0.0;
    figures.aa = std::sqrt(product);
  }
  figures.precision = percent(right, right + wrong);
  if (dynamic_points() > 0) figures.iou = percent(right, dynamic_points() + wrong);
  return figures;
}

}  // namespace stillmap
