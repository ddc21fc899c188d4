#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap parameters`: prints every parameter, documented, as a file for --config.
void add_parameters_command(CLI::App& app);

}  // namespace stillmap
