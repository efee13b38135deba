#include "ply.h"

#include "ply_source.h"
#include "ply_vertex.h"
#include "table_rows.h"

namespace gnomon {

namespace {

/// Reads the elements, one after another, up to the file's end.
template <class Source>
class PlyReader {
  public:
    PlyReader(const PlyHeader& header, const std::string& path, const SphereDefaults& defaults, Source source)
        : header_(header), path_(path), defaults_(defaults), source_(source) {}

    SphereTable read() {
        SphereTable table;
        bool found = false;
        for (const PlyElement& element : header_.elements) {
            expect_room(element);
            if (element.name != "vertex") {
                skip(element);
            } else {
                table = read_vertices(element);
                found = true;
            }
        }
        if (!found) throw Error(Blame::input, "found no element \"vertex\"", path_);
        if (source_.rest().empty()) return table;
        throw Error(Blame::input, fmt::format("found {} bytes after the last element", source_.rest().size()), path_);
    }

  private:
    /// Before anything is allocated, or walked through, for a count that the file cannot hold.
    void expect_room(const PlyElement& element) const {
        const auto rest = static_cast<int64_t>(source_.rest().size());
        const int64_t least = element.least_size(header_.format);
        if (element.count <= rest / least) return;
        throw Error(
            Blame::input,
            fmt::format("found {} bytes, too few for {} of element {}", rest, element.count, quote(element.name)),
            path_, "was the file written to its end?");
    }

    SphereTable read_vertices(const PlyElement& vertex) {
        expect_few_spheres(vertex.count, path_);
        const PlyVertexPlan plan = plan_ply_vertex(vertex, path_);
        const double radius = plan.has_radius ? 1 : default_radius(defaults_, "the vertices have none", path_);
        const bool fits_float = plan.fits_float && static_cast<float>(radius) > 0;
        return fits_float ? read_rows<float>(vertex, plan, radius) : read_rows<double>(vertex, plan, radius);
    }

    /// The radius is that of vertices without one.
    template <class T>
    SphereTable read_rows(const PlyElement& vertex, const PlyVertexPlan& plan, double radius) {
        std::vector<T> values(static_cast<size_t>(vertex.count * plan.columns));
        for (int64_t i = 0; i < vertex.count; ++i) {
            T* row = values.data() + i * plan.columns;
            row[radius_column] = static_cast<T>(radius);
            read_row(vertex, plan, {path_, vertex.name, i}, row);
        }
        return table_of(std::move(values), plan.columns, default_albedo(defaults_));
    }

    template <class T>
    void read_row(const PlyElement& vertex, const PlyVertexPlan& plan, const PlyRecord& record, T* row) {
        constexpr T most_of_a_byte = 255;
        source_.begin(record);
        for (size_t i = 0; i < plan.column.size(); ++i) {
            const PlyProperty& property = vertex.properties[i];
            const int column = plan.column[i];
            if (column == plan.unused) {
                skip(property, record);
                continue;
            }
            const T value = source_.template number<T>(property, record);
            const bool is_byte = column >= albedo_column && property.type == PlyType::uint8;
            row[column] = is_byte ? value / most_of_a_byte : value;
        }
        source_.end(record);
    }

    void skip(const PlyElement& element) {
        for (int64_t i = 0; i < element.count; ++i) {
            const PlyRecord record{path_, element.name, i};
            source_.begin(record);
            for (const PlyProperty& property : element.properties) skip(property, record);
            source_.end(record);
        }
    }

    void skip(const PlyProperty& property, const PlyRecord& record) {
        if (!property.length_type) return source_.skip(property, 1, record);
        const int64_t length = source_.length(property, record);
        if (length < 0) record.refuse(fmt::format("found a list of {} items", length));
        source_.skip(property, length, record);
    }

    const PlyHeader& header_;
    const std::string& path_;
    const SphereDefaults& defaults_;
    Source source_;
};

}  // namespace

SphereTable read_ply(const SharedFile& file, const SphereDefaults& defaults) {
    const PlyHeader header = read_ply_header(file->bytes(), file->path());
    const std::string_view data = file->bytes().substr(header.data_start);
    const auto read = [&](auto source) { return PlyReader(header, file->path(), defaults, source).read(); };
    if (header.format == PlyFormat::ascii) return read(PlyText(data));
    const bool is_little = header.format == PlyFormat::binary_little_endian;
    return read(PlyBytes(data, is_little ? ByteOrder::little : ByteOrder::big));
}

}  // namespace gnomon
