#include "spec/subject.h"

namespace selvage::spec {

Subject built_in(selvage_profile profile) {
  return {"selvage " + std::string(selvage_version()), selvage_draw, profile, false,
          selvage_choose};
}

}  // namespace selvage::spec
