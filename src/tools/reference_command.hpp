#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap reference`: prints doc/reference.md.
void add_reference_command(CLI::App& app);

}  // namespace stillmap
