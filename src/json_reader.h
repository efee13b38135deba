// Values of a JSON document, each with its place: what is wrong is refused by file and JSON path.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "json_parse.h"
#include "scene.h"

namespace gnomon {

/// One value of a document, with its file and JSON path. Every wrong value ends in Error(Blame::input), which says
/// what was found and what is expected. The document and the file's name must outlive it.
class JsonReader {
  public:
    using Keys = std::vector<std::string>;

    JsonReader(const nlohmann::json& value, const std::string& file, std::string path = "")
        : value_(value), file_(file), path_(std::move(path)) {}

    /// Checks that this is an object with all the required keys and no others but the optional ones.
    /// `what` names it in messages: "a sphere".
    void expect_object(const std::string& what, const Keys& required, const Keys& optional = {}) const;
    /// Checks that this is an array and returns its size.
    std::size_t array_size() const;

    bool is_object() const { return value_.is_object(); }
    bool has(const std::string& key) const { return value_.is_object() && value_.contains(key); }
    /// A member that is there, as expect_object() or has() told.
    JsonReader operator[](const std::string& key) const;
    JsonReader operator[](std::size_t index) const;

    std::string text() const;
    double number() const;                 ///< finite in single precision too
    double positive() const;               ///< a number > 0
    double non_negative() const;           ///< a number >= 0
    int integer(int low, int high) const;  ///< written as an integer: 1024.0 is none
    Vec3 vec3() const;
    Rgb rgb() const;  ///< three numbers >= 0

    /// The file and the path, as messages begin.
    std::string where() const;
    /// The value in a few words.
    std::string found() const;
    /// Throws: found this value, expected that.
    [[noreturn]] void refuse(const std::string& expected) const;

  private:
    void expect_triple() const;

    const nlohmann::json& value_;
    const std::string& file_;
    std::string path_;
};

}  // namespace gnomon
