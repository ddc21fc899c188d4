#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap repair IN OUT --clear "x y z x y z"`: forgets or relabels boxes of a map.
void add_repair_command(CLI::App& app);

}  // namespace stillmap
