#include "xyz_header.h"

#include <algorithm>
#include <optional>
#include <set>

#include "error.h"
#include "json_parse.h"
#include "text_lines.h"

namespace gnomon {

namespace {

constexpr std::string_view spaces = " \t\r", key_ends = "= \t\r";

std::string_view& skip_spaces(std::string_view& rest) {
    rest.remove_prefix(std::min(rest.find_first_not_of(spaces), rest.size()));
    return rest;
}

/// Takes what stands before an equals sign or a space off the front: a key, or a word of free text.
std::string take_key(std::string_view& rest) {
    const size_t end = std::min(rest.find_first_of(key_ends), rest.size());
    const std::string key(rest.substr(0, end));
    rest.remove_prefix(end);
    return key;
}

bool take_equals(std::string_view& rest) {
    if (skip_spaces(rest).substr(0, 1) != "=") return false;
    rest.remove_prefix(1);
    return true;
}

bool begins_pair(std::string_view rest) {
    take_key(rest);
    return take_equals(rest);
}

/// Takes a value off the front of key=value pairs: up to a space, or quoted. Empty where the next pair begins.
std::string take_value(std::string_view& rest, const std::string& where) {
    const size_t size = rest.size();
    const bool has_space = skip_spaces(rest).size() < size;
    if (has_space && begins_pair(rest)) return "";
    const bool quoted = !rest.empty() && rest.front() == '"';
    std::string value;
    size_t at = quoted ? 1 : 0;
    for (; at < rest.size() && (quoted ? rest[at] != '"' : spaces.find(rest[at]) == spaces.npos); ++at) {
        if (quoted && rest[at] == '\\' && at + 1 < rest.size()) ++at;
        value += rest[at];
    }
    if (quoted && at == rest.size())
        throw Error(Blame::input, "found no end of the quoted " + quote_start(rest), where);
    rest.remove_prefix(at + (quoted ? 1 : 0));
    return value;
}

/// The value of the key Properties among the pairs of a comment, which may as well be free text.
std::optional<std::string> properties_of(std::string_view comment, const std::string& where) {
    std::optional<std::string> properties;
    while (!skip_spaces(comment).empty()) {
        const std::string key = take_key(comment);
        if (!take_equals(comment)) continue;
        const std::string value = take_value(comment, where);
        if (lower_case(key) != "properties") continue;
        if (properties) throw Error(Blame::input, "found Properties twice", where);
        if (value.empty())
            throw Error(Blame::input, "found no value of Properties, expected columns as species:S:1:pos:R:3", where);
        properties = value;
    }
    return properties;
}

std::string take_field(std::string_view& fields) {
    const size_t end = std::min(fields.find(':'), fields.size());
    const std::string field(fields.substr(0, end));
    fields.remove_prefix(std::min(end + 1, fields.size()));
    return field;
}

struct KnownColumns {
    const char* name;
    XyzUse use;
    bool is_text;
    int64_t words;
};
constexpr KnownColumns known_columns[] = {{"species", XyzUse::species, true, 1},
                                          {"pos", XyzUse::position, false, 3},
                                          {"radius", XyzUse::radius, false, 1},
                                          {"color", XyzUse::color, false, 3}};

/// The columns of this name, if they are numbers where numbers are meant, and as many.
XyzColumns columns_of(const std::string& name, const std::string& type, int64_t words, const std::string& where) {
    for (const KnownColumns& known : known_columns) {
        if (name != known.name) continue;
        const bool fits = known.is_text ? type == "S" : type == "R" || type == "I";
        if (fits && words == known.words) return {known.use, words, type == "I"};
        throw Error(Blame::input,
                    "found " + quote(name + ":" + type + ":" + std::to_string(words)) + ", expected " +
                        quote(name + (known.is_text ? ":S:" : ":R:") + std::to_string(known.words)),
                    where);
    }
    return {XyzUse::skip, words};
}

std::vector<XyzColumns> parse_properties(const std::string& properties, const std::string& where) {
    std::vector<XyzColumns> columns;
    std::set<std::string> names;
    std::string_view rest = properties;
    while (!rest.empty()) {
        const std::string name = take_field(rest), type = take_field(rest), words = take_field(rest);
        int64_t count = 0;
        const bool is_type = type == "S" || type == "R" || type == "I" || type == "L";
        if (name.empty() || !is_type || !parse(words, count) || count < 1)
            throw Error(Blame::input,
                        "found " + quote(name + ":" + type + ":" + words) +
                            " in Properties, expected a name, a type (S, R, I or L) and a count from 1",
                        where);
        if (!names.insert(name).second)
            throw Error(Blame::input, "found " + quote(name) + " twice in Properties", where);
        columns.push_back(columns_of(name, type, count, where));
    }
    if (names.count("pos") == 0) throw Error(Blame::input, "found no \"pos\" in Properties", where);
    return columns;
}

}  // namespace

std::vector<XyzColumns> read_xyz_columns(std::string_view comment, const std::string& where) {
    const std::optional<std::string> properties = properties_of(comment, where);
    if (properties) return parse_properties(*properties, where);
    return {{XyzUse::species, 1}, {XyzUse::position, 3}, {XyzUse::rest, 0}};
}

}  // namespace gnomon
