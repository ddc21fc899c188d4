#include "scan_alignment.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "mapper_state.hpp"
#include "neighbouring_voxels.hpp"

namespace stillmap {
namespace {

constexpr std::size_t kSamples = 200;
constexpr int kEnoughPlanes = 50;

std::vector<Eigen::Vector3d> some_returns(const ProjectedScan& scan) {
  constexpr float kFarthestM = 40.0F;  // beyond, beams are too far apart to show a surface
  std::vector<Eigen::Vector3d> points_m;
  const std::size_t stride = std::max<std::size_t>(1, scan.judged / kSamples);
  std::size_t until_next = 1;
  for (std::size_t row = 0; row < scan.size(); ++row) {
    if (!(scan.range_m[row] > 0) || --until_next > 0) continue;
    until_next = stride;
    if (scan.range_m[row] < kFarthestM) points_m.emplace_back(scan.x_m[row], scan.y_m[row], scan.z_m[row]);
  }
  return points_m;
}

}  // namespace

Eigen::Isometry3d SmallMotion::applied_to(const Eigen::Isometry3d& T_map_sensor) const {
  Eigen::Isometry3d moved = T_map_sensor;
  const double angle_rad = turn_rad.norm();
  if (angle_rad > 0)
    moved.linear() = Eigen::AngleAxisd(angle_rad, turn_rad / angle_rad) * T_map_sensor.linear();
  moved.translation() += shift_m;
  return moved;
}

std::optional<SmallMotion> ScanAlignment::find(const ProjectedScan& scan,
                                               const Eigen::Isometry3d& T_map_sensor) const {
  constexpr double kConvergedM = 0.03;
  constexpr int kSteps = 10;
  const std::vector<Eigen::Vector3d> points_m = some_returns(scan);
  SmallMotion motion;
  for (int i = 0; i < kSteps; ++i) {
    const std::optional<SmallMotion> more = step(points_m, motion.applied_to(T_map_sensor), motion);
    if (!more) return std::nullopt;
    motion.turn_rad += more->turn_rad;
    motion.shift_m += more->shift_m;
    if (more->reach_m() < kConvergedM) break;
  }
  return motion;
}

int ScanAlignment::agreeing(const ProjectedScan& scan, const Eigen::Isometry3d& T_map_sensor) const {
  constexpr double kAgreesM = 0.05;
  int agree = 0;
  for (const Eigen::Vector3d& point_m : some_returns(scan)) {
    const std::optional<Plane> plane = plane_near(T_map_sensor * point_m);
    agree += plane && std::abs(plane->distance_m) < kAgreesM;
  }
  return agree;
}

std::optional<SmallMotion> ScanAlignment::step(const std::vector<Eigen::Vector3d>& points_m,
                                               const Eigen::Isometry3d& T_map_sensor,
                                               const SmallMotion& so_far) const {
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  constexpr double kSurface_m = 0.05;                 // returns agree with a plane so well
  constexpr double kTurn_rad = 0.01, kShift_m = 0.1;  // what an odometry is off, where nothing else tells
  Vector6 prior, already;
  prior << Eigen::Vector3d::Constant(1 / (kTurn_rad * kTurn_rad)),
      Eigen::Vector3d::Constant(1 / (kShift_m * kShift_m));
  already << so_far.turn_rad, so_far.shift_m;
  Matrix6 normal_matrix = prior.asDiagonal();
  Vector6 right = -prior.cwiseProduct(already);
  std::vector<std::optional<Plane>> plane_of(points_m.size());
  for_pieces(points_m.size(), 25, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) plane_of[i] = plane_near(T_map_sensor * points_m[i]);
  });
  int planes = 0;
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    const std::optional<Plane>& plane = plane_of[i];
    if (!plane) continue;
    const Eigen::Vector3d arm_m = T_map_sensor.linear() * points_m[i];
    const double off_m = plane->distance_m;
    const double weight = 1 / (kSurface_m * kSurface_m + off_m * off_m);  // what is new says little
    Vector6 direction;
    direction << arm_m.cross(plane->normal), plane->normal;
    normal_matrix.noalias() += weight * direction * direction.transpose();
    right += weight * off_m * direction;
    ++planes;
  }
  if (planes < kEnoughPlanes) return std::nullopt;
  const Vector6 solution = normal_matrix.ldlt().solve(right);
  return SmallMotion{solution.head<3>(), solution.tail<3>()};
}

