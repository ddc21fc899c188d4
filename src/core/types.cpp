#include "stillmap/types.hpp"

#include "stillmap/mapper.hpp"

namespace stillmap {

const char* to_string(Label label) {
  switch (label) {
    case Label::kUncertain:
      return "uncertain";
    case Label::kStatic:
      return "static";
    case Label::kDynamic:
      return "dynamic";
    case Label::kInvalid:
      return "invalid";
  }
  return "?";
}

const char* to_string(Reason reason) {
  switch (reason) {
    case Reason::kNoReturn:
      return "no return";
    case Reason::kOutOfRange:
      return "out of range";
    case Reason::kNeverJudged:
      return "never judged";
    case Reason::kMixedEvidence:
      return "mixed evidence";
    case Reason::kSupported:
      return "supported";
    case Reason::kSeenThroughNow:
      return "seen through by this scan";
    case Reason::kSeenThrough:
      return "seen through by earlier scans";
    case Reason::kObjectMoves:
      return "belongs to an object that moves";
    case Reason::kObjectStands:
      return "belongs to a surface that stands";
    case Reason::kReplacedVanished:
      return "behind surface that vanished";
    case Reason::kSeenThroughLater:
      return "seen through by later scans";
  }
  return "?";
}

const char* to_string(Stage stage) {
  switch (stage) {
    case Stage::kRangeImage:
      return "range_image";
    case Stage::kInsertion:
      return "insertion";
    case Stage::kEvidence:
      return "evidence";
    case Stage::kReplay:
      return "replay";
    case Stage::kDecision:
      return "decision";
    case Stage::kObjects:
      return "objects";
    case Stage::kUpkeep:
      return "upkeep";
  }
  return "?";
}

LabelCounts count(const ScanLabels& labels) {
  LabelCounts counts;
  for (const Label label : labels.label) {
    counts.uncertain += label == Label::kUncertain;
    counts.is_static += label == Label::kStatic;
    counts.dynamic += label == Label::kDynamic;
    counts.invalid += label == Label::kInvalid;
  }
  return counts;
}

}  // namespace stillmap
