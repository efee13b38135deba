// The one error type: what failed, where, and what to try.
#pragma once

#include <stdexcept>
#include <string>

namespace gnomon {

/// Whose fault it is, as the exit code says it: 1 the run failed, 2 the input or its use is wrong.
enum class Blame { run = 1, input = 2 };

/// Everything that the library throws on purpose.
/// `where` names a file, a line, a JSON path or a device; `hint` says what to try. Either may be empty.
class Error : public std::runtime_error {
  public:
    Error(Blame blame, const std::string& what_failed, const std::string& where = "", const std::string& hint = "")
        : std::runtime_error((where.empty() ? "" : where + ": ") + what_failed + (hint.empty() ? "" : "\n  " + hint)),
          blame_(blame) {}

    int exit_code() const { return static_cast<int>(blame_); }

  private:
    Blame blame_;
};

}  // namespace gnomon
