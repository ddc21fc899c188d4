#pragma once

#include "stillmap/types.hpp"

namespace stillmap {

/// What objects.cpp found out about one row of the scan, beside its own label.
struct RowClues {
  bool ground = false;       ///< lies on the ground: never part of an object
  bool established = false;  ///< static, on surface known for a while
  bool followed = false;     ///< right beside what moved in the last scans
  bool tested = false;       ///< the vanish test was made: the row is undecided, or only just static
  bool leaning = false;      ///< more likely dynamic than not
  bool vanished = false;     ///< what stood right before it, seen from here, is gone
};

/// Share of static rows that makes the undecided rest of a patch, of an object, static.
inline constexpr float kPatchStatic = 0.5F, kObjectStatic = 0.3F;

/// What the rows of an object, or of a patch of one, say together.
struct Votes {
  int rows = 0, dynamic = 0, is_static = 0;
  int established = 0, followed = 0, tested = 0, vanished = 0;
  int leaning = 0;  ///< rows that are dynamic or more likely so than not

  void add(Label label, const RowClues& clues) {
    ++rows;
    dynamic += label == Label::kDynamic;
    is_static += label == Label::kStatic;
    established += clues.established;
    followed += clues.followed;
    leaning += clues.leaning;
  }
  Votes& operator+=(const Votes& more) {
    rows += more.rows;
    dynamic += more.dynamic;
    is_static += more.is_static;
    established += more.established;
    followed += more.followed;
    leaning += more.leaning;
    tested += more.tested;
    vanished += more.vanished;
    return *this;
  }
  void add_vanish_test(bool row_vanished) {
    ++tested;
    vanished += row_vanished;
  }
  /// Too much of it is known surface for something that moves.
  bool known_before() const;
  /// Enough of it lies right behind what vanished.
  bool replaces_vanished() const;
  /// kObjectMoves, kObjectStands, kReplacedVanished, or kMixedEvidence where there is no clear majority.
  Reason verdict(float static_share) const;
  /// So clearly moving that rows which only just turned static are taken along.
  bool moves_as_a_whole() const;
};

inline bool moves(Reason verdict) {
  return verdict == Reason::kObjectMoves || verdict == Reason::kReplacedVanished;
}

}  // namespace stillmap
