// The data of PLY files, number by number: from bytes or from text, by the same calls.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <type_traits>

#include "bytes.h"
#include "error.h"
#include "json_parse.h"
#include "ply_header.h"
#include "text_lines.h"

namespace gnomon {

/// One of an element's many, as messages begin.
struct PlyRecord {
    const std::string& path;
    const std::string& element;
    int64_t index;

    [[noreturn]] void refuse(const std::string& what) const {
        throw Error(Blame::input, what, fmt::format("{}: {} {}", path, shortened(element), index));
    }
};

/// Numbers as bytes.
class PlyBytes {
  public:
    PlyBytes(std::string_view bytes, ByteOrder order) : rest_(bytes), order_(order) {}

    void begin(const PlyRecord&) {}
    void end(const PlyRecord&) {}

    template <class T>
    T number(const PlyProperty& property, const PlyRecord& record) {
        return number<T>(property.type, record);
    }
    int64_t length(const PlyProperty& list, const PlyRecord& record) {
        return number<int64_t>(*list.length_type, record);
    }

    void skip(const PlyProperty& property, int64_t count, const PlyRecord& record) {
        const int64_t size = size_of(property.type);
        if (count > static_cast<int64_t>(rest_.size()) / size) record.refuse("the file ends here");
        rest_.remove_prefix(static_cast<size_t>(count * size));
    }

    std::string_view rest() const { return rest_; }

  private:
    template <class T>
    T number(PlyType type, const PlyRecord& record) {
        switch (type) {
            case PlyType::int8:
                return static_cast<T>(take<int8_t>(record));
            case PlyType::uint8:
                return static_cast<T>(take<uint8_t>(record));
            case PlyType::int16:
                return static_cast<T>(take<int16_t>(record));
            case PlyType::uint16:
                return static_cast<T>(take<uint16_t>(record));
            case PlyType::int32:
                return static_cast<T>(take<int32_t>(record));
            case PlyType::uint32:
                return static_cast<T>(take<uint32_t>(record));
            case PlyType::float32:
                return static_cast<T>(take<float>(record));
            case PlyType::float64:
                break;
        }
        return static_cast<T>(take<double>(record));
    }

    template <class T>
    T take(const PlyRecord& record) {
        if (rest_.size() < sizeof(T)) record.refuse("the file ends here");
        const T number = load<T>(rest_.data(), order_);
        rest_.remove_prefix(sizeof(T));
        return number;
    }

    std::string_view rest_;
    ByteOrder order_;
};

/// Numbers as words, each record on a line.
class PlyText {
  public:
    explicit PlyText(std::string_view text) : lines_(text) {}

    void begin(const PlyRecord& record) {
        std::string_view line;
        if (!lines_.next(line)) record.refuse("the file ends here");
        words_ = Words(line);
    }
    void end(const PlyRecord& record) {
        const std::string_view more = words_.next();
        if (!more.empty()) record.refuse("found " + quote_start(more) + " after the last property");
    }

    template <class T>
    T number(const PlyProperty& property, const PlyRecord& record) {
        return number<T>(property.type, property, record);
    }
    int64_t length(const PlyProperty& list, const PlyRecord& record) {
        return number<int64_t>(*list.length_type, list, record);
    }

    void skip(const PlyProperty& property, int64_t count, const PlyRecord& record) {
        for (; count > 0; --count) number<double>(property, record);
    }

    /// Blank lines at the end are nothing.
    std::string_view rest() const {
        const size_t start = lines_.rest().find_first_not_of(" \t\r\n");
        return start == std::string_view::npos ? std::string_view() : lines_.rest().substr(start);
    }

  private:
    template <class T>
    T number(PlyType type, const PlyProperty& property, const PlyRecord& record) {
        if (type == PlyType::float32) return static_cast<T>(word_as<float>(type, property, record));
        if (type == PlyType::float64) return static_cast<T>(word_as<double>(type, property, record));
        return static_cast<T>(word_as<int64_t>(type, property, record));
    }

    /// A word as its type has it: T holds that type's numbers, but where they are integers other ones too.
    template <class T>
    T word_as(PlyType type, const PlyProperty& property, const PlyRecord& record) {
        const std::string_view word = words_.next();
        T number{};
        bool good = parse(word, number);
        if constexpr (std::is_integral_v<T>) good = good && integers_of(type).hold(number);
        if (good) return number;
        if (word.empty()) record.refuse("the line ends before the last property");
        record.refuse("found " + shortened(property.name) + " " + quote_start(word) + ", expected " + expected(type));
    }

    static std::string expected(PlyType type) {
        if (type == PlyType::float32) return "a number from -3.4028234e38 to 3.4028234e38";
        if (type == PlyType::float64) return "a number from -1.7976931e308 to 1.7976931e308";
        const auto [low, high] = integers_of(type);
        return fmt::format("an integer from {} to {}", low, high);
    }

    TextLines lines_;
    Words words_{""};
};

}  // namespace gnomon
