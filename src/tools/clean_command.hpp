#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap clean IN.bag OUT.bag`: the bag as it was, but for the moving points of one cloud topic.
void add_clean_command(CLI::App& app);

}  // namespace stillmap
