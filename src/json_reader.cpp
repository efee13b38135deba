#include "json_reader.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numeric>

#include "error.h"

namespace gnomon {

using nlohmann::json;

namespace {

/// Levenshtein's distance, one row at a time.
std::size_t edits(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}

/// A question after the nearest key, or nothing: two edits make a slip, but not of a word that is hardly longer.
std::string did_you_mean(const std::string& key, const std::vector<std::string>& allowed) {
    const auto distance = [&](const std::string& a) { return edits(key, a); };
    const auto nearer = [&](const std::string& a, const std::string& b) { return distance(a) < distance(b); };
    const auto best = std::min_element(allowed.begin(), allowed.end(), nearer);
    const bool close = best != allowed.end() && distance(*best) <= std::min<std::size_t>(2, best->size() / 2);
    return close ? "did you mean " + quote(*best) + "?" : "";
}

std::string list(const std::vector<std::string>& keys) {
    std::string result;
    for (const std::string& key : keys) result += (result.empty() ? "" : ", ") + quote(key);
    return result;
}

bool is_short_list(const json& value) {
    const auto is_plain = [](const json& element) { return element.is_number() || element.is_boolean(); };
    return value.is_array() && value.size() <= 4 && std::all_of(value.begin(), value.end(), is_plain);
}

}  // namespace

void JsonReader::expect_object(const std::string& what, const Keys& required, const Keys& optional) const {
    Keys allowed = required;
    allowed.insert(allowed.end(), optional.begin(), optional.end());
    if (!value_.is_object()) refuse(what + ": an object with " + list(required));
    for (const auto& member : value_.items()) {
        if (std::find(allowed.begin(), allowed.end(), member.key()) != allowed.end()) continue;
        throw Error(Blame::input,
                    "found the unknown key " + quote(member.key()) + ", expected " + list(allowed) + " in " + what,
                    where(), did_you_mean(member.key(), allowed));
    }
    for (const std::string& key : required) {
        if (has(key)) continue;
        throw Error(Blame::input, "found no key " + quote(key) + ", expected " + list(required) + " in " + what,
                    where());
    }
}

std::size_t JsonReader::array_size() const {
    if (!value_.is_array()) refuse("an array");
    return value_.size();
}

JsonReader JsonReader::operator[](const std::string& key) const {
    return {value_.at(key), file_, child_path(path_, key)};
}

JsonReader JsonReader::operator[](std::size_t index) const {
    return {value_.at(index), file_, child_path(path_, std::to_string(index))};
}

std::string JsonReader::text() const {
    if (!value_.is_string()) refuse("a string");
    return value_.get<std::string>();
}

double JsonReader::number() const {
    if (!value_.is_number()) refuse("a number");
    const double number = value_.get<double>();
    if (std::abs(number) > double{FLT_MAX}) refuse("a number from -3.4028234e38 to 3.4028234e38 (single precision)");
    return number;
}

double JsonReader::positive() const {
    const double value = number();
    if (value <= 0) refuse("a number > 0");
    return value;
}

double JsonReader::non_negative() const {
    const double value = number();
    if (value < 0) refuse("a number >= 0");
    return value;
}

int JsonReader::integer(int low, int high) const {
    // As a double, for nlohmann has signed and unsigned 64-bit integers; these bounds are exact in either.
    const double value = value_.is_number_integer() ? value_.get<double>() : NAN;
    if (!(value >= low && value <= high)) {
        refuse("an integer from " + std::to_string(low) + " to " + std::to_string(high));
    }
    return static_cast<int>(value);
}

Vec3 JsonReader::vec3() const {
    expect_triple();
    return {(*this)[0].number(), (*this)[1].number(), (*this)[2].number()};
}

Rgb JsonReader::rgb() const {
    expect_triple();
    return {(*this)[0].non_negative(), (*this)[1].non_negative(), (*this)[2].non_negative()};
}

void JsonReader::expect_triple() const {
    if (!value_.is_array() || value_.size() != 3) refuse("an array of 3 numbers");
}

std::string JsonReader::where() const { return location(file_, path_); }

std::string JsonReader::found() const {
    if (value_.is_string()) return quote(value_.get<std::string>());
    if (value_.is_object()) return "an object";
    if (value_.is_array() && !is_short_list(value_)) return "an array of " + std::to_string(value_.size());
    return value_.dump();
}

void JsonReader::refuse(const std::string& expected) const {
    throw Error(Blame::input, "found " + found() + ", expected " + expected, where());
}

}  // namespace gnomon
