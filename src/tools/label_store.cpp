#include "tools/label_store.hpp"

#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace stillmap {
namespace {

constexpr std::size_t kPointBytes = sizeof(Label) + sizeof(Reason) + sizeof(float) + sizeof(std::int32_t);

std::FILE* open_unnamed(std::string name) {
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) throw std::runtime_error(name + ": cannot be created: " + std::strerror(errno));
  unlink(name.c_str());
  return fdopen(descriptor, "w+b");
}

template <class T>
void write(std::FILE* file, const std::vector<T>& values) {
  if (std::fwrite(values.data(), sizeof(T), values.size(), file) != values.size())
    throw std::runtime_error("labels kept for the final pass: cannot be written; is OUT's disk full?");
}

template <class T>
void read(std::FILE* file, std::vector<T>& values, std::size_t count) {
  values.resize(count);
  if (std::fread(values.data(), sizeof(T), count, file) != count)
    throw std::runtime_error("labels kept for the final pass: cannot be read back");
}

}  // namespace

LabelStore::LabelStore(const std::string& folder)
    : file_(open_unnamed(folder + "/.labels.XXXXXX"), &std::fclose) {}

void LabelStore::append(const ScanLabels& labels) {
  write(file_.get(), labels.label);
  write(file_.get(), labels.reason);
  write(file_.get(), labels.p_static);
  write(file_.get(), labels.object);
  offsets_.push_back(offsets_.back() + static_cast<std::int64_t>(labels.label.size()));
}

ScanLabels LabelStore::read(std::size_t scan) const {
  const std::size_t count = static_cast<std::size_t>(offsets_.at(scan + 1) - offsets_.at(scan));
  if (fseeko(file_.get(), offsets_[scan] * static_cast<off_t>(kPointBytes), SEEK_SET) != 0)
    throw std::runtime_error("labels kept for the final pass: cannot be read back");
  ScanLabels labels;
  stillmap::read(file_.get(), labels.label, count);
  stillmap::read(file_.get(), labels.reason, count);
  stillmap::read(file_.get(), labels.p_static, count);
  stillmap::read(file_.get(), labels.object, count);
  return labels;
}

}  // namespace stillmap
