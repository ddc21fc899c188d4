#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap export MAP OUT...`: a .stillmap as PCD, PLY, OctoMap or a picture of its heights.
void add_export_command(CLI::App& app);

}  // namespace stillmap
