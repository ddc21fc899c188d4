#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap diff A B --out FOLDER`: what appeared and what went between two maps.
void add_diff_command(CLI::App& app);

}  // namespace stillmap
