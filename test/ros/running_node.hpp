#pragma once

#include <XmlRpcClient.h>
#include <XmlRpcValue.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>

#include <string>

namespace stillmap {

/// The process of a node, asked of itself; 0 when it does not answer.
inline int process_of(const std::string& node) {
  XmlRpc::XmlRpcValue request, response, uri;
  request[0] = ros::this_node::getName();
  request[1] = node;
  if (!ros::master::execute("lookupNode", request, response, uri, false)) return 0;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(static_cast<std::string>(uri), host, port)) return 0;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port));
  XmlRpc::XmlRpcValue only_me, answer;
  only_me[0] = ros::this_node::getName();
  return client.execute("getPid", only_me, answer) ? static_cast<int>(answer[2]) : 0;
}

}  // namespace stillmap
