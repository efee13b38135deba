#include "json_parse.h"

#include <algorithm>

#include "error.h"

namespace gnomon {

using nlohmann::json;

namespace {

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

std::string child_path(const std::string& path, const std::string& key) {
    std::string token;
    for (const char c : shortened(key)) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return path + "/" + token;
}

std::string location(const std::string& file, const std::string& path) {
    return file + ": " + (path.empty() ? "top level" : path);
}

}  // namespace gnomon
