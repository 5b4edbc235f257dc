#pragma once

#include <string>

#include "run/terminal/work_options.h"
#include "web/drawn_run.h"
#include "web/page_run.h"

namespace fumon {

/// The page of a run, HTML in one file, which any browser opens from a disk and which loads
/// nothing: its beds to turn and to pass through time, its scene, and a picture for browsers
/// without WebGL. Says on standard error what was left out and to what heights are rounded. Throws
/// as drawn_run().
std::string page_file(const PageRun& run, const PageOptions& options, const WorkOptions& work);

/// The same of beds that are drawn already; `height_step` gets the metres (or model heights) to
/// which heights are rounded.
std::string run_page(const PageRun& run, DrawnRun drawn, double& height_step);

}  // namespace fumon
