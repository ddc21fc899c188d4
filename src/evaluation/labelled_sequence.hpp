#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/sequence.hpp"

namespace stillmap {

/// A scan with its truth, one SemanticKITTI label for each row.
struct LabelledFrame {
  Frame frame;
  std::vector<std::uint32_t> labels;      ///< moving if the thing ever moves: for the final map
  std::vector<std::uint32_t> labels_now;  ///< moving if it has moved by now: for verdicts at once
};

class LabelledSequence {
 public:
  virtual ~LabelledSequence() = default;
  virtual std::size_t size() const = 0;
  /// Throws std::runtime_error naming the file, what was seen and what to do.
  virtual LabelledFrame read(std::size_t index) = 0;
};

/// A SemanticKITTI folder with labels/ and, where the truth depends on time, labels_now/.
class LabelledFolder : public LabelledSequence {
 public:
  explicit LabelledFolder(const std::string& folder);
  std::size_t size() const override { return scans_->size(); }
  LabelledFrame read(std::size_t index) override;

 private:
  std::string folder_;
  bool has_labels_now_;
  std::unique_ptr<Sequence> scans_;
};

/// Which scans of a sequence to use, and how many points of each.
struct PartOptions {
  std::size_t first = 0;
  std::size_t count = 0;  ///< 0 = to the end
  std::size_t stride = 1;
  std::size_t max_points = 0;  ///< a random choice of so many returns of each scan; 0 = all rows
  std::uint64_t seed = 7;
};

class SequencePart : public LabelledSequence {
 public:
  /// Throws std::runtime_error when the sequence ends before the first scan of the part.
  SequencePart(std::unique_ptr<LabelledSequence> whole, const PartOptions& options);
  std::size_t size() const override { return indices_.size(); }
  LabelledFrame read(std::size_t index) override;

 private:
  std::unique_ptr<LabelledSequence> whole_;
  PartOptions options_;
  std::vector<std::size_t> indices_;
};

/// Keeps `max_points` returns of a scan, in their order; the choice depends on seed and scan number only.
void thin_out(LabelledFrame& scan, std::size_t max_points, std::uint64_t seed, std::size_t scan_number);

}  // namespace stillmap
