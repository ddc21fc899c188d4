#include "io/semantickitti_writer.hpp"

#include <iomanip>
#include <stdexcept>

namespace stillmap {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
  throw std::runtime_error(path.string() + ": " + what);
}

std::ofstream open(const fs::path& path) {
  std::ofstream file(path, std::ios::binary);
  if (!file) fail(path, "cannot be written: is the folder writable and is there space on the disk?");
  return file;
}

template <class T>
void write_values(const fs::path& path, const std::vector<T>& values) {
  std::ofstream file = open(path);
  file.write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(T)));
  file.close();
  if (!file) fail(path, "could not be written to the end: is there space on the disk?");
}

void check_size(const Frame& frame, const char* what, std::size_t size) {
  if (size == frame.scan.points.size()) return;
  throw std::invalid_argument("scan " + frame.name + " has " + std::to_string(frame.scan.points.size()) +
                              " points but " + std::to_string(size) + " " + what +
                              ": give one for each point");
}

}  // namespace

SemanticKittiWriter::SemanticKittiWriter(const std::string& folder) : folder_(folder) {
  if (fs::exists(folder_ / "poses.txt")) {
    fail(folder_, "already holds a sequence (poses.txt): remove it or name another folder");
  }
  for (const char* part : {"velodyne", "labels", "labels_now"}) {
    std::error_code error;
    fs::create_directories(folder_ / part, error);
    if (error) fail(folder_ / part, "cannot be created: " + error.message());
  }
  std::ofstream calib = open(folder_ / "calib.txt");
  for (const char* camera : {"P0", "P1", "P2", "P3"}) calib << camera << ": 0 0 0 0 0 0 0 0 0 0 0 0\n";
  calib << "Tr: 1 0 0 0 0 1 0 0 0 0 1 0\n";
  poses_ = open(folder_ / "poses.txt");
  times_ = open(folder_ / "times.txt");
  poses_ << std::setprecision(17);
}

void SemanticKittiWriter::write(const Frame& frame, const std::vector<float>& intensity,
                                const std::vector<std::uint32_t>& labels,
                                const std::vector<std::uint32_t>& labels_now) {
  check_size(frame, "intensities", intensity.size());
  check_size(frame, "labels", labels.size());
  check_size(frame, "labels_now", labels_now.size());
  std::vector<float> rows;
  rows.reserve(4 * frame.scan.points.size());
  for (std::size_t i = 0; i < frame.scan.points.size(); ++i) {
    const Eigen::Vector3f& point = frame.scan.points[i];
    rows.insert(rows.end(), {point.x(), point.y(), point.z(), intensity[i]});
  }
  write_values(folder_ / "velodyne" / (frame.name + ".bin"), rows);
  write_values(folder_ / "labels" / (frame.name + ".label"), labels);
  write_values(folder_ / "labels_now" / (frame.name + ".label"), labels_now);

  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      poses_ << frame.T_map_sensor(row, column) << (row == 2 && column == 3 ? '\n' : ' ');
    }
  }
  poses_.flush();
  times_ << frame.scan.stamp_ns / 1'000'000'000 << '.' << std::setw(9) << std::setfill('0')
         << frame.scan.stamp_ns % 1'000'000'000 << '\n';
  times_.flush();
  if (!poses_ || !times_)
    fail(folder_, "poses.txt or times.txt could not be written: is there space on the disk?");
}

}  // namespace stillmap
