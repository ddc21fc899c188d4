#pragma once

#include <memory>
#include <mutex>

#include "stillmap/mapper.hpp"

namespace stillmap {

/// The mapper, for the worker and the services: whoever uses it holds the mutex.
struct SharedMapper {
  std::mutex mutex;
  std::unique_ptr<TileStore> far_tiles;  ///< nullptr = none are kept; needs no mutex
  Mapper mapper;
};

}  // namespace stillmap
