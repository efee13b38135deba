#include "verify.h"

#include <fmt/core.h>

#include "clock.h"
#include "error.h"
#include "suspect.h"

namespace gnomon::verify {

namespace {

const Print& expected_print(const Record& record, const std::string& picture) {
    const auto found = record.find(picture);
    if (found == record.end())
        throw Error(Blame::run, "the record has no such picture", picture, "record anew: gnomon verify --record FILE");
    return found->second;
}

std::vector<std::string> notes_about(const DeviceInfo& device) {
    if (device.fp64) return {};
    return {"double is not tried: the device lacks cl_khr_fp64; certified decides exactly what float leaves open"};
}

Difference difference(const std::string& picture, size_t scene, const Mode& mode, const Fingerprint& found,
                      const Fingerprint& expected) {
    Difference made{
        scene, mode, picture, {}, differing(found.rows, expected.rows), differing(found.columns, expected.columns),
        "",    {}};
    for (size_t r = 0; r < results.size(); ++r)
        if (found.sha1[r] != expected.sha1[r]) made.results.push_back(results[r]);
    return made;
}

void compare(Renderer& renderer, const Case& of, size_t scene, const Mode& mode, const Print& expected,
             Verdict& verdict) {
    Film film;
    const RenderStats stats = render(renderer, of, mode, film);
    const Fingerprint found = fingerprint(film);
    ++verdict.pictures;
    if (found.sha1 == expected.picture.sha1) return;
    verdict.differences.push_back(difference(picture_name(of, mode), scene, mode, found, expected.picture));
    verdict.differences.back().suspect = suspect(renderer, {of, mode, expected, found, stats});
}

}  // namespace

Verdict verify_device(const DeviceInfo& device, const std::vector<Case>& cases, const Record& record, const Say& say) {
    Verdict verdict{device, 0, {}, notes_about(device), "", 0};
    for (const Case& of : cases)
        for (const Mode& mode : modes(device))
            if (of.has(mode.accuracy)) expected_print(record, picture_name(of, mode));
    const double start = now();
    std::string picture = "opening it";
    try {
        Renderer renderer(device);
        for (size_t scene = 0; scene < cases.size(); ++scene)
            for (const Mode& mode : modes(device)) {
                if (!cases[scene].has(mode.accuracy)) continue;
                picture = picture_name(cases[scene], mode);
                say(device.number() + " " + picture);
                compare(renderer, cases[scene], scene, mode, expected_print(record, picture), verdict);
            }
    } catch (const Error& error) {
        verdict.error = picture + ": " + error.what();
    }
    verdict.seconds = now() - start;
    return verdict;
}

std::string Difference::place() const {
    if (pixel) return fmt::format("pixel ({}, {})", pixel->x, pixel->y);
    if (rows.empty() || columns.empty()) return "unknown pixel";  // all short hashes happen to be the same
    if (columns.size() == 1) return fmt::format("pixel ({}, {})", columns.front(), rows.front());
    return fmt::format("row {}, a column from {} to {}", rows.front(), columns.front(), columns.back());
}

}  // namespace gnomon::verify
