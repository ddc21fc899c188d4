#include "tools/map_scans.hpp"

#include <algorithm>

#include "tools/progress_bar.hpp"

namespace stillmap {

void map_scans(Mapper& mapper, Sequence& sequence, std::size_t scans, const std::string& title) {
  const std::size_t count = scans > 0 ? std::min(scans, sequence.size()) : sequence.size();
  ProgressBar progress(title, count);
  for (std::size_t k = 0; k < count; ++k, progress.advance()) {
    const Frame frame = sequence.read(k);
    mapper.process(frame.scan, frame.T_map_sensor);
  }
}

}  // namespace stillmap
