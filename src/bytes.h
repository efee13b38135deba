// Numbers as they lie in a file's bytes: anywhere, in either order.
#pragma once

#include <algorithm>
#include <cstring>

namespace gnomon {

/// The byte orders of files; which of them is this machine's decides what has to be turned around.
enum class ByteOrder { little, big };

constexpr ByteOrder host_order = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? ByteOrder::little : ByteOrder::big;

/// The number whose bytes begin here, at any address.
template <class T>
T load(const char* bytes, ByteOrder order) {
    char ordered[sizeof(T)];
    std::copy_n(bytes, sizeof(T), ordered);
    if (order != host_order) std::reverse(ordered, ordered + sizeof(T));
    T number;
    std::memcpy(&number, ordered, sizeof(T));
    return number;
}

}  // namespace gnomon
