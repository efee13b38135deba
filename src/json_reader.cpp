#include "json_reader.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numeric>

#include "error.h"

namespace gnomon {
namespace {

using nlohmann::json;

/// Cut at a character's border, with every byte that is not plain ASCII escaped: safe for any terminal.
std::string shortened(std::string text) {
    const std::size_t limit = 40;
    const bool cut = text.size() > limit;
    if (cut) {
        std::size_t end = limit;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
        text.resize(end);
    }
    const std::string escaped = json(text).dump(-1, ' ', true, json::error_handler_t::replace);
    return escaped.substr(1, escaped.size() - 2) + (cut ? "..." : "");
}

/// The JSON pointer (RFC 6901) of a member.
std::string child_path(const std::string& path, const std::string& key) {
    std::string token;
    for (const char c : shortened(key)) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return path + "/" + token;
}

std::string location(const std::string& file, const std::string& path) {
    return file + ": " + (path.empty() ? "top level" : path);
}

/// A byte's place in a text: line and column, both from 1, and what is near it on its line.
struct Place {
    Place(const std::string& text, std::size_t offset) {
        const auto at = text.begin() + static_cast<std::ptrdiff_t>(offset);
        line = 1 + std::count(text.begin(), at, '\n');
        const std::size_t start = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;  // npos + 1 is 0
        column = offset - start + 1;
        const std::size_t first = std::min(text.find_first_not_of(" \t", start), offset);  // after the indentation
        const std::size_t from = std::max(first, offset - std::min<std::size_t>(offset, 20));
        const std::size_t to = std::min(text.find_first_of("\r\n", offset), offset + 10);
        near_text = offset < text.size() ? text.substr(from, to - from) : "";
    }
    std::string str() const { return std::to_string(line) + ":" + std::to_string(column); }

    std::ptrdiff_t line;
    std::size_t column;
    std::string near_text;  ///< empty at the end of the text
};

/// Builds the tree from the parser's events, with an eye on what nlohmann's own builder lets pass: equal keys in one
/// object, of which it would silently keep the last.
class TreeBuilder : public nlohmann::json_sax<json> {
  public:
    TreeBuilder(const std::string& text, const std::string& file) : text_(text), file_(file) {}

    json root;

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(json::number_integer_t value) override { return add(value); }
    bool number_unsigned(json::number_unsigned_t value) override { return add(value); }
    bool number_float(json::number_float_t value, const std::string&) override { return add(value); }
    bool string(std::string& value) override { return add(std::move(value)); }
    bool binary(json::binary_t&) override { return false; }  // JSON text has none
    bool start_object(std::size_t) override { return open(json::object()); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(std::string& key) override {
        Frame& object = open_.back();
        if (object.value->contains(key)) {
            throw Error(Blame::input, "found the key " + quote(key) + " twice, expected each key once in an object",
                        location(file_, path(open_.size() - 1)));
        }
        object.key = std::move(key);
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token, const json::exception& error) override {
        const Place place(text_, std::min(position - std::min<std::size_t>(position, 1), text_.size()));
        const std::string where = file_ + ":" + place.str();
        const int number_out_of_range = 406;
        if (error.id == number_out_of_range) {
            throw Error(Blame::input, "found " + shortened(token) + ", expected a finite number",
                        location(where, path(open_.size())));
        }
        const std::string near_what = place.near_text.empty() ? "the end of the file" : quote(place.near_text);
        throw Error(Blame::input, "not valid JSON: " + reason(error.what(), token) + ", near " + near_what, where);
    }

  private:
    struct Frame {
        json* value;
        std::string key;  ///< an object's latest
    };

    /// nlohmann's words without its exception's name, its count of lines and the token, which may be long.
    static std::string reason(std::string message, const std::string& token) {
        const std::size_t start = message.find("syntax error");
        if (start != std::string::npos) message.erase(0, start);
        const std::string last_read = "; last read: '" + token + "'";
        const std::size_t at = message.find(last_read);
        if (at != std::string::npos) message.erase(at, last_read.size());
        // Where an object or array may end a comma may stand as well, and it is the comma that gets forgotten.
        for (const std::string end : {"'}'", "']'"}) {
            const std::size_t expected = message.rfind("; expected " + end);
            if (expected != std::string::npos) message.replace(expected, std::string::npos, "; expected ',' or " + end);
        }
        return message;
    }

    /// Pointers into the tree stay good: an array or object grows only while none of its children is open.
    json* place(json value) {
        if (open_.empty()) return &(root = std::move(value));
        Frame& parent = open_.back();
        if (parent.value->is_object()) return &((*parent.value)[parent.key] = std::move(value));
        parent.value->push_back(std::move(value));
        return &parent.value->back();
    }
    bool add(json value) { return place(std::move(value)) != nullptr; }
    bool open(json value) {
        json* const placed = place(std::move(value));
        open_.push_back({placed, ""});
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    /// The path through the first `depth` open values: to the value that comes next if that is all of them.
    /// Only its last steps if it is long, for the depth is in the hands of the file.
    std::string path(std::size_t depth) const {
        const std::size_t most_steps = 8;
        const std::size_t first = depth - std::min(depth, most_steps);
        std::string result = first > 0 ? "..." : "";
        for (std::size_t i = first; i < depth; ++i) {
            const Frame& frame = open_[i];
            const bool child_is_placed = i + 1 < open_.size();
            const std::size_t index = frame.value->size() - (child_is_placed ? 1 : 0);
            result = child_path(result, frame.value->is_object() ? frame.key : std::to_string(index));
        }
        return result;
    }

    const std::string& text_;
    const std::string& file_;
    std::vector<Frame> open_;
};

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

json parse_json(const std::string& text, const std::string& file) {
    const std::string byte_order_mark = "\xEF\xBB\xBF";
    const bool has_mark = text.compare(0, byte_order_mark.size(), byte_order_mark) == 0;
    const std::string body = has_mark ? text.substr(byte_order_mark.size()) : text;
    if (body.find_first_not_of(" \t\r\n") == std::string::npos) {
        throw Error(Blame::input, "found an empty file, expected JSON", file);
    }
    TreeBuilder builder(body, file);
    json::sax_parse(body, &builder);
    return std::move(builder.root);
}

std::string quote(const std::string& text) { return '"' + shortened(text) + '"'; }

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
