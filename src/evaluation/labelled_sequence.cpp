#include "evaluation/labelled_sequence.hpp"

#include <filesystem>
#include <random>
#include <stdexcept>
#include <utility>

#include "baselines/removal_method.hpp"
#include "io/semantickitti_folder.hpp"

namespace stillmap {

namespace fs = std::filesystem;

LabelledFolder::LabelledFolder(const std::string& folder)
    : folder_(folder), has_labels_now_(fs::is_directory(fs::path(folder) / "labels_now")) {
  if (!fs::is_directory(folder))
    throw std::runtime_error(folder + ": no such folder; expected a sequence in SemanticKITTI layout");
  scans_ = std::make_unique<SemanticKittiFolder>(folder);
  if (!fs::is_directory(fs::path(folder) / "labels"))
    throw std::runtime_error(folder + ": no folder labels/ in it; figures need the truth of every point");
}

LabelledFrame LabelledFolder::read(std::size_t index) {
  LabelledFrame scan;
  scan.frame = scans_->read(index);
  const auto labels_of = [&](const char* kind) {
    return read_labels((fs::path(folder_) / kind / (scan.frame.name + ".label")).string(),
                       scan.frame.scan.points.size());
  };
  scan.labels = labels_of("labels");
  scan.labels_now = has_labels_now_ ? labels_of("labels_now") : scan.labels;
  return scan;
}

SequencePart::SequencePart(std::unique_ptr<LabelledSequence> whole, const PartOptions& options)
    : whole_(std::move(whole)), options_(options) {
  const auto full = [&] { return options.count > 0 && indices_.size() == options.count; };
  for (std::size_t k = options.first; k < whole_->size() && !full(); k += options.stride)
    indices_.push_back(k);
  if (indices_.empty())
    throw std::runtime_error("the first scan asked for is number " + std::to_string(options.first) +
                             ", but the sequence has only " + std::to_string(whole_->size()) + " scans");
}

LabelledFrame SequencePart::read(std::size_t index) {
  LabelledFrame scan = whole_->read(indices_.at(index));
  if (options_.max_points > 0) thin_out(scan, options_.max_points, options_.seed, indices_[index]);
  return scan;
}

void thin_out(LabelledFrame& scan, std::size_t max_points, std::uint64_t seed, std::size_t scan_number) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < scan.frame.scan.points.size(); ++row)
    if (is_return(scan.frame.scan.points[row])) rows.push_back(row);
  std::seed_seq seeds{seed, static_cast<std::uint64_t>(scan_number)};
  std::mt19937_64 random(seeds);
  LabelledFrame chosen;
  std::size_t wanted = std::min(max_points, rows.size());
  for (std::size_t i = 0; i < rows.size() && wanted > 0; ++i) {
    if (random() % (rows.size() - i) >= wanted) continue;  // selection sampling, Knuth's algorithm S
    --wanted;
    chosen.frame.scan.points.push_back(scan.frame.scan.points[rows[i]]);
    chosen.labels.push_back(scan.labels[rows[i]]);
    chosen.labels_now.push_back(scan.labels_now[rows[i]]);
  }
  scan.frame.scan.points = std::move(chosen.frame.scan.points);
  scan.labels = std::move(chosen.labels);
  scan.labels_now = std::move(chosen.labels_now);
}

}  // namespace stillmap
