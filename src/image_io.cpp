#include "image_io.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "error.h"
#include "image_formats.h"
#include "image_read.h"
#include "png_write.h"
#include "temporary_file.h"

namespace gnomon {

namespace {

namespace fs = std::filesystem;

std::string extension_of(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

void write_file(const Film& film, const std::string& path, const Display& display, const Metadata& metadata,
                TemporaryFile& file) {
    if (extension_of(path) == ".png")
        write_png(film, path, display, metadata, file);
    else
        image_formats().write(film, path, display, metadata, file);
}

/// A picture as small as all formats take (JPEG 2000 wants more than 32 pixels a side).
Film trial_film(const Outputs& outputs) {
    Film film(64, 64, outputs);
    for (auto& plane : film.radiance) std::fill(plane.begin(), plane.end(), 0.0f);
    for (auto& plane : film.normal) std::fill(plane.begin(), plane.end(), 0.0f);
    std::fill(film.distance.begin(), film.distance.end(), 0.0f);
    std::fill(film.id.begin(), film.id.end(), 0);
    return film;
}

void check_place(const std::string& path) {
    check_folder(path);
    if (fs::path(path).extension().string().size() < 2)
        throw Error(Blame::input, "the name has no extension to tell the format", path, common_formats);
}

}  // namespace

bool is_exr(const std::string& path) { return extension_of(path) == ".exr"; }

Outputs outputs_for(const std::string& path, const Display& display) {
    if (is_exr(path)) return {true, true, true, true};
    return {display.view == View::radiance, display.view == View::distance, display.view == View::normal,
            display.view == View::id};
}

void check_writable(const std::string& path, const Display& display) {
    if (display.bits != 8 && display.bits != 16)
        throw Error(Blame::input, std::to_string(display.bits) + " bits a channel", path, "choose 8 or 16");
    check_place(path);
    try {  // What a format, a folder and a file system take, a trial tells best.
        TemporaryFile file(path);
        write_file(trial_film(outputs_for(path, display)), path, display, {}, file);
    } catch (const Error& error) {
        throw Error(Blame::input, error.what());
    }
}

void write_image(const Film& film, const std::string& path, const Display& display, const Metadata& metadata) {
    TemporaryFile file(path);
    write_file(film, path, display, metadata, file);
    file.move_to_target();
}

PictureFile read_exr(const std::string& path) { return image_formats().read_exr(path); }

}  // namespace gnomon
