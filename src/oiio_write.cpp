// Films to image files, through OpenImageIO 2.4 or 2.5.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <memory>

#include "channels.h"
#include "display.h"
#include "error.h"
#include "oiio.h"

namespace gnomon {

namespace {

namespace fs = std::filesystem;
using OIIO::ImageSpec;
using OIIO::TypeDesc;
using OIIO::Filesystem::IOProxy;

constexpr const char* writing_failed = "cannot write the image";

/// Left alone, OpenImageIO puts the current time into the files whose format has a place for one, and the same picture
/// would never give the same bytes. https://reproducible-builds.org/specs/source-date-epoch/
std::string file_time() {
    const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
    const auto seconds = static_cast<std::time_t>(epoch ? std::strtoll(epoch, nullptr, 10) : 0);
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    char text[64];
    return std::string(text, std::strftime(text, sizeof text, "%Y:%m:%d %H:%M:%S", &utc));
}

/// One of OpenImageIO's writers, putting its bytes into a sink. Every step throws when it fails.
/// Only TIFF's goes by the file's name: it reads its file again to add Exif data (the colour space is among it), which
/// no sink lets it do, and the file would be broken; and it does notice when a write fails.
class Output {
  public:
    Output(const std::string& path, const TemporaryFile& file, IOProxy& sink)
        : path_(path),
          file_(file.path()),
          // Asked for by the extension alone: in a whole name OpenImageIO would read options after a '?'.
          writer_(OIIO::ImageOutput::create(fs::path(path).extension().string().substr(1))) {
        const std::string ignored = OIIO::geterror();  // what nobody fetches is printed when the program ends
        if (!writer_ || !(is("tiff") || writer_->set_ioproxy(&sink)))
            throw Error(Blame::run, "this image format cannot be written", path, common_formats);
    }

    void open(const ImageSpec& spec) { require(writer_->open(file_, spec)); }
    void write_rows(int from, int to, TypeDesc type, const void* values) {
        require(writer_->write_scanlines(from, to, 0, type, values));
    }
    void close() { require(writer_->close()); }

    bool is(const char* format) const { return std::strcmp(writer_->format_name(), format) == 0; }
    /// Of the values in the file; the format may not have the one asked for.
    TypeDesc type() const { return writer_->spec().format; }

  private:
    void require(bool done) {
        const std::string message = writer_->geterror();  // some writers say that all went well and leave a message
        if (!done || !message.empty()) throw Error(Blame::run, writing_failed, path_, message);
    }

