#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap label SEQUENCE OUT`: labels every point of a recorded sequence, at once and by the final map.
void add_label_command(CLI::App& app);

}  // namespace stillmap
