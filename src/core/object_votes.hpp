#pragma once

#include <cstdint>

#include "stillmap/types.hpp"

namespace stillmap {

/// What is known of one row of the scan, beside its own label.
struct RowClues {
  bool established = false;  ///< static, on surface known for a while
  bool followed = false;     ///< right beside what moved in the last scans
  bool leaning = false;      ///< more likely dynamic than not
  bool porous = false;       ///< hit again after it was seen through, as leaves are
};

/// Share of static rows that makes the undecided rest of a patch, of an object, static.
inline constexpr float kPatchStatic = 0.5F, kObjectStatic = 0.3F;

/// What the rows of an object, or of a patch of one, say together.
struct Votes {
  int rows = 0, dynamic = 0, is_static = 0;
  int established = 0, followed = 0;
  int tested = 0;    ///< for what stood right before it: those undecided, or only just static
  int vanished = 0;  ///< of them: that, seen from here, is gone
  int leaning = 0;   ///< rows that are dynamic or more likely so than not
  int porous = 0;

  void add(Label label, const RowClues& clues) {
    ++rows;
    dynamic += label == Label::kDynamic;
    is_static += label == Label::kStatic;
    established += clues.established;
    followed += clues.followed;
    leaning += clues.leaning;
    porous += clues.porous;
  }
  void add_test(bool row_vanished) {
    ++tested;
    vanished += row_vanished;
  }
  void add_tests(const Votes& more) {
    tested += more.tested;
    vanished += more.vanished;
  }
  Votes& operator+=(const Votes& more) {
    rows += more.rows;
    dynamic += more.dynamic;
    is_static += more.is_static;
    established += more.established;
    followed += more.followed;
    leaning += more.leaning;
    porous += more.porous;
    add_tests(more);
    return *this;
  }
  /// Rows that its verdict may settle: undecided, or only just static.
  int open() const { return rows - dynamic - established; }
  /// Too much of it is known surface for something that moves.
  bool known_before() const;
  /// Leaves and the like, of which now and then one is seen through.
  bool is_porous() const;
  /// Enough of its rows move for the others to go with them.
  bool enough_move() const;
  /// Enough of it lies right behind what vanished.
  bool replaces_vanished() const;
  /// kObjectMoves, kObjectStands, kReplacedVanished, or kMixedEvidence where there is no clear majority.
  Reason verdict(float static_share) const;
  /// In the end, by what the map says of its rows then: so clearly that the others moved, too.
  bool moved_in_the_end() const;
  /// So clearly moving that rows which only just turned static are taken along.
  bool moves_as_a_whole() const;
};

inline bool moves(Reason verdict) {
  return verdict == Reason::kObjectMoves || verdict == Reason::kReplacedVanished;
}

/// Rows of an object in one cube of 1 m, a patch, that follow each other in the scan: counted and settled
/// together.
struct PatchRun {
  std::uint32_t first, last;  ///< places in Mapper::State::standing_rows
  std::int32_t object;
  std::uint32_t patch;
  std::uint64_t key;  ///< of the patch
  Votes votes;
};

}  // namespace stillmap
