// Bytes -> a case -> every law that its profile promises, on the mapper this program is linked
// with.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/laws_limits.h"
#include "spec/case.h"
#include "spec/laws.h"
#include "spec/profiles.h"
#include "spec/subject.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  namespace spec = selvage::spec;
  static const spec::Subject mapper = spec::built_in();
  const spec::Case raw = spec::decode({data, size});
  if (!selvage::fuzz::is_taken(raw)) return -1;
  // Random positions are hardly ever whole pixels, which historic profiles want: TOTAL and MEM have
  // their say about such cases, the others about what is acceptable.
  spec::Case acceptable = raw;
  spec::make_acceptable(spec::profile_of(raw), acceptable.vertices);
  if (!spec::can_be_filtered(raw)) acceptable.filter = SELVAGE_FILTER_NEAREST;
  for (const spec::Law& law : spec::laws()) {
    if (!spec::is_promised(raw.profile, law.name)) continue;
    const spec::Case& c = law.name == "TOTAL" || law.name == "MEM" ? raw : acceptable;
    const spec::Judgement judgement = law.check(mapper, c);
    if (!judgement.violation) continue;
    std::fprintf(stderr, "%s\nreplay: selvage verify --law %s --case %s\n",
                 spec::explain(*judgement.violation).c_str(), judgement.violation->law.c_str(),
                 spec::to_hex(c).c_str());
    std::abort();
  }
  return 0;
}
