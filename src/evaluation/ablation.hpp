#pragma once

#include <vector>

#include "evaluation/methods.hpp"

namespace stillmap {

/// The method `parameters` describe, as "full", and once more without each of its additions to the paper.
std::vector<MethodChoice> ablation_choices(const Parameters& parameters);

}  // namespace stillmap
