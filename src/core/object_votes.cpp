#include "object_votes.hpp"

#include <algorithm>

namespace stillmap {
namespace {

constexpr int kFew = 3;  // rows that prove nothing

}  // namespace

bool Votes::known_before() const {
  constexpr float kHardlyAny = 0.1F;
  return static_cast<float>(established) > kHardlyAny * static_cast<float>(rows);
}

bool Votes::is_porous() const {
  constexpr float kSome = 0.05F;
  return porous > 0 && static_cast<float>(porous) >= kSome * static_cast<float>(rows);
}

Reason Votes::verdict(float static_share) const {
  constexpr float kStaticMajority = 0.9F, kHalf = 0.5F;
  const auto decided = static_cast<float>(dynamic + is_static);
  const auto all = static_cast<float>(rows);
  // First, for it is a sighting of its own: it takes along what only just turned static, and is followed.
  if (replaces_vanished()) return Reason::kReplacedVanished;
  if (enough_move()) return Reason::kObjectMoves;
  if (leaning >= kFew && leaning >= kHalf * all && !known_before()) return Reason::kObjectMoves;
  if (followed >= kFew && followed >= kHalf * all && !known_before()) return Reason::kObjectMoves;
  if (is_static >= static_share * all && is_static >= kStaticMajority * decided) return Reason::kObjectStands;
  return Reason::kMixedEvidence;
}

// The more rows move, the less it takes that so many are no accident.
bool Votes::enough_move() const {
  constexpr int kSeveral = 10, kMany = 20;
  const float of_all = dynamic >= kSeveral ? 0.05F : 0.1F, of_decided = dynamic >= kMany ? 0.5F : 0.6F;
  return dynamic >= kFew && static_cast<float>(dynamic) >= of_all * static_cast<float>(rows) &&
         static_cast<float>(dynamic) >= of_decided * static_cast<float>(dynamic + is_static);
}

// Hardly a return of what stands passes the vanish test: of something large and new, a tenth is enough.
bool Votes::replaces_vanished() const {
  constexpr int kSeveral = 6;
  constexpr float kTenth = 0.1F, kHalf = 0.5F;
  const auto share = static_cast<float>(vanished) / static_cast<float>(std::max(1, tested));
  if (known_before() || vanished < kFew) return false;
  const bool is_new = static_cast<float>(is_static) <= kTenth * static_cast<float>(rows);
  return share >= kHalf || (is_new && vanished >= kSeveral && share >= kTenth);
}

bool Votes::moved_in_the_end() const {
  constexpr int kSeveral = 5;
  constexpr float kOfDecided = 0.75F, kOfAll = 0.4F;
  return dynamic >= kSeveral &&
         static_cast<float>(dynamic) >= kOfDecided * static_cast<float>(dynamic + is_static) &&
         static_cast<float>(dynamic) >= kOfAll * static_cast<float>(rows);
}

bool Votes::moves_as_a_whole() const {
  constexpr float kNone = 0.05F, kMajority = 0.5F, kNearlyAll = 0.8F;
  const auto all = static_cast<float>(rows);
  if (static_cast<float>(established) > kNone * all) return false;
  return dynamic >= kMajority * static_cast<float>(dynamic + is_static) ||
         (followed >= kFew && followed >= kNearlyAll * all);
}

}  // namespace stillmap
