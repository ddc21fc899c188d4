#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap inject SEQUENCE OUT`: puts synthetic moving targets into a recorded sequence.
void add_inject_command(CLI::App& app);

}  // namespace stillmap
