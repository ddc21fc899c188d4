#include "tools/parameter_options.hpp"

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "io/parameters_yaml.hpp"
#include "stillmap/worker_threads.hpp"
#include "tools/say.hpp"

namespace stillmap {

void ParameterOptions::add_to(CLI::App& command) {
  CLI::Option* config_option = command.add_option("--config", config, "YAML file of parameters");
  command.add_option("--preset", preset, "Parameters to start from: default or paper")
      ->excludes(config_option)
      ->capture_default_str();
  command.add_option("--set", set, "name=value of a parameter, over the file or preset; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--threads", threads, "Worker threads; the labels do not depend on it")
      ->check(CLI::Range(1, 64));
}

Parameters ParameterOptions::resolve() const {
  Parameters parameters = config.empty() ? stillmap::preset(preset) : load_parameters(config);
  for (const std::string& assignment : set) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos)
      throw std::runtime_error("--set " + assignment + ": expected name=value");
    set_parameter(parameters, assignment.substr(0, equals), assignment.substr(equals + 1));
  }
  if (threads > 0) parameters.threads = threads;
  check_parameters(parameters, "parameters");
  if (const std::string message = threads_message(parameters); !message.empty()) say(message);
  return parameters;
}

}  // namespace stillmap
