// Text files as lines, lines as words, words as numbers.
#pragma once

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "json_parse.h"

namespace gnomon {

/// Of ASCII letters; all else stays.
inline std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

/// Text from a file, which may be very long, as a message shows it.
inline std::string quote_start(std::string_view text) {
    constexpr size_t most = 64;  // no less than quote() leaves
    return quote(std::string(text.substr(0, most)));
}

/// The longest line of a header, in bytes: a comment, or the columns' names, hundred thousand of them. Only so far is a
/// line's end looked for, since a damaged file may have none in all its terabytes.
constexpr size_t longest_header_line = size_t{1} << 20;

/// The lines of a text, one after another. They end with a line feed, or with a carriage return before it.
class TextLines {
  public:
    explicit TextLines(std::string_view text) : rest_(text) {}

    /// Goes on to the next line; false at the text's end.
    bool next(std::string_view& line) {
        if (rest_.empty()) return false;
        const void* feed = std::memchr(rest_.data(), '\n', rest_.size());
        const size_t size = feed ? static_cast<size_t>(static_cast<const char*>(feed) - rest_.data()) : rest_.size();
        line = rest_.substr(0, size);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        rest_.remove_prefix(feed ? size + 1 : size);
        ++number_;
        return true;
    }

    /// Whether the next line ends within so many bytes.
    bool ends_within(size_t most) const {
        return rest_.size() <= most || std::memchr(rest_.data(), '\n', most) != nullptr;
    }

    int64_t number() const { return number_; }  ///< of the latest line, from 1
    std::string_view rest() const { return rest_; }

  private:
    std::string_view rest_;
    int64_t number_ = 0;
};

/// The words of a line, between spaces and tabs.
class Words {
  public:
    explicit Words(std::string_view line) : at_(line.data()), end_(line.data() + line.size()) {}

    /// The next word; empty after the last.
    std::string_view next() {
        while (at_ != end_ && is_space(*at_)) ++at_;
        const char* start = at_;
        while (at_ != end_ && !is_space(*at_)) ++at_;
        return {start, static_cast<size_t>(at_ - start)};
    }

  private:
    static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

    const char* at_;
    const char* end_;
};

/// The least bytes that so many words take: a character each, and spaces or line ends between them.
constexpr int64_t least_bytes(int64_t words) { return 2 * words - 1; }

/// Whether from_chars called a number out of range that is only too small; its rounded value is 0.
inline bool rounds_to_zero(const char* begin, const char* end) {
    long double number = 0;  // whose range is so much larger that it tells the one from the other
    return std::from_chars(begin, end, number).ec == std::errc() && number > -1 && number < 1;
}

/// Reads a word that is a number and nothing else, whatever the locale; a float is rounded once. False if it is none,
/// or is beyond what T can hold.
template <class T>
bool parse(std::string_view word, T& number) {
    const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';  // which from_chars does not know
    const char *begin = word.data() + (has_plus ? 1 : 0), *end = word.data() + word.size();
    const auto result = std::from_chars(begin, end, number);
    if (result.ptr != end) return false;
    if (result.ec == std::errc()) return true;
    number = 0;
    return std::is_floating_point_v<T> && result.ec == std::errc::result_out_of_range && rounds_to_zero(begin, end);
}

}  // namespace gnomon
