#include "stillmap/evidence.hpp"

namespace stillmap {

std::vector<LevelModel> level_models(const Parameters& p) {
  const auto of_level = [](const std::vector<double>& values, std::size_t level) {
    return static_cast<float>(values.size() == 1 ? values.front() : values[level]);
  };
  std::vector<LevelModel> models(p.angular_levels_deg.size());
  for (std::size_t r = 0; r < models.size(); ++r) {
    models[r].epsilon_m = of_level(p.support_threshold_m_r, r);
    models[r].tau_0_m = of_level(p.conflict_base_m_r, r);
    models[r].alpha = of_level(p.conflict_scale_r, r);
    models[r].sigma_m = of_level(p.conflict_sigma_m_r, r);
    models[r].eta = of_level(p.support_rate_r, r);
    models[r].kappa = of_level(p.conflict_rate_r, r);
    models[r].eta_when_dynamic = static_cast<float>(p.support_rate_when_dynamic);
    models[r].form = p.conflict_strength == "linear" ? ConflictStrength::kLinear : ConflictStrength::kSigmoid;
  }
  for (LevelModel& model : models) {
    model.support_rank = model.eta > 0 ? 1 : 0;
    for (const LevelModel& other : models)
      if (other.eta > 0 && other.eta < model.eta) ++model.support_rank;
  }
  return models;
}

}  // namespace stillmap
