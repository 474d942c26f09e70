// OpenCV's image warps as a subject.
#pragma once

#include "reports/bench/subject.h"

namespace selvage::reports {

[[nodiscard]] Subject subject_opencv();

// What cv::getBuildInformation says.
[[nodiscard]] std::string opencv_build_information();

}  // namespace selvage::reports
