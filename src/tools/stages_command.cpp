#include "tools/stages_command.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "stillmap/mapper.hpp"
#include "stillmap/range_image.hpp"
#include "tools/parameter_options.hpp"
#include "tools/sequence_options.hpp"

namespace stillmap {
namespace {

constexpr float kRad = 0.01745329252F;

struct StagesJob {
  SequenceOptions sequence;
  ParameterOptions parameters;
  std::string out;
  std::size_t scan = 30;
};

std::ofstream create(const std::string& folder, const std::string& name) {
  std::filesystem::create_directories(folder);
  const std::string path = (std::filesystem::path(folder) / name).string();
  std::ofstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be written");
  return file;
}

/// The stages of a voxel that was known before the scan: I_M, I_O, the case, L and the decision.
void write_voxels(const StagesJob& job, const MapSnapshot& before, const Frame& frame,
                  const Parameters& parameters) {
  ProjectedScan projected;
  project(frame.scan, float(parameters.min_range_m), float(parameters.max_range_m), projected);
  SensorGeometry geometry = measure_geometry(projected);
  if (parameters.ring_spacing_deg > 0) geometry.ring_spacing_rad = float(parameters.ring_spacing_deg) * kRad;
  const RangeImage image = RangeImage::bracketed(projected, geometry, float(parameters.max_range_m));
  const LevelModel level = level_models(parameters).front();
  const Eigen::Isometry3f T_sensor_map = frame.T_map_sensor.inverse().cast<float>();
  std::ofstream file = create(job.out, "voxels.csv");
  file << "x,y,z,range_m,nearest_m,farthest_m,evidence,log_odds,label\n";
  for (const SnapshotVoxel& voxel : before.voxels) {
    const Spherical seen = spherical(Eigen::Vector3f(T_sensor_map * voxel.center));
    if (seen.range_m > float(parameters.max_range_m)) continue;
    const MeasuredRange measured = image.at(seen.azimuth_rad, seen.elevation_rad);
    const Evidence evidence = classify(seen.range_m, measured, level);
    file << voxel.center.x() << ',' << voxel.center.y() << ',' << voxel.center.z() << ',' << seen.range_m
         << ',' << measured.nearest_m << ',' << measured.farthest_m << ',' << int(evidence) << ','
         << voxel.log_odds << ',' << int(voxel.label) << '\n';
  }
}

void write_points(const StagesJob& job, const Frame& frame, const ScanLabels& labels) {
  std::ofstream file = create(job.out, "points.csv");
  file << "x,y,z,azimuth_deg,elevation_deg,range_m,p_static,label,reason\n";
  for (std::size_t i = 0; i < frame.scan.points.size(); ++i) {
    if (labels.label[i] == Label::kInvalid) continue;
    const Spherical seen = spherical(frame.scan.points[i]);
    const Eigen::Vector3d p = frame.T_map_sensor * frame.scan.points[i].cast<double>();
    file << p.x() << ',' << p.y() << ',' << p.z() << ',' << seen.azimuth_rad / kRad << ','
         << seen.elevation_rad / kRad << ',' << seen.range_m << ',' << labels.p_static[i] << ','
         << int(labels.label[i]) << ',' << int(labels.reason[i]) << '\n';
  }
}

void write_stages(const StagesJob& job) {
  const auto sequence = job.sequence.open();
  if (job.scan >= sequence->size())
    throw std::runtime_error("--scan " + std::to_string(job.scan) + ": the sequence has " +
                             std::to_string(sequence->size()) + " scans");
  const Parameters parameters = job.parameters.resolve();
  Mapper mapper(parameters);
  for (std::size_t k = 0; k < job.scan; ++k) {
    const Frame frame = sequence->read(k);
    mapper.process(frame.scan, frame.T_map_sensor);
  }
  const Frame frame = sequence->read(job.scan);
  write_voxels(job, *mapper.snapshot(), frame, parameters);
  write_points(job, frame, mapper.process(frame.scan, frame.T_map_sensor));
}

}  // namespace

void add_stages_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "stages", "Write what each stage of the method says of one scan, as tables for scripts/draw_stages.py");
  const auto job = std::make_shared<StagesJob>();
  job->sequence.add_to(*command);
  command->add_option("OUT", job->out, "Folder for voxels.csv (before the scan) and points.csv")->required();
  command->add_option("--scan", job->scan, "Which one; those before it make the map")->capture_default_str();
  job->parameters.add_to(*command);
  command->callback([job] { write_stages(*job); });
}

}  // namespace stillmap
