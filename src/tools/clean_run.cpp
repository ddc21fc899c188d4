#include "tools/clean_run.hpp"

#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <stdexcept>

#include "io/atomic_file.hpp"
#include "io/tile_folder.hpp"
#include "messages/bag_topics.hpp"
#include "messages/bounded_message.hpp"
#include "messages/labelled_cloud.hpp"
#include "messages/point_cloud_conversion.hpp"
#include "stillmap/mapper.hpp"
#include "tools/label_store.hpp"
#include "tools/progress_bar.hpp"
#include "tools/run_summary.hpp"
#include "tools/say.hpp"

namespace stillmap {
namespace {

namespace fs = std::filesystem;

/// Labels of the clouds that have a pose, by their topic and their place among its clouds.
class LabelledClouds {
 public:
  LabelledClouds(LidarsInBag& sequence, const Parameters& parameters, const CleanJob& job)
      : sequence_(sequence),
        job_(job),
        far_tiles_(open_tile_folder(parameters, say)),
        mapper_(parameters),
        store_(folder_of(job.out)) {
    mapper_.set_tile_store(far_tiles_.get());
    ProgressBar progress("labelling", sequence.size());
    for (std::size_t k = 0; k < sequence.size(); ++k, progress.advance()) {
      const Frame frame = sequence.read(k);
      store_.append(mapper_.process(frame.scan, frame.T_map_sensor));
      const LidarsInBag::Cloud cloud = sequence.cloud_of(k);
      frame_of_cloud_[{cloud.topic, cloud.number}] = k;
    }
  }

  /// Of the next cloud of a topic.
  ScanLabels next(const std::string& topic, const sensor_msgs::PointCloud2& message) {
    const auto found = frame_of_cloud_.find({topic, clouds_seen_[topic]++});
    if (found == frame_of_cloud_.end()) return all_uncertain(message);
    const ScanLabels labels = store_.read(found->second);
    if (job_.online) return labels;
    const Frame frame = sequence_.read(found->second);
    return mapper_.relabel(frame.scan, frame.T_map_sensor, labels);
  }

 private:
  static std::string folder_of(const std::string& file) {
    const fs::path folder = fs::absolute(file).parent_path();
    if (!fs::is_directory(folder))
      throw std::runtime_error(file + ": cannot be written: there is no folder " + folder.string());
    return folder.string();
  }
  static ScanLabels all_uncertain(const sensor_msgs::PointCloud2& message) {
    Scan scan;
    to_scan(message, scan);  // its layout must hold
    const std::size_t rows = scan.points.size();
    return {std::vector<Label>(rows, Label::kUncertain), std::vector<float>(rows, 0.5F),
            std::vector<Reason>(rows, Reason::kNeverJudged), std::vector<std::int32_t>(rows, kNoObject)};
  }

  LidarsInBag& sequence_;
  const CleanJob& job_;
  std::unique_ptr<TileFolder> far_tiles_;
  Mapper mapper_;
  LabelStore store_;
  std::map<std::pair<std::string, std::size_t>, std::size_t> frame_of_cloud_;
  std::map<std::string, std::size_t> clouds_seen_;
};

/// Writes messages as they are, or a cloud in its place: same topic, time and connection.
class BagCopy {
 public:
  BagCopy(const std::string& file, const CleanJob& job) : job_(job) {
    bag_.open(file, rosbag::bagmode::Write);
  }

  void keep(const rosbag::MessageInstance& message) {
    bag_.write(message.getTopic(), message.getTime(), message, message.getConnectionHeader());
  }
  void clean(const rosbag::MessageInstance& message, const sensor_msgs::PointCloud2& cloud,
             const ScanLabels& labels) {
    totals_.add(labels);
    if (job_.form == CleanForm::kSplit) {
      keep(message);
      write(message, "/static", select_rows(cloud, labels, Label::kStatic));
      write(message, "/dynamic", select_rows(cloud, labels, Label::kDynamic));
      write(message, "/uncertain", select_rows(cloud, labels, {Label::kUncertain, Label::kInvalid}));
    } else if (job_.form == CleanForm::kLabels) {
      write(message, "", add_label_fields(cloud, labels));
    } else {
      write(message, "", without_movers(cloud, labels));
    }
  }
  const LabelTotals& totals() const { return totals_; }

 private:
  sensor_msgs::PointCloud2Ptr without_movers(const sensor_msgs::PointCloud2& cloud,
                                             const ScanLabels& labels) const {
    if (job_.form == CleanForm::kMasked)
      return mask_rows(cloud, labels,
                       job_.static_only ? LabelSet{Label::kDynamic, Label::kUncertain} : Label::kDynamic);
    return select_rows(cloud, labels,
                       job_.static_only ? LabelSet{Label::kStatic}
                                        : LabelSet{Label::kStatic, Label::kUncertain, Label::kInvalid});
  }
  void write(const rosbag::MessageInstance& message, const std::string& suffix,
             const sensor_msgs::PointCloud2Ptr& cloud) {
    bag_.write(message.getTopic() + suffix, message.getTime(), *cloud, message.getConnectionHeader());
  }

  const CleanJob& job_;
  rosbag::Bag bag_;
  LabelTotals totals_;
};

void copy_bag(const std::vector<std::string>& topics, LabelledClouds& labels, const CleanJob& job,
              const std::string& file, LabelTotals& totals) {
  rosbag::Bag in;
  open_for_reading(in, job.in);
  rosbag::View view(in);
  BagCopy out(file, job);
  ProgressBar progress("writing", view.size());
  for (const rosbag::MessageInstance& message : view) {
    const bool chosen = std::find(topics.begin(), topics.end(), message.getTopic()) != topics.end();
    const sensor_msgs::PointCloud2ConstPtr points =
        chosen ? read_message<sensor_msgs::PointCloud2>(message) : nullptr;
    if (points == nullptr)
      out.keep(message);
    else
      out.clean(message, *points, labels.next(message.getTopic(), *points));
    progress.advance();
  }
  totals = out.totals();
}

}  // namespace

void require_another_file(const std::string& in, const std::string& out) {
  if (fs::exists(out) && fs::equivalent(in, out))
    throw std::runtime_error(out + ": is the bag that is read; name another file for OUT");
}

void clean_bag(LidarsInBag& sequence, const Parameters& parameters, const CleanJob& job) {
  LabelledClouds labels(sequence, parameters, job);
  LabelTotals totals;
  write_atomically(job.out, [&](const std::string& file) {
    try {
      copy_bag(sequence.cloud_topics(), labels, job, file, totals);
    } catch (const rosbag::BagException& error) {
      throw std::runtime_error(job.out + ": the bag cannot be copied: " + error.what());
    }
  });
  std::cout << job.out << ":";
  for (const std::string& topic : sequence.cloud_topics()) std::cout << ' ' << topic;
  std::cout << ", " << totals.scans << " clouds, " << totals.counts.is_static << " static, "
            << totals.counts.dynamic << " dynamic and " << totals.counts.uncertain << " uncertain points\n";
}

}  // namespace stillmap
