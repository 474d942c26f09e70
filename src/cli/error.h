// What the user can put right. The program prints it as "selvage: <what>" and exits with code 2.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace selvage::cli {

class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Calls `action`; a UserError that leaves it is given the name of what it is about in front.
template <typename Action>
auto about(const std::string& name, Action&& action) {
  try {
    return std::forward<Action>(action)();
  } catch (const UserError& error) {
    throw UserError(name + ": " + error.what());
  }
}

}  // namespace selvage::cli
