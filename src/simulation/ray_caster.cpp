#include "simulation/ray_caster.hpp"

#include <cmath>

namespace stillmap::simulation {
namespace {

std::vector<Eigen::AlignedBox3d> bounds_of(const World& world) {
  std::vector<Eigen::AlignedBox3d> bounds;
  bounds.reserve(world.fixtures().size());
  for (const Fixture& fixture : world.fixtures()) {
    Eigen::AlignedBox3d box = fixture.shape.bounds();
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(fixture.sway.reach_m());
    bounds.emplace_back(box.min() - reach, box.max() + reach);
  }
  return bounds;
}

/// Of a ball about the body's origin that holds every part however it swings.
double reach_m(const Body& body) {
  double reach = 0;
  for (const Part& part : body) {
    const double size = part.shape.bounds().sizes().norm() / 2;
    const double arm = (part.shape.center - part.swing.pivot).norm();
    const double center =
        part.swing.amplitude_rad != 0 ? part.swing.pivot.norm() + arm : part.shape.center.norm();
    reach = std::max(reach, center + size);
  }
  return reach;
}

/// Turns the ray back by the limb's swing, which is cheaper than turning the limb.
Ray unswing(const Ray& ray, const Swing& swing, double distance_m) {
  const double angle =
      swing.amplitude_rad * std::sin(2.0 * M_PI * distance_m / swing.stride_m + swing.phase_rad);
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turn = [c, s](const Eigen::Vector3d& v) {
    return Eigen::Vector3d(c * v.x() - s * v.z(), v.y(), s * v.x() + c * v.z());
  };
  return {swing.pivot + turn(ray.origin - swing.pivot), turn(ray.direction)};
}

bool meets_ball(const Ray& ray, const Eigen::Vector3d& center, double radius_m, double max_range_m) {
  const Eigen::Vector3d to_center = center - ray.origin;
  const double along = to_center.dot(ray.direction);
  if (along < -radius_m || along > max_range_m + radius_m) return false;
  return to_center.squaredNorm() - along * along <= radius_m * radius_m;
}

}  // namespace

RayCaster::RayCaster(const World& world) : world_(&world), bvh_(bounds_of(world)) {}

RayCaster::MoversInSweep::MoversInSweep(const World& world, double begin_s, double end_s) {
  entries_.reserve(world.movers().size());
  for (const Mover& mover : world.movers()) {
    const Eigen::Vector3d begin = mover.motion(begin_s).T_map_body.translation();
    const Eigen::Vector3d end = mover.motion(end_s).T_map_body.translation();
    // Nothing turns back far within a sweep: half its way again is room enough.
    const double radius_m = reach_m(mover.body) + (end - begin).norm() + 0.1;
    entries_.push_back({&mover, (begin + end) / 2, radius_m, std::nan(""), Eigen::Isometry3d::Identity(), 0});
  }
}

std::optional<Hit> RayCaster::cast(const Ray& ray, double time_s, double max_range_m,
                                   MoversInSweep* movers) const {
  std::optional<Hit> nearest = cast_at_fixtures(ray, time_s, max_range_m);
  const auto ground = world_->ground.cross(ray, nearest ? nearest->range_m : max_range_m);
  if (ground && (!nearest || ground->crossing.range_m < nearest->range_m)) {
    nearest = Hit{ground->crossing.range_m, ground->crossing.incidence_cos, ground->surface, 0, nullptr};
  }
  for (auto& entry : movers->entries_) {
    const double limit_m = nearest ? nearest->range_m : max_range_m;
    if (meets_ball(ray, entry.center, entry.radius_m, limit_m)) {
      cast_at_mover(ray, time_s, &entry, limit_m, &nearest);
    }
  }
  return nearest;
}

std::optional<Hit> RayCaster::cast_at_fixtures(const Ray& ray, double time_s, double max_range_m) const {
  std::optional<Hit> nearest;
  bvh_.walk(ray, max_range_m, [&](std::uint32_t item, double limit_m) {
    const Fixture& fixture = world_->fixtures()[item];
    std::optional<Crossing> crossing;
    if (fixture.sway.amplitude_m > 0) {
      crossing = fixture.shape.cross({ray.origin - fixture.sway.displacement_m(time_s), ray.direction});
    } else {
      crossing = fixture.shape.cross(ray);
    }
    if (!crossing || crossing->range_m >= limit_m) return limit_m;
    nearest =
        Hit{crossing->range_m, crossing->incidence_cos, fixture.shape.surface, fixture.instance, nullptr};
    return crossing->range_m;
  });
  return nearest;
}

void RayCaster::cast_at_mover(const Ray& ray, double time_s, MoversInSweep::Entry* entry, double max_range_m,
                              std::optional<Hit>* nearest) {
  if (entry->posed_at_s != time_s) {
    const MoverPose pose = entry->mover->motion(time_s);
    entry->T_body_map = pose.T_map_body.inverse();
    entry->distance_m = pose.distance_m;
    entry->posed_at_s = time_s;
  }
  const Ray in_body{entry->T_body_map * ray.origin, entry->T_body_map.linear() * ray.direction};
  for (const Part& part : entry->mover->body) {
    const auto crossing = part.swing.amplitude_rad != 0
                              ? part.shape.cross(unswing(in_body, part.swing, entry->distance_m))
                              : part.shape.cross(in_body);
    if (!crossing || crossing->range_m >= max_range_m) continue;
    max_range_m = crossing->range_m;
    *nearest = Hit{crossing->range_m, crossing->incidence_cos, part.shape.surface, entry->mover->instance,
                   entry->mover};
  }
}

}  // namespace stillmap::simulation
