#include "ros/map_repair.hpp"

#include <ros/console.h>

#include <stdexcept>

#include "io/whole_map.hpp"
#include "maps/map_extent.hpp"

namespace stillmap {
namespace {

Eigen::Vector3d to_vector(const geometry_msgs::Point& point) {
  return {point.x, point.y, point.z};
}

template <class Request>
Eigen::AlignedBox3d box_of(const Request& request) {
  return {to_vector(request.min), to_vector(request.max)};
}

/// Runs the edit under the lock and answers with the number of voxels, or with why there were none.
template <class Response, class Edit>
void answer(const char* service, const std::string& what_was_done, SharedMapper& shared, Response& response,
            const Edit& edit) {
  try {
    std::unique_lock lock(shared.mutex);
    response.voxels = edit(shared.mapper);
    lock.unlock();
    response.success = response.voxels > 0;
    response.message =
        response.success
            ? what_was_done + ": " + std::to_string(response.voxels) + " voxels"
            : "no voxel is in the box; " +
                  extent_in_words(whole_map(shared.mapper, shared.far_tiles.get(), shared.mutex));
  } catch (const std::invalid_argument& error) {
    response.success = false;
    response.message = error.what();
  }
  ROS_INFO_STREAM(service << ": " << response.message);
}

}  // namespace

MapRepair::MapRepair(ros::NodeHandle private_nh, SharedMapper& shared)
    : shared_(shared),
      clear_box_(private_nh.advertiseService("clear_box", &MapRepair::on_clear_box, this)),
      relabel_box_(private_nh.advertiseService("relabel_box", &MapRepair::on_relabel_box, this)) {}

bool MapRepair::on_clear_box(ClearBox::Request& request, ClearBox::Response& response) {
  answer("clear_box", "forgotten", shared_, response,
         [&](Mapper& mapper) { return mapper.clear_box(box_of(request)); });
  return true;
}

bool MapRepair::on_relabel_box(RelabelBox::Request& request, RelabelBox::Response& response) {
  const auto label = static_cast<Label>(request.label);
  answer("relabel_box", std::string("now ") + to_string(label), shared_, response, [&](Mapper& mapper) {
    if (request.label > RelabelBox::Request::DYNAMIC)
      throw std::invalid_argument("label " + std::to_string(request.label) +
                                  ": give 0 (uncertain), 1 (static) or 2 (dynamic)");
    return mapper.relabel_box(box_of(request), label);
  });
  return true;
}

}  // namespace stillmap
