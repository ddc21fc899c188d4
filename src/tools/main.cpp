#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "tools/diff_command.hpp"
#include "tools/evaluate_command.hpp"
#include "tools/explain_command.hpp"
#include "tools/export_command.hpp"
#include "tools/inject_command.hpp"
#include "tools/label_command.hpp"
#include "tools/merge_command.hpp"
#include "tools/parameters_command.hpp"
#include "tools/repair_command.hpp"
#include "tools/simulate_command.hpp"
#include "tools/soak_command.hpp"
#include "tools/stages_command.hpp"
#include "tools/version.hpp"
#if STILLMAP_WITH_ROS
#include "tools/bag_command.hpp"
#include "tools/clean_command.hpp"
#include "tools/doctor_command.hpp"
#include "tools/reference_command.hpp"
#endif

int main(int argc, char** argv) {
  CLI::App app{"Takes moving things out of LiDAR scans."};
  app.set_version_flag("--version",
                       std::string("stillmap ") + stillmap::kVersion + " (" + stillmap::kGitRevision + ")");
  app.require_subcommand(1);
  stillmap::add_label_command(app);
  stillmap::add_simulate_command(app);
  stillmap::add_soak_command(app);
  stillmap::add_evaluate_command(app);
  stillmap::add_inject_command(app);
  stillmap::add_export_command(app);
  stillmap::add_diff_command(app);
  stillmap::add_merge_command(app);
  stillmap::add_repair_command(app);
  stillmap::add_explain_command(app);
  stillmap::add_parameters_command(app);
  stillmap::add_stages_command(app);
#if STILLMAP_WITH_ROS
  stillmap::add_bag_command(app);
  stillmap::add_clean_command(app);
  stillmap::add_doctor_command(app);
  stillmap::add_reference_command(app);
#endif
  try {
    app.parse(argc, argv);
  } catch (const CLI::Error& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    std::cerr << "stillmap: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
