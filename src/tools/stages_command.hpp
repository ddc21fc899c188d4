#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap stages`: what the stages of the method say of one scan, for doc/method.md.
void add_stages_command(CLI::App& app);

}  // namespace stillmap
