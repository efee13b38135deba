#include "ply_header.h"

#include <algorithm>
#include <array>
#include <set>

#include "error.h"
#include "json_parse.h"
#include "text_lines.h"

namespace gnomon {

namespace {

struct TypeName {
    const char *old_name, *name;
    PlyType type;
    int size;
};

/// In the order of PlyType.
constexpr std::array<TypeName, 8> types{{{"char", "int8", PlyType::int8, 1},
                                         {"uchar", "uint8", PlyType::uint8, 1},
                                         {"short", "int16", PlyType::int16, 2},
                                         {"ushort", "uint16", PlyType::uint16, 2},
                                         {"int", "int32", PlyType::int32, 4},
                                         {"uint", "uint32", PlyType::uint32, 4},
                                         {"float", "float32", PlyType::float32, 4},
                                         {"double", "float64", PlyType::float64, 8}}};

struct FormatName {
    const char* name;
    PlyFormat format;
};
constexpr std::array<FormatName, 3> formats{{{"ascii", PlyFormat::ascii},
                                             {"binary_little_endian", PlyFormat::binary_little_endian},
                                             {"binary_big_endian", PlyFormat::binary_big_endian}}};

/// Reads the header line by line; every refusal names the line.
class HeaderReader {
  public:
    HeaderReader(std::string_view bytes, const std::string& path) : bytes_(bytes), lines_(bytes), path_(path) {}

    PlyHeader read() {
        constexpr std::string_view magic = "ply";
        if (bytes_.substr(0, magic.size()) != magic || next_line() != magic)
            throw Error(Blame::input, "found no PLY file: the first line is not \"ply\"", path_);
        next_statement();
        read_format();
        while (next_statement() != "end_header") read_statement();
        finish_element();
        header_.data_start = bytes_.size() - lines_.rest().size();
        return std::move(header_);
    }

  private:
    std::string_view next_line() {
        if (!lines_.ends_within(longest_header_line))
            throw Error(Blame::input, "found no line end within 1 MiB", path_ + line_name(lines_.number() + 1));
        if (!lines_.next(line_)) throw Error(Blame::input, "the file ends in the header: found no end_header", path_);
        line_ = line_.substr(0, line_.find_last_not_of(" \t\r") + 1);
        return line_;
    }

    /// Goes on to the next line that is no remark.
    std::string_view next_statement() {
        std::string_view keyword;
        do {
            keyword = Words(next_line()).next();
        } while (keyword == "comment" || keyword == "obj_info");
        return line_;
    }

    void read_format() {
        Words words(line_);
        const bool is_format = words.next() == "format";
        const std::string_view name = words.next();
        const auto named = [&](const FormatName& format) { return name == format.name; };
        const auto found = std::find_if(formats.begin(), formats.end(), named);
        if (!is_format || found == formats.end() || words.next() != "1.0" || !words.next().empty())
            refuse("\"format\" with ascii, binary_little_endian or binary_big_endian, and 1.0");
        header_.format = found->format;
    }

    void read_statement() {
        Words words(line_);
        const std::string_view keyword = words.next();
        if (keyword == "element")
            read_element(words);
        else if (keyword == "property")
            read_property(words);
        else
            refuse("element, property, comment, obj_info or end_header");
    }

    void read_element(Words words) {
        finish_element();
        PlyElement element{std::string(words.next()), 0, {}};
        const bool good = parse(words.next(), element.count) && element.count >= 0 && words.next().empty();
        if (!good) refuse("\"element\" with a name and a count from 0");
        if (!element_names_.insert(element.name).second) refuse("each element once");
        property_names_.clear();
        header_.elements.push_back(std::move(element));
    }

    void read_property(Words words) {
        if (header_.elements.empty()) refuse("an element before its properties");
        PlyProperty property{"", PlyType::int8, {}};
        std::string_view type = words.next();
        if (type == "list") {
            property.length_type = read_type(words.next());
            if (*property.length_type >= PlyType::float32) refuse("an integer type for a list's length");
            type = words.next();
        }
        property.type = read_type(type);
        property.name = words.next();
        if (property.name.empty() || !words.next().empty()) refuse("\"property\" with a type and a name");
        if (!property_names_.insert(property.name).second) refuse("each property of an element once");
        header_.elements.back().properties.push_back(std::move(property));
    }

    PlyType read_type(std::string_view word) const {
        const auto named = [&](const TypeName& type) { return word == type.old_name || word == type.name; };
        const auto found = std::find_if(types.begin(), types.end(), named);
        if (found == types.end()) refuse("a property's type: char, uchar, short, ushort, int, uint, float or double");
        return found->type;
    }

    /// An element of nothing takes no place, so nothing in the file could tell a lie about its count.
    void finish_element() const {
        if (header_.elements.empty() || !header_.elements.back().properties.empty()) return;
        throw Error(Blame::input, "element " + quote(header_.elements.back().name) + " has no properties", path_);
    }

    static std::string line_name(int64_t number) { return ": line " + std::to_string(number); }
    [[noreturn]] void refuse(const std::string& expected) const {
        throw Error(Blame::input, "found " + quote_start(line_) + ", expected " + expected,
                    path_ + line_name(lines_.number()));
    }

    std::string_view bytes_;
    TextLines lines_;
    const std::string& path_;
    std::string_view line_;
    PlyHeader header_{};
    std::set<std::string> element_names_, property_names_;  ///< the latter of the latest element
};

}  // namespace

int size_of(PlyType type) { return types[static_cast<size_t>(type)].size; }

PlyIntegers integers_of(PlyType type) {
    const bool is_signed = type == PlyType::int8 || type == PlyType::int16 || type == PlyType::int32;
    const int64_t count = int64_t{1} << 8 * size_of(type);
    return is_signed ? PlyIntegers{-count / 2, count / 2 - 1} : PlyIntegers{0, count - 1};
}

int64_t PlyElement::least_size(PlyFormat format) const {
    if (format == PlyFormat::ascii) return least_bytes(static_cast<int64_t>(properties.size()));
    int64_t size = 0;
    for (const PlyProperty& property : properties) size += size_of(property.length_type.value_or(property.type));
    return size;
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& path) { return HeaderReader(bytes, path).read(); }

}  // namespace gnomon
