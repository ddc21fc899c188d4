#include "io/semantickitti_folder.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace stillmap {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPointBytes = 4 * sizeof(float);  // x y z intensity
constexpr double kDefaultPeriod_s = 0.1;
constexpr double kNotRigid = 1e-3;  // rounding in real pose files stays far below

[[noreturn]] void fail(const std::string& message) {
  throw std::runtime_error(message);
}

/// Twelve numbers, row by row. Printed poses are rounded: the rotation is made exact again.
Eigen::Isometry3d parse_pose(std::istream& numbers, const std::string& where) {
  Eigen::Matrix<double, 3, 4> rows;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      if (!(numbers >> rows(row, column))) fail(where + ": expected 12 numbers, found fewer or not a number");
  std::string rest;
  if (numbers >> rest) fail(where + ": expected 12 numbers, found more ('" + rest + "')");
  const Eigen::Matrix3d rotation = rows.leftCols<3>();
  const double error = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!rows.allFinite() || !(error < kNotRigid) || rotation.determinant() < 0)
    fail(where + ": not a rotation and a translation; expected the rows of a 3x4 matrix [R t]");
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
  pose.translation() = rows.col(3);
  return pose;
}

std::vector<std::string> find_scans(const fs::path& folder) {
  const fs::path scans = folder / "velodyne";
  if (!fs::is_directory(scans))
    fail(folder.string() +
         ": no folder velodyne/ in it; expected a sequence in SemanticKITTI layout (velodyne/, poses.txt)");
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(scans))
    if (entry.path().extension() == ".bin") files.push_back(entry.path().string());
  if (files.empty()) fail(scans.string() + ": no .bin file in it; expected one for each scan");
  std::sort(files.begin(), files.end());
  return files;
}

Eigen::Isometry3d read_T_camera_sensor(const fs::path& file) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string key;
    if (words >> key && key == "Tr:") return parse_pose(words, file.string() + ": Tr");
  }
  return Eigen::Isometry3d::Identity();
}

std::vector<Eigen::Isometry3d> read_poses(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) fail(file.string() + ": cannot be read; expected one pose (12 numbers) a line for each scan");
  std::vector<Eigen::Isometry3d> poses;
  std::size_t line_number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++line_number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::istringstream numbers(line);
    poses.push_back(parse_pose(numbers, file.string() + ":" + std::to_string(line_number)));
  }
  return poses;
}

std::vector<std::int64_t> read_stamps_ns(const fs::path& file, std::size_t count) {
  std::vector<std::int64_t> stamps_ns;
  if (!fs::exists(file)) {
    for (std::size_t k = 0; k < count; ++k)
      stamps_ns.push_back(std::llround(static_cast<double>(k) * kDefaultPeriod_s * 1e9));
    return stamps_ns;
  }
  std::ifstream stream(file);
  for (double stamp_s = 0; stream >> stamp_s;) stamps_ns.push_back(std::llround(stamp_s * 1e9));
  if (!stream.eof() || stamps_ns.size() != count)
    fail(file.string() + ": " + std::to_string(stamps_ns.size()) + " times for " + std::to_string(count) +
         " poses; expected one number of seconds a line for each pose, or no such file");
  return stamps_ns;
}

/// Which pose belongs to a scan: its number when the folder holds only a part of the sequence.
std::size_t pose_index(const std::string& scan_file, std::size_t order, bool by_number, std::size_t poses) {
  if (!by_number) return order;
  const std::string name = fs::path(scan_file).stem().string();
  const bool is_number = !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
  if (!is_number || name.size() > 18 || std::stoull(name) >= poses)
    fail(scan_file + ": poses.txt holds " + std::to_string(poses) +
         " poses, more than there are scans, and the file's name is not the number of one of them");
  return std::stoull(name);
}

std::vector<char> read_bytes(const std::string& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream || !fs::is_regular_file(file)) fail(file + ": cannot be read; expected a file");
  std::vector<char> bytes(static_cast<std::size_t>(stream.tellg()));
  stream.seekg(0);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) fail(file + ": cannot be read");
  return bytes;
}

}  // namespace

SemanticKittiFolder::SemanticKittiFolder(const std::string& folder) : scan_files_(find_scans(folder)) {
  const fs::path root(folder);
  const Eigen::Isometry3d T_camera_sensor = read_T_camera_sensor(root / "calib.txt");
  const std::vector<Eigen::Isometry3d> poses = read_poses(root / "poses.txt");
  if (poses.size() < scan_files_.size())
    fail((root / "poses.txt").string() + ": " + std::to_string(poses.size()) + " poses for " +
         std::to_string(scan_files_.size()) + " scans; expected at least one pose for each scan");
  const std::vector<std::int64_t> stamps_ns = read_stamps_ns(root / "times.txt", poses.size());

  const bool by_number = poses.size() > scan_files_.size();
  for (std::size_t k = 0; k < scan_files_.size(); ++k) {
    const std::size_t pose = pose_index(scan_files_[k], k, by_number, poses.size());
    T_map_sensor_.push_back(T_camera_sensor.inverse() * poses[pose] * T_camera_sensor);
    stamps_ns_.push_back(stamps_ns[pose]);
  }
}

Frame SemanticKittiFolder::read(std::size_t index) {
  const std::string& file = scan_files_.at(index);
  const std::vector<char> bytes = read_bytes(file);
  if (bytes.size() % kPointBytes != 0)
    fail(file + ": " + std::to_string(bytes.size()) + " bytes are no whole number of points of " +
         std::to_string(kPointBytes) + " bytes; the file is cut off or of another format");
  Frame frame;
  frame.name = fs::path(file).stem().string();
  frame.scan.stamp_ns = stamps_ns_[index];
  frame.T_map_sensor = T_map_sensor_[index];
  frame.scan.points.resize(bytes.size() / kPointBytes);
  for (std::size_t i = 0; i < frame.scan.points.size(); ++i)
    std::copy_n(bytes.data() + i * kPointBytes, 3 * sizeof(float),
                reinterpret_cast<char*>(frame.scan.points[i].data()));
  return frame;
}

std::vector<std::uint32_t> read_labels(const std::string& file, std::size_t expected_count) {
  const std::vector<char> bytes = read_bytes(file);
  if (bytes.size() != expected_count * sizeof(std::uint32_t))
    fail(file + ": " + std::to_string(bytes.size()) + " bytes, but " + std::to_string(expected_count) +
         " points need " + std::to_string(expected_count * sizeof(std::uint32_t)) +
         "; the labels belong to another scan");
  std::vector<std::uint32_t> labels(expected_count);
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(labels.data()));
  return labels;
}

}  // namespace stillmap
