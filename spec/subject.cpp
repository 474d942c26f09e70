#include "spec/subject.h"

namespace selvage::spec {

Subject built_in() { return {"selvage " + std::string(selvage_version()), selvage_draw}; }

}  // namespace selvage::spec
