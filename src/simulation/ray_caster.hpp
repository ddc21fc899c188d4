#pragma once

#include <optional>
#include <vector>

#include "simulation/bvh.hpp"
#include "simulation/world.hpp"

namespace stillmap::simulation {

/// What a ray meets first.
struct Hit {
  double range_m;
  double incidence_cos;
  Surface surface;
  std::uint16_t instance;
  const Mover* mover;  ///< nullptr = a thing that stays
};

/// Casts rays into a world that must outlive it. Safe to share between threads.
class RayCaster {
 public:
  explicit RayCaster(const World& world);

  /// The movers during one sweep; remembers where each was last, since rays come in order of time.
  class MoversInSweep {
   public:
    MoversInSweep(const World& world, double begin_s, double end_s);

   private:
    friend class RayCaster;
    struct Entry {
      const Mover* mover;
      Eigen::Vector3d center;  ///< of a ball that holds the mover all through the sweep
      double radius_m;
      double posed_at_s;
      Eigen::Isometry3d T_body_map;
      double distance_m;
    };
    std::vector<Entry> entries_;
  };

  std::optional<Hit> cast(const Ray& ray, double time_s, double max_range_m, MoversInSweep* movers) const;

  const World& world() const { return *world_; }

 private:
  std::optional<Hit> cast_at_fixtures(const Ray& ray, double time_s, double max_range_m) const;
  static void cast_at_mover(const Ray& ray, double time_s, MoversInSweep::Entry* entry, double max_range_m,
                            std::optional<Hit>* nearest);

  const World* world_;
  Bvh bvh_;
};

}  // namespace stillmap::simulation
