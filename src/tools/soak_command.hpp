#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap soak SEQUENCE`.
void add_soak_command(CLI::App& app);

}  // namespace stillmap
