#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap explain SOURCE --at "x y z"`: why a place has its label.
void add_explain_command(CLI::App& app);

}  // namespace stillmap
