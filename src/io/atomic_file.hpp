#pragma once

#include <functional>
#include <string>

namespace stillmap {

/// Writes a file so that `path` holds either what it held or all of the new content: `write` is called with
/// the name of a new file in the same folder, which is then synced to disk and renamed. Throws
/// std::runtime_error naming the path; the new file is then gone.
void write_atomically(const std::string& path, const std::function<void(const std::string&)>& write);

/// The same for text.
void write_text_atomically(const std::string& path, const std::string& text);

}  // namespace stillmap
