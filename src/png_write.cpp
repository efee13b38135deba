#include "png_write.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <new>
#include <vector>

#include "display.h"
#include "error.h"

namespace gnomon {

namespace {

/// Of zlib, 1 to 9, on the difference of each pixel and its left neighbour: a 1024x768 picture of shaded spheres is 48
/// kB in 11 ms, sRGB included; with libpng's choice of filter row by row 48 kB in 21 ms, without a filter 81 kB.
constexpr int compression = 3;

/// libpng leaves a call that fails by longjmp, which passes over destructors: what runs in `attempt` must own nothing.
class Writer {
  public:
    Writer(const std::string& path, std::FILE* stream)
        : path_(path),
          png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, this, fail, [](png_structp, png_const_charp) {})),
          info_(png_ ? png_create_info_struct(png_) : nullptr) {
        if (!info_) png_destroy_write_struct(&png_, nullptr);
        if (!png_) throw std::bad_alloc();
        attempt([=] { png_init_io(png_, stream); });
    }
    ~Writer() { png_destroy_write_struct(&png_, &info_); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    void write_header(int width, int height, int bits, const Metadata& metadata) {
        std::vector<png_text> texts;
        for (const auto& [name, value] : metadata) texts.push_back(text(name, value));
        const auto set = [&, count = static_cast<int>(texts.size())] {
            png_set_IHDR(png_, info_, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits,
                         PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
            png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
            png_set_text(png_, info_, texts.data(), count);
            png_set_compression_level(png_, compression);
            png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
            png_write_info(png_, info_);
            if (bits == 16) png_set_swap(png_);  // PNG's numbers begin with the high byte
        };
        attempt(set);
    }
    void write_row(const void* row) {
        attempt([=] { png_write_row(png_, static_cast<png_const_bytep>(row)); });
    }
    void finish() {
        attempt([=] { png_write_end(png_, nullptr); });
    }

  private:
    static void fail(png_structp png, png_const_charp message) {
        static_cast<Writer*>(png_get_error_ptr(png))->message_ = message;
        png_longjmp(png, 1);
    }

    template <class Work>
    void attempt(const Work& work) {
        if (setjmp(png_jmpbuf(png_)) != 0) throw Error(Blame::run, "cannot write the image", path_, message_);
        work();
    }

    /// tEXt is Latin-1; what may be UTF-8 goes into iTXt (PNG specification, 11.3.4).
    static png_text text(const std::string& name, const std::string& value) {
        png_text entry{};
        const bool ascii = std::all_of(value.begin(), value.end(), [](char c) { return (c & 0x80) == 0; });
        entry.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        entry.key = const_cast<char*>(name.c_str());  // libpng copies them
        entry.text = const_cast<char*>(value.c_str());
        return entry;
    }

    std::string path_, message_;
    png_structp png_;
    png_infop info_;
};

template <class Code>
void write_rows(const Film& film, const Display& display, Writer& out) {
    const DisplayImage image(film, display);
    std::vector<Code> row(static_cast<size_t>(film.width) * 3);
    for (int y = 0; y < film.height; ++y) {
        image.row(y, row.data());
        out.write_row(row.data());
    }
}

}  // namespace

void write_png(const Film& film, const std::string& path, const Display& display, const Metadata& metadata,
               TemporaryFile& file) {
    Writer out(path, file.stream());
    out.write_header(film.width, film.height, display.bits, metadata);
    display.bits == 8 ? write_rows<uint8_t>(film, display, out) : write_rows<uint16_t>(film, display, out);
    out.finish();
    file.close();
}

}  // namespace gnomon
