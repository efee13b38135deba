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

std::vector<std::string> notes_about(const DeviceInfo& device, const std::vector<Case>& cases) {
    std::vector<std::string> notes;
    if (!device.fp64)
        notes.push_back(
            "double is not tried: the device lacks cl_khr_fp64; certified decides exactly what float "
            "leaves open");
    for (const Case& of : cases)
        if (!of.suits(device)) notes.push_back(of.name + " is not tried: see `gnomon devices`");
    return notes;
}

Difference difference(const std::string& picture, size_t scene, const Mode& mode, const Fingerprint& found,
                      const Fingerprint& expected) {
    Difference made{scene, mode, picture, {}, first_differing(found, expected), "", {}};
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
    Verdict verdict{device, 0, {}, notes_about(device, cases), "", 0};
    for (const Case& of : cases)
        for (const Mode& mode : modes(device))
            if (of.has(mode.accuracy)) expected_print(record, picture_name(of, mode));
    const double start = now();
    std::string picture = "opening it";
    try {
        Renderer renderer(device);
        for (size_t scene = 0; scene < cases.size(); ++scene)
            for (const Mode& mode : modes(device)) {
                if (!cases[scene].has(mode.accuracy) || !cases[scene].suits(device)) continue;
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
    if (places.empty()) return "unknown pixel";  // all short hashes happen to be the same
    const Place &first = places.front(), &last = places.back();
    if (places.size() == 1) return fmt::format("pixel ({}, {})", first.x, first.y);
    return fmt::format("pixel in row {}, one of {} from {} to {}", first.y, places.size(), first.x, last.x);
}

}  // namespace gnomon::verify
