#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap simulate SCENE OUT`: writes a simulated recording as a SemanticKITTI folder or a bag.
void add_simulate_command(CLI::App& app);

}  // namespace stillmap
