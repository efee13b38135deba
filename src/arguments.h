// The arguments of a kernel, of which not every variant has all.
#pragma once

#include <variant>

#include "opencl.h"

namespace gnomon {

/// Sets a kernel's arguments one after the other.
class Arguments {
  public:
    explicit Arguments(cl::Kernel& kernel) : kernel_(kernel) {}

    template <class... Values>
    Arguments& add(const Values&... values) {
        (set(values), ...);
        return *this;
    }
    /// Those of variants of which this is one, or is not.
    template <class... Values>
    Arguments& add_if(bool has, const Values&... values) {
        return has ? add(values...) : *this;
    }

  private:
    template <class Value>
    void set(const Value& value) {
        kernel_.setArg(index_++, value);
    }
    /// Of several types the one that it holds.
    template <class... Types>
    void set(const std::variant<Types...>& value) {
        std::visit([this](const auto& held) { set(held); }, value);
    }

    cl::Kernel& kernel_;
    cl_uint index_ = 0;
};

}  // namespace gnomon
