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

/// Which line of a kind goes through a pixel.
size_t line_at(size_t kind, size_t x, size_t y, size_t width) {
    switch (kind) {
        case 0:
            return y;
        case 1:
            return x;
        case 2:
            return (x + width - y % width) % width;
        default:
            return (x + y) % width;
    }
}

std::string short_hashes(const Film& film, size_t kind) {
    const auto width = static_cast<size_t>(film.width), height = static_cast<size_t>(film.height);
    std::vector<std::string> bytes(kind == 0 ? height : width);
    for (size_t p = 0; p < film.pixels(); ++p) {
        std::string& line = bytes[line_at(kind, p % width, p / width, width)];
        append(line, film.id[p]);
        for (size_t c = 0; c < float_channels.size(); ++c) append(line, plane_of(film, c)[p]);
    }
    std::string hashes;
    for (const std::string& line : bytes) hashes += sha1_hex(line).substr(0, digits);
    return hashes;
}

bool differs(const std::string& a, const std::string& b, size_t line) {
    return a.compare(line * digits, digits, b, line * digits, digits) != 0;
}

}  // namespace

Fingerprint fingerprint(const Film& film) {
    Fingerprint made;
    std::string ids;
    append(ids, film.id);
    made.sha1 = {sha1_hex(ids), sha1_of(film, Result::distance), sha1_of(film, Result::normal), radiance_sha1(film)};
    for (size_t kind = 0; kind < lines.size(); ++kind) made.shorts[kind] = short_hashes(film, kind);
    return made;
}

std::string radiance_sha1(const Film& film) { return sha1_of(film, Result::radiance); }

std::vector<Place> first_differing(const Fingerprint& a, const Fingerprint& b) {
    std::vector<Place> found;
    for (size_t kind = 0; kind < lines.size(); ++kind)
        if (a.shorts[kind].size() != b.shorts[kind].size()) return found;
    const size_t height = a.shorts[0].size() / digits, width = a.shorts[1].size() / digits;
    for (size_t y = 0; y < height && found.empty(); ++y)
        for (size_t x = 0; x < width; ++x) {
            size_t kind = 0;
            while (kind < lines.size() && differs(a.shorts[kind], b.shorts[kind], line_at(kind, x, y, width))) ++kind;
            if (kind == lines.size()) found.push_back({static_cast<int>(x), static_cast<int>(y)});
        }
    return found;
}

}  // namespace gnomon::verify
