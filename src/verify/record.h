// What pictures must be: fingerprints by picture, as recorded.json has them.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "fingerprint.h"
#include "picture.h"

namespace gnomon::verify {

/// The radiance of one light alone, SHA-1: tells a wrong shadow from wrong shading, and one light from another.
struct LightPrint {
    std::string shaded;    ///< without shadows
    std::string shadowed;  ///< with them
};

struct Print {
    Fingerprint picture;
    std::vector<LightPrint> lights;
};

/// By picture_name().
using Record = std::map<std::string, Print>;

/// Told what is under way.
using Say = std::function<void(const std::string&)>;

/// Renders all cases, full and quick, in all recorded_modes(). Throws Error(Blame::input) unless the device has fp64.
Record record(const DeviceInfo& device, const Say& say);

/// The record that the program carries with it.
const Record& recorded();

/// One line a picture, so that a change of one shows as one.
std::string to_text(const Record& record);
/// Throws Error with the name and the JSON path of what is wrong.
Record parse_record(const std::string& text, const std::string& name);

}  // namespace gnomon::verify
