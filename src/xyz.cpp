#include "xyz.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "elements.h"
#include "error.h"
#include "json_parse.h"
#include "table_rows.h"
#include "text_lines.h"
#include "xyz_header.h"

namespace gnomon {

namespace {

constexpr const char* give_columns = "the comment line names the columns: Properties=species:S:1:pos:R:3:radius:R:1";
constexpr const char* give_both = "give all the same ones: {\"file\": ..., \"radius\": ..., \"albedo\": ...}";

/// Reads the one frame line by line; every refusal names the line.
class XyzReader {
  public:
    XyzReader(const SharedFile& file, const SphereDefaults& defaults)
        : lines_(file->bytes()), path_(file->path()), defaults_(defaults) {}

    SphereTable read() {
        const int64_t count = read_count();
        next_header_line("the comment");
        columns_ = read_xyz_columns(line_, where());
        expect_room(count);
        plan();
        std::vector<double> values(static_cast<size_t>(count * row_size_));
        for (int64_t i = 0; i < count; ++i) {
            next_line("an atom");
            read_atom(values.data() + i * row_size_);
        }
        expect_end();
        return table_of(std::move(values), row_size_, default_albedo(defaults_));
    }

  private:
    void next_line(const char* expected) {
        if (!lines_.next(line_))
            throw Error(Blame::input, std::string("the file ends here, expected ") + expected,
                        path_ + ": line " + std::to_string(lines_.number() + 1));
    }

    void next_header_line(const char* expected) {
        if (!lines_.ends_within(longest_header_line))
            throw Error(Blame::input, "found no line end within 1 MiB",
                        path_ + ": line " + std::to_string(lines_.number() + 1));
        next_line(expected);
    }

    int64_t read_count() {
        next_header_line("the number of atoms");
        Words words(line_);
        const std::string_view word = words.next();
        int64_t count = 0;
        if (!parse(word, count) || count < 0 || !words.next().empty())
            refuse("found " + quote_start(line_) + ", expected the number of atoms");
        expect_few_spheres(count, where());
        return count;
    }

    /// Before anything is allocated for a count that the file cannot hold.
    void expect_room(int64_t count) const {
        const auto rest = static_cast<int64_t>(lines_.rest().size());
        if (count <= rest / least_bytes(words_of_line())) return;
        throw Error(Blame::input, fmt::format("found {} bytes, too few for {} atoms", rest, count), path_,
                    "was the file written to its end?");
    }

    /// Of no line are more words read than the file has bytes, so larger counts are all the same.
    int64_t words_of_line() const {
        const auto most = static_cast<int64_t>(lines_.rest().size()) + 1;
        const auto add = [&](int64_t sum, const XyzColumns& c) {
            return std::min(sum + std::min(c.words, most), most);
        };
        return std::accumulate(columns_.begin(), columns_.end(), int64_t{0}, add);
    }

    bool has(XyzUse use) const {
        return std::any_of(columns_.begin(), columns_.end(), [&](const XyzColumns& c) { return c.use == use; });
    }

    /// What neither a column nor a default gives is the element's, if the species are there to name it.
    void plan() {
        const bool has_species = has(XyzUse::species);
        needs_radius_ = !has(XyzUse::radius);
        if (needs_radius_ && !has_species) default_radius(defaults_, "the atoms have neither one nor species", path_);
        element_gives_radius_ = needs_radius_ && !defaults_.radius;
        element_gives_albedo_ = !has(XyzUse::color) && !defaults_.albedo && has_species;
        const bool has_albedo = has(XyzUse::color) || element_gives_albedo_;
        row_size_ = has_albedo ? columns_with_albedo : columns_without_albedo;
    }

    void read_atom(double* row) {
        Words words(line_);
        std::string_view species;
        if (needs_radius_) row[radius_column] = defaults_.radius.value_or(0);
        for (const XyzColumns& columns : columns_)
            if (columns.use == XyzUse::species)
                species = next_word(words);
            else
                read_columns(words, columns, row);
        if (const std::string_view more = words.next(); !more.empty())
            refuse("found " + quote_start(more) + " after the last column", give_columns);
        if (element_gives_radius_ || element_gives_albedo_) fill_from_element(species, row);
    }

    /// Columns of numbers, and those that are passed over.
    void read_columns(Words& words, const XyzColumns& columns, double* row) const {
        if (columns.use == XyzUse::position)
            read_numbers(words, columns, row);
        else if (columns.use == XyzUse::radius)
            read_numbers(words, columns, row + radius_column);
        else if (columns.use == XyzUse::color)
            read_color(words, columns, row + albedo_column);
        else if (columns.use == XyzUse::rest)
            words = Words("");
        else
            skip(words, columns.words);
    }

    void fill_from_element(std::string_view species, double* row) const {
        const Element* element = find_element(species);
        if (!element) refuse("found the unknown species " + quote_start(species) + ", expected an element", give_both);
        if (element_gives_radius_) {
            if (element->radius == 0)
                refuse("no van der Waals radius is published for " + quote_start(species), give_both);
            row[radius_column] = element->radius;
        }
        if (!element_gives_albedo_) return;
        row[albedo_column] = element->albedo.r;
        row[albedo_column + 1] = element->albedo.g;
        row[albedo_column + 2] = element->albedo.b;
    }

    std::string_view next_word(Words& words) const {
        const std::string_view word = words.next();
        if (word.empty()) refuse("the line ends before the last column", give_columns);
        return word;
    }
    void skip(Words& words, int64_t count) const {
        for (; count > 0; --count) next_word(words);
    }
    void read_numbers(Words& words, const XyzColumns& columns, double* numbers) const {
        for (int64_t i = 0; i < columns.words; ++i) {
            const std::string_view word = next_word(words);
            int64_t integer = 0;
            if (columns.integers && !parse(word, integer))
                refuse("found " + quote_start(word) + ", expected an integer");
            if (!parse(word, numbers[i])) refuse("found " + quote_start(word) + ", expected a number");
        }
    }
    /// Integers are 255ths, as bytes of other formats.
    void read_color(Words& words, const XyzColumns& columns, double* color) const {
        constexpr double most = 255;
        read_numbers(words, columns, color);
        if (!columns.integers) return;
        for (int64_t i = 0; i < columns.words; ++i) {
            if (color[i] < 0 || color[i] > most)
                refuse(fmt::format("found {} in a color of integers, expected 0 to 255", color[i]));
            color[i] /= most;
        }
    }

    void expect_end() {
        while (lines_.next(line_))
            if (!Words(line_).next().empty())
                refuse("found " + quote_start(line_) + " after the last atom", "only a file's one frame is read");
    }

    std::string where() const { return path_ + ": line " + std::to_string(lines_.number()); }
    [[noreturn]] void refuse(const std::string& what, const std::string& hint = "") const {
        throw Error(Blame::input, what, where(), hint);
    }

    TextLines lines_;
    const std::string& path_;
    const SphereDefaults& defaults_;
    std::string_view line_;
    std::vector<XyzColumns> columns_;
    int row_size_ = 0;
    bool needs_radius_ = false, element_gives_radius_ = false, element_gives_albedo_ = false;
};

}  // namespace

SphereTable read_xyz(const SharedFile& file, const SphereDefaults& defaults) {
    return XyzReader(file, defaults).read();
}

}  // namespace gnomon
