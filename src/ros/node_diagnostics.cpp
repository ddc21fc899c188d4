#include "ros/node_diagnostics.hpp"

#include <numeric>

namespace stillmap {

NodeDiagnostics::NodeDiagnostics(ros::NodeHandle nh, ros::NodeHandle private_nh)
    : updater_(nh, private_nh, private_nh.getNamespace()), last_(Clock::now()) {
  updater_.setHardwareID("none");
  updater_.add("scans", this, &NodeDiagnostics::fill);
  updater_.add("setup", this, &NodeDiagnostics::fill_setup);
}

void NodeDiagnostics::update_if_due(const Status& status, const std::vector<Finding>& findings,
                                    std::size_t scans_examined) {
  if (Clock::now() - last_ < std::chrono::seconds(1)) return;
  last_ = Clock::now();
  status_ = status;
  findings_ = findings;
  scans_examined_ = scans_examined;
  updater_.force_update();
}

void NodeDiagnostics::fill(diagnostic_updater::DiagnosticStatusWrapper& out) {
  using diagnostic_msgs::DiagnosticStatus;
  const std::uint64_t dropped =
      std::accumulate(status_.dropped.begin(), status_.dropped.end(), std::uint64_t(0));
  if (dropped > dropped_before_)
    out.summaryf(DiagnosticStatus::WARN, "%lu scans dropped", (unsigned long)(dropped - dropped_before_));
  else if (status_.scans == scans_before_)
    out.summary(DiagnosticStatus::WARN, status_.waiting > 0 ? "scans wait for their pose" : "no scans come");
  else
    out.summary(DiagnosticStatus::OK, "scans are labelled");
  scans_before_ = status_.scans;
  dropped_before_ = dropped;
  out.add("scans", status_.scans);
  out.add("voxels", status_.voxels);
  out.add("latency_ms", status_.latency_ms);
  out.add("label_ms", status_.label_ms);
  out.add("process_ms", status_.process_ms);
  for (std::size_t i = 0; i < status_.stage_ms.size(); ++i)
    out.add("process_ms: " + status_.stages[i], status_.stage_ms[i]);
  out.add("waiting", status_.waiting);
  for (std::size_t i = 0; i < status_.dropped.size(); ++i)
    out.add("dropped: " + status_.drop_reasons[i], status_.dropped[i]);
}

void NodeDiagnostics::fill_setup(diagnostic_updater::DiagnosticStatusWrapper& out) {
  using diagnostic_msgs::DiagnosticStatus;
  out.add("scans examined", scans_examined_);
  if (findings_.empty()) {
    out.summary(DiagnosticStatus::OK, "the doctor found nothing");
    return;
  }
  out.summary(DiagnosticStatus::WARN, findings_.front().check + ": " + findings_.front().text);
  for (const Finding& finding : findings_) out.add(finding.check, finding.text);
}

}  // namespace stillmap
