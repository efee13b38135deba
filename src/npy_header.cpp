#include "npy_header.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "bytes.h"
#include "error.h"
#include "json_parse.h"
#include "text_lines.h"

namespace gnomon {

namespace {

constexpr std::string_view magic = "\x93NUMPY";
constexpr std::string_view spaces = " \t\r\n";
constexpr const char* ends_in_header = "the file ends in the header";
constexpr const char* shown_keys = "'descr', 'fortran_order', 'shape'";

/// The one Python literal that a header holds, {'descr': '<f4', 'fortran_order': False, 'shape': (3, 4), }: keys in any
/// order, spaces and a last comma as Python allows them, and nothing else.
class DictReader {
  public:
    DictReader(std::string_view text, const std::string& path) : rest_(text), path_(path) {}

    NpyHeader read() {
        expect('{');
        while (!take('}')) {
            read_member();
            if (take(',')) continue;
            expect('}');
            break;
        }
        if (!rest_after_spaces().empty()) refuse("the header's end");
        if (keys_.size() != 3) throw Error(Blame::input, found_keys() + shown_keys, path_);
        return header_;
    }

  private:
    void read_member() {
        const std::string key = read_string();
        if (!keys_.insert(key).second) throw Error(Blame::input, "found the key " + quote(key) + " twice", path_);
        expect(':');
        if (key == "descr")
            header_.descr = read_string();
        else if (key == "fortran_order")
            header_.fortran_order = read_bool();
        else if (key == "shape")
            header_.shape = read_shape();
        else
            throw Error(Blame::input, "found the unknown key " + quote(key) + " in the header, expected " + shown_keys,
                        path_);
    }

    std::string read_string() {
        rest_after_spaces();
        const char mark = rest_.empty() ? '\0' : rest_.front();
        const std::size_t end = mark == '\'' || mark == '"' ? rest_.find(mark, 1) : std::string_view::npos;
        if (end == std::string_view::npos) refuse("a string");
        const std::string text(rest_.substr(1, end - 1));
        rest_.remove_prefix(end + 1);
        return text;
    }

    bool read_bool() {
        if (take_word("False")) return false;
        if (take_word("True")) return true;
        refuse("True or False");
    }

    std::vector<int64_t> read_shape() {
        std::vector<int64_t> shape;
        expect('(');
        while (!take(')')) {
            shape.push_back(read_size());
            if (take(',')) continue;
            expect(')');
            break;
        }
        return shape;
    }

    int64_t read_size() {
        rest_after_spaces();
        int64_t size = 0;
        const auto result = std::from_chars(rest_.data(), rest_.data() + rest_.size(), size);
        if (result.ec != std::errc() || size < 0) refuse("a size from 0 to 9223372036854775807");
        rest_.remove_prefix(static_cast<std::size_t>(result.ptr - rest_.data()));
        if (!rest_.empty() && rest_.front() == 'L') rest_.remove_prefix(1);  // as Python 2 wrote long integers
        return size;
    }

    std::string_view rest_after_spaces() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(spaces), rest_.size()));
        return rest_;
    }
    bool take_word(std::string_view word) {
        if (rest_after_spaces().substr(0, word.size()) != word) return false;
        rest_.remove_prefix(word.size());
        return true;
    }
    bool take(char c) { return take_word({&c, 1}); }
    void expect(char c) {
        if (!take(c)) refuse(std::string("'") + c + "'");
    }

    std::string found_keys() const {
        std::string keys;
        for (const std::string& key : keys_) keys += (keys.empty() ? "" : ", ") + quote(key);
        return "found " + (keys.empty() ? "no keys" : keys) + " in the header, expected ";
    }
    [[noreturn]] void refuse(const std::string& expected) const {
        const std::string found = rest_.empty() ? "the header's end" : quote_start(rest_);
        throw Error(Blame::input, "found " + found + " in the header, expected " + expected, path_);
    }

    std::string_view rest_;
    const std::string& path_;
    NpyHeader header_;
    std::set<std::string> keys_;
};

/// The header's length takes 2 bytes in version 1, 4 in 2 and 3.
std::size_t bytes_of_length(std::string_view bytes, const std::string& path) {
    if (bytes.substr(0, magic.size()) != magic)
        throw Error(Blame::input, "found no NumPy array: the file does not begin with \\x93NUMPY", path);
    if (bytes.size() < magic.size() + 2) throw Error(Blame::input, ends_in_header, path);
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    const int major = byte(magic.size()), minor = byte(magic.size() + 1);
    if (major >= 1 && major <= 3 && minor == 0) return major == 1 ? 2 : 4;
    throw Error(Blame::input,
                "found version " + std::to_string(major) + "." + std::to_string(minor) +
                    " of the format, expected 1.0, 2.0 or 3.0",
                path);
}

}  // namespace

NpyHeader read_npy_header(std::string_view bytes, const std::string& path) {
    const std::size_t length_size = bytes_of_length(bytes, path);
    const std::size_t length_start = magic.size() + 2, start = length_start + length_size;
    if (bytes.size() < start) throw Error(Blame::input, ends_in_header, path);
    const char* at = bytes.data() + length_start;
    const std::size_t length =
        length_size == 2 ? load<uint16_t>(at, ByteOrder::little) : load<uint32_t>(at, ByteOrder::little);
    if (length > bytes.size() - start) throw Error(Blame::input, ends_in_header, path);
    NpyHeader header = DictReader(bytes.substr(start, length), path).read();
    header.data_start = start + length;
    return header;
}

}  // namespace gnomon
