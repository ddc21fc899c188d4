// The verdict of an object's rows, as a table.
#include "core/object_votes.hpp"

#include <gtest/gtest.h>

#include "core/joint_verdict.hpp"

namespace stillmap {
namespace {

struct Case {
  const char* what;
  Votes votes;  // rows, dynamic, is_static, established, followed, tested, vanished
  Reason verdict;
};

TEST(Votes, Verdict) {
  const Case cases[] = {
      {"nobody says anything", {100, 0, 0, 0, 0, 0, 0}, Reason::kMixedEvidence},
      {"two rows prove nothing", {2, 2, 0, 0, 0, 0, 0}, Reason::kMixedEvidence},
      {"half of it leans towards moving", {100, 0, 0, 0, 0, 0, 0, 50}, Reason::kObjectMoves},
      {"less than half does", {100, 0, 0, 0, 0, 0, 0, 49}, Reason::kMixedEvidence},
      {"it leans, but it stood there before", {100, 0, 11, 11, 0, 0, 0, 60}, Reason::kMixedEvidence},
      {"all decided rows move", {100, 20, 0, 0, 0, 0, 0}, Reason::kObjectMoves},
      {"under a tenth of the rows moves", {100, 9, 0, 0, 0, 0, 0}, Reason::kMixedEvidence},
      {"ten rows, which are a twentieth", {200, 10, 0, 0, 0, 0, 0}, Reason::kObjectMoves},
      {"ten rows, which are less", {201, 10, 0, 0, 0, 0, 0}, Reason::kMixedEvidence},
      {"60 % of the decided rows move", {30, 18, 12, 0, 0, 0, 0}, Reason::kObjectMoves},
      {"59 % do", {30, 19, 13, 0, 0, 0, 0}, Reason::kMixedEvidence},
      {"many rows, half of the decided", {100, 20, 20, 0, 0, 0, 0}, Reason::kObjectMoves},
      {"less than half of them", {100, 49, 50, 0, 0, 0, 0}, Reason::kMixedEvidence},
      {"half of it follows what moved", {100, 0, 0, 0, 50, 0, 0}, Reason::kObjectMoves},
      {"less than half does", {100, 0, 0, 0, 49, 0, 0}, Reason::kMixedEvidence},
      {"it follows, but it stood there before", {100, 0, 11, 11, 80, 0, 0}, Reason::kMixedEvidence},
      {"it replaced what vanished", {100, 0, 0, 0, 0, 40, 20}, Reason::kReplacedVanished},
      {"a tenth of something large and new did", {100, 0, 10, 0, 0, 60, 6}, Reason::kReplacedVanished},
      {"less than a tenth did", {100, 0, 0, 0, 0, 70, 6}, Reason::kMixedEvidence},
      {"a tenth did, but part of it stands", {100, 0, 11, 0, 0, 60, 10}, Reason::kMixedEvidence},
      {"few rows, half of which found nothing gone", {20, 0, 0, 0, 0, 11, 5}, Reason::kMixedEvidence},
      {"it moves and replaced what vanished", {100, 40, 30, 0, 60, 40, 20}, Reason::kReplacedVanished},
      {"something vanished before known surface", {100, 0, 60, 60, 0, 40, 40}, Reason::kObjectStands},
      {"static rows are enough", {100, 0, 50, 0, 0, 0, 0}, Reason::kObjectStands},
      {"static rows are too few", {100, 0, 49, 0, 0, 0, 0}, Reason::kMixedEvidence},
      {"a tenth of the decided moves", {100, 6, 54, 0, 0, 0, 0}, Reason::kObjectStands},
      {"more than a tenth does", {100, 7, 54, 0, 0, 0, 0}, Reason::kMixedEvidence},
  };
  for (const Case& c : cases) EXPECT_EQ(c.votes.verdict(/*static_share=*/0.5F), c.verdict) << c.what;
}

TEST(Votes, AFewRowsOfWhatStandsDoNotMoveTheirPatch) {
  const Votes standing{1000, 50, 800, 0, 0, 0, 0}, moving{1000, 400, 100, 0, 0, 0, 0};
  const Votes few{100, 20, 0, 0, 0, 0, 0}, many{100, 60, 10, 0, 0, 0, 0}, vanished{100, 20, 0, 0, 0, 40, 30};
  EXPECT_EQ(joint_verdict(few, standing), Reason::kObjectStands);
  EXPECT_EQ(joint_verdict(few, moving), Reason::kObjectMoves);
  EXPECT_EQ(joint_verdict(many, standing), Reason::kObjectMoves);
  EXPECT_EQ(joint_verdict(vanished, standing), Reason::kReplacedVanished);
  EXPECT_EQ(joint_verdict(Votes{100, 0, 0, 0, 0, 0, 0}, moving), Reason::kObjectMoves)
      << "the patch says nothing";
}

TEST(Votes, WhatAPassingThingUncoversOfAKnownObjectStands) {
  const Votes parked{1000, 0, 500, 150, 0, 0, 0}, walker{1000, 0, 500, 100, 0, 0, 0};
  const Votes uncovered{100, 0, 16, 0, 0, 80, 60}, arrived{100, 0, 15, 0, 0, 80, 60};
  EXPECT_EQ(joint_verdict(uncovered, parked), Reason::kObjectStands);
  EXPECT_EQ(joint_verdict(uncovered, walker), Reason::kReplacedVanished) << "nothing there was known before";
  EXPECT_EQ(joint_verdict(arrived, parked), Reason::kReplacedVanished) << "someone walks up to what stands";
}

TEST(Votes, AFewLeavesDoNotMoveTheOthers) {
  const Votes moving{1000, 400, 100, 0, 0, 0, 0};
  Votes leaves{100, 49, 0, 0, 0, 0, 0};
  EXPECT_EQ(joint_verdict(leaves, moving), Reason::kObjectMoves) << "nothing was hit again";
  leaves.porous = 4;
  EXPECT_EQ(joint_verdict(leaves, moving), Reason::kObjectMoves) << "hardly anything was";
  leaves.porous = 5;
  EXPECT_EQ(joint_verdict(leaves, moving), Reason::kMixedEvidence);
  const Votes walker{1000, 400, 100, 0, 200, 0, 0};
  EXPECT_EQ(joint_verdict(leaves, walker), Reason::kObjectMoves) << "someone was seen to move there";
  leaves.dynamic = 50;
  EXPECT_EQ(joint_verdict(leaves, moving), Reason::kObjectMoves) << "someone walks through the bush";
  EXPECT_EQ(joint_verdict(Votes{100, 0, 60, 0, 0, 0, 0, 0, 100}, moving), Reason::kObjectStands);
}

TEST(Votes, MovesAsAWhole) {
  EXPECT_TRUE((Votes{100, 30, 30, 5, 0, 0, 0}.moves_as_a_whole()));
  EXPECT_FALSE((Votes{100, 29, 30, 0, 0, 0, 0}.moves_as_a_whole())) << "no majority";
  EXPECT_FALSE((Votes{100, 30, 30, 6, 0, 0, 0}.moves_as_a_whole())) << "a part of it is long known";
  EXPECT_TRUE((Votes{100, 0, 90, 5, 80, 0, 0}.moves_as_a_whole())) << "it goes where something moved";
  EXPECT_FALSE((Votes{100, 0, 90, 5, 79, 0, 0}.moves_as_a_whole())) << "only in part";
}

TEST(Votes, MovedInTheEnd) {
  EXPECT_TRUE((Votes{75, 30, 10}.moved_in_the_end()));
  EXPECT_FALSE((Votes{75, 30, 11}.moved_in_the_end())) << "too much of it is static";
  EXPECT_FALSE((Votes{76, 30, 10}.moved_in_the_end())) << "hardly anything of it is decided";
  EXPECT_FALSE((Votes{4, 4, 0}.moved_in_the_end())) << "a speck";
}

TEST(Votes, AddCountsARowAndItsClues) {
  Votes votes;
  RowClues clues;
  clues.followed = true;
  votes.add(Label::kDynamic, clues);
  votes.add(Label::kUncertain, RowClues{});
  clues = {};
  clues.established = true;
  votes.add(Label::kStatic, clues);
  EXPECT_EQ(votes.rows, 3);
  EXPECT_EQ(votes.dynamic, 1);
  EXPECT_EQ(votes.is_static, 1);
  EXPECT_EQ(votes.established, 1);
  EXPECT_EQ(votes.followed, 1);
}

}  // namespace
}  // namespace stillmap
