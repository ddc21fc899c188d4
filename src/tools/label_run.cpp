#include "tools/label_run.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "io/map_file.hpp"
#include "io/read_ahead.hpp"
#include "io/tile_folder.hpp"
#include "io/whole_map.hpp"
#include "io/write_behind.hpp"
#include "stillmap/delayed_labels.hpp"
#include "stillmap/mapper.hpp"
#include "tools/label_store.hpp"
#include "tools/progress_bar.hpp"
#include "tools/run_summary.hpp"
#include "tools/say.hpp"

namespace stillmap {
namespace {

namespace fs = std::filesystem;

std::vector<std::size_t> chosen_scans(std::size_t size, const LabelJob& job) {
  std::vector<std::size_t> indices;
  for (std::size_t k = job.from; k < size && (job.scans == 0 || indices.size() < job.scans); k += job.stride)
    indices.push_back(k);
  if (indices.empty())
    throw std::runtime_error("--from " + std::to_string(job.from) + ": the sequence has only " +
                             std::to_string(size) + " scans");
  return indices;
}

/// Empties OUT of an earlier run's results, so that what lies there is of one run.
void prepare_folder(const fs::path& folder) {
  fs::create_directories(folder);
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".label") old.push_back(entry.path());
  for (const fs::path& file : old) fs::remove(file);
}

/// SemanticKITTI's moving-object classes.
std::uint32_t class_of(Label label) {
  if (label == Label::kStatic) return 9;
  return label == Label::kDynamic ? 251 : 0;
}

void write_labels(const fs::path& file, const std::vector<Label>& labels) {
  std::vector<std::uint32_t> classes(labels.size());
  std::transform(labels.begin(), labels.end(), classes.begin(), class_of);
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(classes.data()),
               static_cast<std::streamsize>(classes.size() * sizeof(std::uint32_t)));
  if (!stream.flush()) throw std::runtime_error(file.string() + ": cannot be written; is the disk full?");
}

const ScanLabels& process(Mapper& mapper, const Frame& frame, EngineClock& clock) {
  try {
    clock.start_scan();
    const ScanLabels& labels = mapper.process(frame.scan, frame.T_map_sensor);
    clock.end_scan();
    return labels;
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error("scan " + frame.name + ": " + error.what());
  }
}

/// Writes a pass's labels, and counts them, while the next scan is worked on.
class PassWriter {
 public:
  PassWriter(fs::path folder, LabelTotals& totals, WriteBehind& behind, LabelStore* store = nullptr)
      : folder_(std::move(folder)), totals_(totals), behind_(behind), store_(store) {}
  void write(const std::string& scan, ScanLabels labels) {
    behind_.add(
        [file = folder_ / (scan + ".label"), totals = &totals_, store = store_, labels = std::move(labels)] {
          write_labels(file, labels.label);
          totals->add(labels);
          if (store != nullptr) store->append(labels);
        });
  }

 private:
  fs::path folder_;
  LabelTotals& totals_;
  WriteBehind& behind_;
  LabelStore* store_;  ///< keeps them, too
};

void label_by_final_map(Sequence& sequence, const std::vector<std::size_t>& indices, const Mapper& mapper,
                        const LabelStore& online, PassWriter& final) {
  ProgressBar progress("by the final map", indices.size());
  ReadAhead reader(sequence, indices);
  for (std::size_t k = 0; k < indices.size(); ++k) {
    const Frame frame = reader.next();
    final.write(frame.name, mapper.relabel(frame.scan, frame.T_map_sensor, online.read(k)));
    progress.advance();
  }
}

}  // namespace

void label_sequence(Sequence& sequence, const Parameters& parameters, const LabelJob& job) {
  const std::vector<std::size_t> indices = chosen_scans(sequence.size(), job);
  const fs::path out(job.out);
  prepare_folder(out / "online");
  prepare_folder(out / "delayed");
  prepare_folder(out / "final");
  fs::remove(out / "summary.json");

  const auto far_tiles = open_tile_folder(parameters, say);
  Mapper mapper(parameters);
  mapper.set_tile_store(far_tiles.get());
  ReadAhead reader(sequence, indices);
  RunSummary summary;
  LabelStore store(job.out);
  WriteBehind behind;
  PassWriter online(out / "online", summary.online, behind, job.final_labels ? &store : nullptr);
  PassWriter delayed(out / "delayed", summary.delayed, behind), final(out / "final", summary.final, behind);
  EngineClock clock([&] { return reader.cpu_ms() + behind.cpu_ms(); });
  mapper.set_listener(&clock);
  DelayedLabels<Frame> waiting(job.delay);

  ProgressBar online_bar("labelling", indices.size());
  for (std::size_t k = 0; k < indices.size(); ++k) {
    Frame frame = reader.next();
    const ScanLabels& labels = process(mapper, frame, clock);
    online.write(frame.name, labels);
    if (job.delay > 0)
      if (auto settled = waiting.add(mapper, std::move(frame), labels))
        delayed.write(settled->scan.name, std::move(settled->labels));
    online_bar.advance();
  }
  while (auto settled = waiting.settle_oldest(mapper))
    delayed.write(settled->scan.name, std::move(settled->labels));
  behind.finish();
  if (job.final_labels) label_by_final_map(sequence, indices, mapper, store, final);
  behind.finish();

  std::mutex nobody_else;
  save_map(whole_map(mapper, far_tiles.get(), nobody_else), mapper.decision(),
           (out / "static_map.pcd").string());
  summary.voxels = mapper.voxel_count();
  write_summary((out / "summary.json").string(), summary, clock, parameters);
}

}  // namespace stillmap
