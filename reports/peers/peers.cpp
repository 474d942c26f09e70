#include "reports/bench/subject.h"

#ifdef SELVAGE_REPORTS_OPENCV
#include "reports/peers/opencv.h"
#endif

namespace selvage::reports {

Peers peers() {
  Peers found;
#ifdef SELVAGE_REPORTS_OPENCV
  found.subjects.push_back(subject_opencv());
  found.build_information["OpenCV"] = opencv_build_information();
#else
  found.absent.push_back("OpenCV: not found when this was configured");
#endif
  return found;
}

}  // namespace selvage::reports