    std::string path_, file_;
    std::unique_ptr<OIIO::ImageOutput> writer_;
};

ImageSpec make_spec(const Film& film, size_t channels, TypeDesc type, const Metadata& metadata) {
    ImageSpec spec(film.width, film.height, static_cast<int>(channels), type);
    for (const auto& [name, value] : metadata) spec.attribute(name, value);
    return spec;
}

/// A plane of the film as a channel of an EXR. All values have four bytes.
struct Channel {
    const char* name;
    TypeDesc type;
    const unsigned char* values;
};
constexpr size_t value_size = 4;

std::vector<Channel> channels_of(const Film& film) {
    std::vector<Channel> channels;
    const auto add = [&](const char* name, TypeDesc type, const auto& plane) {
        static_assert(sizeof plane[0] == value_size);
        if (!plane.empty()) channels.push_back({name, type, reinterpret_cast<const unsigned char*>(plane.data())});
    };
    for (size_t c = 0; c < float_channels.size(); ++c) add(float_channels[c].name, TypeDesc::FLOAT, plane_of(film, c));
    add(id_channel, TypeDesc::UINT32, film.id);  // -1 becomes 0xFFFFFFFF: EXR has no signed integers
    return channels;
}

ImageSpec exr_spec(const Film& film, const std::vector<Channel>& channels, const Metadata& metadata) {
    ImageSpec spec = make_spec(film, channels.size(), TypeDesc::FLOAT, metadata);
    spec.channelnames.clear();
    for (const Channel& channel : channels) {
        spec.channelnames.emplace_back(channel.name);
        spec.channelformats.push_back(channel.type);
    }
    spec.attribute("compression", "zip:1");  // zlib's fastest: 0.8 of the default level's time for 1.02 of its bytes
    spec.attribute("DateTime", file_time());
    return spec;
}

/// Copies `count` pixels from `first` on to `pixels`, a pixel's values side by side.
void interleave(const std::vector<Channel>& channels, size_t first, size_t count, unsigned char* pixels) {
    const size_t pixel_size = channels.size() * value_size;
    for (const Channel& channel : channels) {
        const unsigned char* from = channel.values + first * value_size;
        for (unsigned char* to = pixels; to < pixels + count * pixel_size; to += pixel_size, from += value_size)
            std::memcpy(to, from, value_size);
        pixels += value_size;
    }
}

/// A file whose ids went through floats would look right and be wrong above 2^24, so the header is read again.
void check_channels(const std::string& file, const std::vector<Channel>& channels, const std::string& path) {
    const auto reader = OIIO::ImageInput::create("openexr");
    ImageSpec spec;
    if (!reader || !reader->open(file, spec))
        throw Error(Blame::run, "cannot read the image just written", path, reader ? reader->geterror() : "");
    for (const Channel& channel : channels) {
        const int index = spec.channelindex(channel.name);
        if (index < 0 || spec.channelformat(index) != channel.type)
            throw Error(Blame::run, std::string("the file's channel ") + channel.name + " has the wrong type", path);
    }
}

void write_exr(const Film& film, const std::string& path, const Metadata& metadata, TemporaryFile& file) {
    const std::vector<Channel> channels = channels_of(film);
    const size_t width = static_cast<size_t>(film.width), row_size = width * channels.size() * value_size;
    // A few MiB at a time, whole 16-row blocks of EXR's zip, so that a huge film needs little memory besides itself.
    constexpr size_t chunk_size = size_t{8} << 20;
    const int chunk = static_cast<int>(std::max<size_t>(1, chunk_size / 16 / std::max<size_t>(1, row_size))) * 16;
    std::vector<unsigned char> pixels(row_size * static_cast<size_t>(std::min(chunk, film.height)));

    OIIO::Filesystem::IOFile sink(file.stream(), IOProxy::Write);
    Output out(path, file, sink);
    out.open(exr_spec(film, channels, metadata));
    for (int from = 0; from < film.height; from += chunk) {
        const int to = std::min(from + chunk, film.height);
        interleave(channels, width * static_cast<size_t>(from), width * static_cast<size_t>(to - from), pixels.data());
        out.write_rows(from, to, TypeDesc::UNKNOWN, pixels.data());  // unknown: each channel in its own type
    }
    out.close();
    file.close();
    check_channels(file.path(), channels, path);
}

template <class Code>
void write_rows(const DisplayImage& image, const ImageSpec& spec, Output& out) {
    std::vector<Code> row(static_cast<size_t>(spec.width) * 3);
    for (int y = 0; y < spec.height; ++y) {
        image.row(y, row.data());
        out.write_rows(y, y + 1, spec.format, row.data());
    }
}

/// By way of the memory: a display image is small beside its film, and a writer then cannot meet a full disk.
void write_display(const Film& film, const std::string& path, const Display& display, const Metadata& metadata,
                   TemporaryFile& file) {
    const DisplayImage image(film, display);
    const TypeDesc type = display.bits == 8 ? TypeDesc::UINT8 : TypeDesc::UINT16;
    OIIO::Filesystem::IOVecOutput memory;
    Output out(path, file, memory);
    ImageSpec spec = make_spec(film, 3, type, metadata);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("DateTime", file_time());
    out.open(spec);
    if (out.type() != type)
        throw Error(Blame::run, "this format has no " + std::to_string(display.bits) + " bits a channel", path,
                    display.bits == 16 ? "try .png or .tif, or 8 bits" : common_formats);
    display.bits == 8 ? write_rows<uint8_t>(image, spec, out) : write_rows<uint16_t>(image, spec, out);
    out.close();
    std::fwrite(memory.buffer().data(), 1, memory.buffer().size(), file.stream());
    file.close();
}

}  // namespace

void write_through_oiio(const Film& film, const std::string& path, const Display& display, const Metadata& metadata,
                        TemporaryFile& file) {
    if (is_exr(path))
        write_exr(film, path, metadata, file);
    else
        write_display(film, path, display, metadata, file);
}

}  // namespace gnomon
