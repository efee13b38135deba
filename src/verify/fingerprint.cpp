#include "fingerprint.h"

#include <algorithm>

#include "channels.h"
#include "sha1.h"

namespace gnomon::verify {

namespace {

constexpr size_t digits = 4;

template <class Value>
void append(std::string& bytes, const Value& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Value>
void append(std::string& bytes, const Plane<Value>& plane) {
    bytes.append(reinterpret_cast<const char*>(plane.data()), plane.size() * sizeof(Value));
}

std::string sha1_of(const Film& film, Result result) {
    std::string bytes;
    for (size_t c = 0; c < float_channels.size(); ++c)
        if (float_channels[c].result == result) append(bytes, plane_of(film, c));
    return sha1_hex(bytes);
}

/// Of `count` pixels, `step` apart.
std::string short_hash(const Film& film, size_t first, size_t count, size_t step) {
    std::string bytes;
    for (size_t i = 0; i < count; ++i) {
        append(bytes, film.id[first + i * step]);
        for (size_t c = 0; c < float_channels.size(); ++c) append(bytes, plane_of(film, c)[first + i * step]);
    }
    return sha1_hex(bytes).substr(0, digits);
}

}  // namespace

Fingerprint fingerprint(const Film& film) {
    Fingerprint made;
    std::string ids;
    append(ids, film.id);
    made.sha1 = {sha1_hex(ids), sha1_of(film, Result::distance), sha1_of(film, Result::normal), radiance_sha1(film)};
    const auto width = static_cast<size_t>(film.width), height = static_cast<size_t>(film.height);
    for (size_t j = 0; j < height; ++j) made.rows += short_hash(film, j * width, width, 1);
    for (size_t i = 0; i < width; ++i) made.columns += short_hash(film, i, height, width);
    return made;
}

std::string radiance_sha1(const Film& film) { return sha1_of(film, Result::radiance); }

std::vector<int> differing(const std::string& a, const std::string& b) {
    std::vector<int> places;
    const size_t count = std::max(a.size(), b.size()) / digits;
    for (size_t i = 0; i < count; ++i)
        if (a.size() != b.size() || a.compare(i * digits, digits, b, i * digits, digits) != 0)
            places.push_back(static_cast<int>(i));
    return places;
}

}  // namespace gnomon::verify
