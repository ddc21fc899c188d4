#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap evaluate SEQUENCES... --out REPORT`: the paper's experiment, and its like on other sequences.
void add_evaluate_command(CLI::App& app);

}  // namespace stillmap
