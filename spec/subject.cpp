#include "spec/subject.h"

namespace selvage::spec {

Subject built_in(selvage_profile profile) {
  return {"selvage " + std::string(selvage_version()), selvage_draw, profile,
          /*nearest_only=*/false, Prepare{selvage_prepare, selvage_prepare_bytes}};
}

}  // namespace selvage::spec
