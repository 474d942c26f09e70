// What the tests of `selvage verify` share that judge libraries.
#pragma once

#include <sstream>
#include <string>

#include "cli/verify_command.h"
#include "support.h"

namespace selvage::cli::test {

[[nodiscard]] inline std::string library(const std::string& name) {
  return SELVAGE_SUBJECTS "/" + name + ".so";
}

class VerifySubject : public InDirectory {
 protected:
  VerifySubject() {
    options_.cases = "30";
    options_.seed = "5";
    options_.subject.call_limit = "20";
  }

  int run(const std::string& name) {
    out_.str("");
    err_.str("");
    options_.subject.library = library(name);
    return run_verify(options_, spec::built_in(), {out_, err_});
  }
  [[nodiscard]] std::string out() const { return out_.str(); }
  [[nodiscard]] std::string err() const { return err_.str(); }

  VerifyOptions options_;

 private:
  std::ostringstream out_, err_;
};

}  // namespace selvage::cli::test
