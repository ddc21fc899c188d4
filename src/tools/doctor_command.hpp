#pragma once

namespace CLI {
class App;
}

namespace stillmap {

/// `stillmap doctor BAG`: what would ruin the results, and the launch line for this recording.
void add_doctor_command(CLI::App& app);

}  // namespace stillmap
