// Files of spheres that are refused, and the reasons given.
#pragma once

#include <string>
#include <vector>

#include "catch.h"
#include "scenes.h"
#include "sphere_files.h"
#include "sphere_io.h"

namespace gnomon::test {

struct Damaged {
    std::string bytes;
    std::vector<std::string> fragments;  ///< of the message
};

constexpr int wrong_input = 2;

inline void check_refused(const std::string& name, const std::vector<Damaged>& files,
                          const SphereDefaults& defaults = {}) {
    const TempFolder folder;
    for (const Damaged& file : files) {
        const std::string path = folder.write(name, file.bytes);
        const std::string message = refusal(wrong_input, [&] { load_spheres(path, defaults); });
        INFO(message);
        CHECK(message.rfind(path + ": ", 0) == 0);
        CHECK(message.size() < path.size() + 300);
        for (const std::string& fragment : file.fragments) {
            INFO("expected in the message: " << fragment);
            CHECK(contains(message, fragment));
        }
    }
}

inline std::string ply(const std::string& body, const std::string& format = "ascii") {
    return "ply\nformat " + format + " 1.0\n" + body;
}

inline const std::string vertices =
    "property float x\nproperty float y\nproperty float z\nproperty float radius\nend_header\n";
inline const std::string long_line((1 << 20) + 1, '0');  // longer than any of a header
inline const std::string two = "element vertex 2\n" + vertices;
inline const std::string little = "binary_little_endian";

}  // namespace gnomon::test