// The plane through the static surface in the voxels around, if it is flat and more than a line.
std::optional<ScanAlignment::Plane> ScanAlignment::plane_near(const Eigen::Vector3d& point_map_m) const {
  constexpr int kEnough = 6;
  constexpr double kThick_m = 0.03, kWide_m = 0.05;
  const VoxelKey centre = map_.key_of(point_map_m);
  NeighbouringVoxels neighbours(map_);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  int voxels = 0;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const VoxelKey key = centre + VoxelKey(x, y, z);
        const Voxel* const voxel = neighbours.find(key);
        if (voxel == nullptr || voxel->log_odds_fixed <= 0) continue;
        const Eigen::Vector3d in_edges = key.cast<double>() + voxel->surface_offset().cast<double>();
        const Eigen::Vector3d from_point_m = in_edges * map_.voxel_size_m() - point_map_m;
        sum += from_point_m;
        products += from_point_m * from_point_m.transpose();
        ++voxels;
      }
  if (voxels < kEnough) return std::nullopt;
  const Eigen::Vector3d mean_m = sum / voxels;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread;
  spread.computeDirect(products / voxels - mean_m * mean_m.transpose());
  const Eigen::Vector3d variances = spread.eigenvalues();
  if (variances[0] > kThick_m * kThick_m || variances[1] < kWide_m * kWide_m) return std::nullopt;
  const Eigen::Vector3d normal = spread.eigenvectors().col(0);
  return Plane{normal, normal.dot(mean_m)};
}

// Only what shakes is taken back: an odometry that drifts slowly carries the map along, as it always did.
Eigen::Isometry3d Mapper::State::aligned(const Eigen::Isometry3d& T_map_sensor, PoseJumps& jumps) const {
  constexpr double kUsualRate = 0.05, kShakingRate = 0.2;  // by scan
  constexpr double kClearlyMore = 1.15;
  constexpr double kJumpM = 0.12, kShakingM = 0.07;  // smaller ones, the windows of the evidence take
  const std::optional<SmallMotion> off = ScanAlignment(map).find(projected, T_map_sensor);
  if (!off) return T_map_sensor;
  const SmallMotion jump = *off - jumps.usual;
  const double jump_m = jump.reach_m();
  jumps.usual.turn_rad += kUsualRate * jump.turn_rad;
  jumps.usual.shift_m += kUsualRate * jump.shift_m;
  jumps.mean_square_m2 += kShakingRate * (jump_m * jump_m - jumps.mean_square_m2);
  if (jump_m < kJumpM && jumps.mean_square_m2 < kShakingM * kShakingM) return T_map_sensor;
  const Eigen::Isometry3d T_aligned = jump.applied_to(T_map_sensor);
  const ScanAlignment alignment(map);
  // Between sparse beams and leaves a jump may be found that is none.
  if (alignment.agreeing(projected, T_aligned) < kClearlyMore * alignment.agreeing(projected, T_map_sensor))
    return T_map_sensor;
  jumps.any_taken_back = true;
  return T_aligned;
}

Eigen::Isometry3d Mapper::State::realigned(const Scan& scan, const Eigen::Isometry3d& T_map_sensor) const {
  const auto sensor = static_cast<std::size_t>(scan.sensor);
  if (sensor >= sensors.size() || !sensors[sensor].jumps.any_taken_back) return T_map_sensor;
  ProjectedScan again;
  project(scan, static_cast<float>(parameters.min_range_m), static_cast<float>(parameters.max_range_m),
          again);
  const std::optional<SmallMotion> off = ScanAlignment(map).find(again, T_map_sensor);
  return off ? off->applied_to(T_map_sensor) : T_map_sensor;
}

}  // namespace stillmap
