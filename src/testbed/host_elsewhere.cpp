// Where there is no Linux: guard pages, futexes and forks are its own.
#include "testbed/host.h"

namespace selvage::testbed {

struct Host::Keeper {};
struct Host::Blocks {};

Host::Host(const std::filesystem::path& library, std::chrono::nanoseconds)
    : name_(library.string()) {
  throw LibraryError("subjects in shared libraries are supported on Linux alone");
}
Host::~Host() = default;
selvage_status Host::draw(const selvage_image*, const selvage_rect*, const selvage_vertex*, size_t,
                          const selvage_texture*, const selvage_options*) {
  throw LibraryError("no library has been loaded");
}
std::string Host::load() { return {}; }
void Host::begin_case() {}
void Host::start_anew() {}
spec::Subject Host::subject(const std::shared_ptr<Host>&) { return {}; }
bool Host::tells_claims() const { return false; }
std::string Host::printed() const { return {}; }

}  // namespace selvage::testbed
