#include "object_votes.hpp"

namespace stillmap {
namespace {

constexpr int kFew = 3;  // rows that prove nothing

}  // namespace

bool Votes::known_before() const {
  constexpr float kHardlyAny = 0.1F;
  return static_cast<float>(established) > kHardlyAny * static_cast<float>(rows);
}

Reason Votes::verdict(float static_share) const {
  constexpr float kDynamicShare = 0.1F, kDynamicMajority = 0.6F, kStaticMajority = 0.9F;
  constexpr float kHalf = 0.5F;
  const auto decided = static_cast<float>(dynamic + is_static);
  const auto all = static_cast<float>(rows);
  if (dynamic >= kFew && dynamic >= kDynamicShare * all && dynamic >= kDynamicMajority * decided)
    return Reason::kObjectMoves;
  if (leaning >= kFew && leaning >= kHalf * all && !known_before()) return Reason::kObjectMoves;
  if (followed >= kFew && followed >= kHalf * all && !known_before()) return Reason::kObjectMoves;
  if (vanished >= kFew && vanished >= kHalf * static_cast<float>(tested) && !known_before())
    return Reason::kReplacedVanished;
  if (is_static >= static_share * all && is_static >= kStaticMajority * decided) return Reason::kObjectStands;
  return Reason::kMixedEvidence;
}

bool Votes::moves_as_a_whole() const {
  constexpr float kNone = 0.05F, kMajority = 0.5F, kNearlyAll = 0.8F;
  const auto all = static_cast<float>(rows);
  if (static_cast<float>(established) > kNone * all) return false;
  return dynamic >= kMajority * static_cast<float>(dynamic + is_static) ||
         (followed >= kFew && followed >= kNearlyAll * all);
}

}  // namespace stillmap
