// EXR files to films, through OpenImageIO 2.4 or 2.5.
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>

#include "channels.h"
#include "error.h"
#include "oiio.h"

namespace gnomon {

namespace {

using OIIO::ImageSpec;
using OIIO::TypeDesc;

/// OpenImageIO's reader of EXR, whatever the file's name. Every step throws when it fails.
class Input {
  public:
    explicit Input(const std::string& path) : path_(path), reader_(OIIO::ImageInput::create("openexr")) {
        std::error_code ignored;  // what cannot be looked at does not exist for us
        if (!std::filesystem::exists(path, ignored)) refuse("there is no such file");
        if (!std::filesystem::is_regular_file(path, ignored)) refuse("this is not a file");
        if (!reader_) refuse("OpenImageIO cannot read EXR", OIIO::geterror());
        if (!reader_->open(path, spec_)) refuse("cannot read this as an EXR", reader_->geterror());
        if (reader_->seek_subimage(1, 0)) refuse("the file has several parts", "write one part with all channels");
        reader_->geterror();  // that there is no second part is no failure
        if (!reader_->seek_subimage(0, 0)) refuse("cannot read the picture", reader_->geterror());
        if (spec_.deep) refuse("the file has deep pixels", "flatten it first");
    }

    const ImageSpec& spec() const { return spec_; }

    /// Rows `from` to `to`, counted from the first, all channels of a pixel side by side, each in its own type.
    void read_rows(int from, int to, unsigned char* pixels) {
        const int top = spec_.y + from, bottom = spec_.y + to;
        const bool done =
            spec_.tile_width > 0
                ? reader_->read_tiles(0, 0, spec_.x, spec_.x + spec_.width, top, bottom, 0, 1, 0, spec_.nchannels,
                                      TypeDesc::UNKNOWN, pixels)
                : reader_->read_scanlines(0, 0, top, bottom, 0, 0, spec_.nchannels, TypeDesc::UNKNOWN, pixels);
        const std::string message = reader_->geterror();
        if (!done || !message.empty()) refuse("cannot read the picture", message);
    }

    [[noreturn]] void refuse(const std::string& what, const std::string& hint = "") const {
        throw Error(Blame::input, what, path_, hint);
    }

  private:
    std::string path_;
    std::unique_ptr<OIIO::ImageInput> reader_;
    ImageSpec spec_;
};

/// Where a channel of the file goes.
struct Target {
    TypeDesc file_type, type;
    size_t offset;  ///< in a pixel of the file, bytes
    char* values;   ///< of the film's plane, four bytes each
};
constexpr size_t value_size = 4;

/// Bytes of a pixel before channel `index`, or of the whole pixel.
size_t bytes_before(const ImageSpec& spec, int index) {
    size_t bytes = 0;
    for (int c = 0; c < index; ++c) bytes += spec.channelformat(c).size();
    return bytes;
}

/// A plane for the channel, if the file has it.
template <class Value>
void add_target(const Input& in, const char* name, TypeDesc type, Film& film, Plane<Value>& plane,
                std::vector<Target>& targets) {
    const int index = in.spec().channelindex(name);
    if (index < 0) return;
    const TypeDesc file_type = in.spec().channelformat(index);
    if (file_type != type && !(type == TypeDesc::FLOAT && file_type == TypeDesc::HALF))
        in.refuse(
            std::string("channel ") + name + " has type " + file_type.c_str(),
            type == TypeDesc::FLOAT ? "write it as float or half" : "write it as uint: floats hold no ids above 2^24");
    plane = Plane<Value>(film.pixels());
    targets.push_back({file_type, type, bytes_before(in.spec(), index), reinterpret_cast<char*>(plane.data())});
}

std::vector<Target> make_targets(const Input& in, Film& film) {
    std::vector<Target> targets;
    for (size_t c = 0; c < float_channels.size(); ++c)
        add_target(in, float_channels[c].name, TypeDesc::FLOAT, film, plane_of(film, c), targets);
    add_target(in, id_channel, TypeDesc::UINT32, film, film.id, targets);
    return targets;
}

std::vector<std::string> other_channels(const ImageSpec& spec) {
    const auto in_films = [](const std::string& name) {
        return name == id_channel || std::any_of(float_channels.begin(), float_channels.end(),
                                                 [&](const FloatChannel& channel) { return name == channel.name; });
    };
    std::vector<std::string> others;
    std::remove_copy_if(spec.channelnames.begin(), spec.channelnames.end(), std::back_inserter(others), in_films);
    return others;
}

/// Rows at a time: a few MiB, and whole rows of tiles or of EXR's compressed blocks, of which none has more than 256.
int rows_at_once(const ImageSpec& spec, size_t row_size) {
    constexpr size_t chunk_size = size_t{8} << 20;
    const size_t block = spec.tile_width > 0 ? static_cast<size_t>(spec.tile_height) : 256;
    const size_t rows = std::max<size_t>(1, chunk_size / row_size / block) * block;
    return static_cast<int>(std::min(rows, static_cast<size_t>(spec.height)));
}

void read_planes(Input& in, const std::vector<Target>& targets) {
    const ImageSpec& spec = in.spec();
    const size_t pixel_size = bytes_before(spec, spec.nchannels), width = static_cast<size_t>(spec.width);
    const int chunk = rows_at_once(spec, width * pixel_size);
    std::vector<unsigned char> pixels(static_cast<size_t>(chunk) * width * pixel_size);
    for (int from = 0; from < spec.height; from += chunk) {
        const int to = std::min(from + chunk, spec.height);
        in.read_rows(from, to, pixels.data());
        const size_t first = width * static_cast<size_t>(from);
        for (const Target& target : targets)  // of the same type on both sides this copies bits
            OIIO::convert_image(1, spec.width, to - from, 1, pixels.data() + target.offset, target.file_type,
                                static_cast<OIIO::stride_t>(pixel_size), OIIO::AutoStride, OIIO::AutoStride,
                                target.values + first * value_size, target.type, value_size, OIIO::AutoStride,
                                OIIO::AutoStride);
    }
}

}  // namespace

PictureFile read_exr_through_oiio(const std::string& path) {
    Input in(path);
    const ImageSpec& spec = in.spec();
    PictureFile picture;
    picture.left = spec.x;
    picture.top = spec.y;
    picture.film.width = spec.width;
    picture.film.height = spec.height;
    picture.others = other_channels(spec);
    const std::vector<Target> targets = make_targets(in, picture.film);
    if (!targets.empty()) read_planes(in, targets);
    return picture;
}

}  // namespace gnomon
