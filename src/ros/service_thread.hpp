#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

namespace stillmap {

/// A thread for the services: writing a file holds up neither callbacks nor scans. It outlives what is
/// advertised or subscribed with its handle.
class ServiceThread {
 public:
  explicit ServiceThread(const ros::NodeHandle& nh) : handle_(nh) {
    handle_.setCallbackQueue(&queue_);
    spinner_.start();
  }
  ~ServiceThread() { spinner_.stop(); }
  ros::NodeHandle handle() const { return handle_; }

 private:
  ros::CallbackQueue queue_;
  ros::NodeHandle handle_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace stillmap
