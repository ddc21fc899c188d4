#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap bag SEQUENCE OUT`: a folder in SemanticKITTI layout as a bag, to be replayed through the
/// nodelet.
void add_bag_command(CLI::App& app);

}  // namespace stillmap
