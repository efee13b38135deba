// Strict JSON: a parser that refuses what would be guesswork.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace gnomon {

/// Parses one document; a byte order mark at its start is skipped. `file` stands for the file in messages.
/// Throws Error(Blame::input) for broken JSON, a key that comes twice in an object, or a number beyond double.
nlohmann::json parse_json(const std::string& text, const std::string& file);

/// Text from outside, fit for a message: in quotes, escaped to ASCII, and shortened.
std::string quote(const std::string& text);
/// The same without quotes.
std::string shortened(std::string text);

/// The JSON pointer (RFC 6901) of a member.
std::string child_path(const std::string& path, const std::string& key);
/// A file and a JSON path, as messages begin.
std::string location(const std::string& file, const std::string& path);

}  // namespace gnomon
