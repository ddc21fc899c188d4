#pragma once

#include <string>

namespace stillmap {

/// "Intel(R) ..."; "unknown" where the system does not tell.
std::string cpu_model();

}  // namespace stillmap
