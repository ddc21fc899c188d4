#pragma once

#include <string>

namespace stillmap {

/// Draws the figures and the page of a report with plot_report.py, which lies beside the executable. Throws
/// std::runtime_error when that does not work; the report's tables are there all the same.
void plot_report(const std::string& report_folder);

}  // namespace stillmap
