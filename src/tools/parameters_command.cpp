#include "tools/parameters_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "io/parameters_yaml.hpp"
#include "tools/parameter_options.hpp"

namespace stillmap {

void add_parameters_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("parameters", "Print every parameter as a file for --config");
  const auto options = std::make_shared<ParameterOptions>();
  options->add_to(*command);
  command->callback([options] { std::cout << to_yaml(options->resolve()); });
}

}  // namespace stillmap
