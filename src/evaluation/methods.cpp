#include "evaluation/methods.hpp"

#include <stdexcept>

#include "baselines/erasor.hpp"
#include "baselines/octomap_baseline.hpp"
#include "baselines/removert.hpp"
#include "evaluation/stillmap_method.hpp"

namespace stillmap {
namespace {

template <class Method, class Settings>
MethodChoice choice(const std::string& name, const Settings& settings) {
  return {name, [settings] { return std::make_unique<Method>(settings); }};
}

std::vector<MethodChoice> choices(const Parameters& parameters) {
  return {choice<StillmapMethod>("default", parameters),
          choice<StillmapMethod>("paper", preset("paper")),
          choice<OctomapBaseline>("octomap", OctomapSettings::paper()),
          choice<Erasor>("erasor", ErasorSettings::paper()),
          choice<Removert>("removert", RemovertSettings::paper()),
          choice<OctomapBaseline>("octomap_published", OctomapSettings::published()),
          choice<Erasor>("erasor_published", ErasorSettings::published()),
          choice<Removert>("removert_published", RemovertSettings::published())};
}

}  // namespace

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const MethodChoice& choice : choices(Parameters())) names.push_back(choice.name);
  return names;
}

MethodChoice choose_method(const std::string& name, const Parameters& parameters) {
  std::string known;
  for (const MethodChoice& choice : choices(parameters)) {
    if (choice.name == name) return choice;
    known += (known.empty() ? "" : ", ") + choice.name;
  }
  throw std::invalid_argument("method '" + name + "' is not known; there are " + known);
}

}  // namespace stillmap
