#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "stillmap/types.hpp"

namespace stillmap {

/// How "uncertain" counts. Rows without a verdict are uncertain too.
enum class Uncertain {
  kKept,    ///< only dynamic is removed
  kDropped  ///< only static is kept
};

/// Percent; nothing where the class that it is about is absent.
using Percent = std::optional<double>;

/// The figures of section 2.2 and those that the field uses.
struct Figures {
  Percent pr;         ///< eq. (10): static points kept; SA of the DynamicMap benchmark
  Percent rr;         ///< eq. (11): dynamic points removed; its DA, and the recall of the moving class
  Percent score;      ///< eq. (12): their harmonic mean; its HA
  Percent aa;         ///< their geometric mean
  Percent precision;  ///< of what was removed, the dynamic part
  Percent iou;        ///< of the moving class
};

/// Points by truth and verdict.
class Confusion {
 public:
  void add(bool truth_is_dynamic, Label verdict) {
    const std::size_t column = verdict == Label::kStatic ? 0 : verdict == Label::kDynamic ? 2 : 1;
    ++(truth_is_dynamic ? dynamic_ : static_)[column];
  }
  Confusion& operator+=(const Confusion& other);

  std::size_t static_points() const { return static_[0] + static_[1] + static_[2]; }
  std::size_t dynamic_points() const { return dynamic_[0] + dynamic_[1] + dynamic_[2]; }
  std::size_t points() const { return static_points() + dynamic_points(); }
  std::size_t static_removed(Uncertain uncertain) const { return removed(static_, uncertain); }
  std::size_t dynamic_removed(Uncertain uncertain) const { return removed(dynamic_, uncertain); }

  Figures figures(Uncertain uncertain) const;

 private:
  using Counts = std::array<std::size_t, 3>;  ///< judged static, uncertain, dynamic
  static std::size_t removed(const Counts& counts, Uncertain uncertain) {
    return counts[2] + (uncertain == Uncertain::kDropped ? counts[1] : 0);
  }

  Counts static_{}, dynamic_{};
};

/// 100 part / whole; nothing when the whole is 0.
Percent percent(std::size_t part, std::size_t whole);

}  // namespace stillmap
