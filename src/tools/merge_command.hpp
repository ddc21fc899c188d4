#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap merge OUT IN...`: maps and recordings of one frame as one map.
void add_merge_command(CLI::App& app);

}  // namespace stillmap
