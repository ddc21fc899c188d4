#include "tools/clean_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "tools/clean_run.hpp"
#include "tools/open_bag.hpp"
#include "tools/parameter_options.hpp"

namespace stillmap {
namespace {

struct CleanOptions {
  SequenceOptions bag;
  ParameterOptions parameters;
  CleanJob job;
};

const std::map<std::string, CleanForm> kForms = {{"removed", CleanForm::kRemoved},
                                                 {"masked", CleanForm::kMasked},
                                                 {"split", CleanForm::kSplit},
                                                 {"labels", CleanForm::kLabels}};

void clean(CleanOptions& options) {
  const Parameters parameters = options.parameters.resolve();
  require_another_file(options.bag.path, options.job.out);
  options.job.in = options.bag.path;
  clean_bag(*open_bag(options.bag), parameters, options.job);
}

}  // namespace

void add_clean_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "clean", "Copy a bag, all its topics, and take the moving points out of one cloud topic");
  const auto options = std::make_shared<CleanOptions>();
  command->add_option("IN", options->bag.path, "The .bag")->required()->check(CLI::ExistingFile);
  command->add_option("OUT", options->job.out, "The .bag to write")->required();
  options->bag.add_bag_options_to(*command);
  command
      ->add_option("--as", options->job.form,
                   "removed: the cloud without its moving rows. masked: they stay, with NaN for x, y and z. "
                   "split: the cloud stays, and TOPIC/static, /dynamic and /uncertain are added. labels: "
                   "the cloud with the fields p_static, label and reason")
      ->transform(CLI::CheckedTransformer(kForms).description("removed|masked|split|labels"))
      ->default_str("removed");
  command->add_flag("--static-only", options->job.static_only,
                    "With removed and masked: take out what is uncertain, too");
  command->add_flag(
      "--online", options->job.online,
      "Labels as the nodelet gives them at each scan's time, not by the map after the last scan");
  options->parameters.add_to(*command);
  command->callback([options] { clean(*options); });
}

}  // namespace stillmap
