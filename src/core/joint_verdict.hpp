#pragma once

#include "object_votes.hpp"

namespace stillmap {

/// In an object that was known before, what went by uncovers what it had hidden: that stands, unless hardly a
/// row of it has been static yet.
inline bool was_uncovered(const Votes& patch, const Votes& object) {
  constexpr float kHardlyAny = 0.15F;
  return object.known_before() &&
         static_cast<float>(patch.is_static) > kHardlyAny * static_cast<float>(patch.rows);
}

/// What an object and its patch say of the rows that are not decided, the patch first. Where the object
/// mostly stands, a patch moves only by at least half of all its rows: beams that slip by what is thin or
/// porous make a few rows of it dynamic, and those do not speak for the others. Neither do they in a patch
/// that is itself porous, unless a fifth of the object goes where something moved in the last
/// scans.
inline Reason joint_verdict(const Votes& patch, const Votes& object) {
  const bool by_few = patch.dynamic * 2 < patch.rows;
  const bool object_stands = object.dynamic < object.is_static;
  const Reason of_patch = patch.verdict(kPatchStatic);
  const bool counts = of_patch == Reason::kObjectMoves        ? !by_few || !object_stands
                      : of_patch == Reason::kReplacedVanished ? !was_uncovered(patch, object)
                                                              : true;
  const bool goes_on = object.followed * 5 >= object.rows;
  const Reason together =
      counts && of_patch != Reason::kMixedEvidence ? of_patch : object.verdict(kObjectStatic);
  return together == Reason::kObjectMoves && by_few && patch.is_porous() && !goes_on ? Reason::kMixedEvidence
                                                                                     : together;
}

}  // namespace stillmap
