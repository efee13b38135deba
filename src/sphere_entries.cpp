#include "sphere_entries.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "error.h"
#include "sphere_io.h"
#include "table_rows.h"

namespace gnomon {

namespace {

constexpr const char* too_bright = ", above 1: this sphere reflects more light than arrives";

bool is_bright(Rgb albedo) { return albedo.r > 1 || albedo.g > 1 || albedo.b > 1; }

/// The first few of the warnings, and how many there would be.
class FewWarnings {
  public:
    explicit FewWarnings(std::vector<std::string>& warnings) : warnings_(warnings) {}

    size_t room() const { return most_ - std::min<size_t>(most_, static_cast<size_t>(count_)); }
    void add(const std::string& warning) {
        if (room() > 0) warnings_.push_back(warning);
        ++count_;
    }
    void add_unseen(int64_t count) { count_ += count; }
    void finish(const std::string& where) {
        const auto unseen = count_ - static_cast<int64_t>(most_);
        if (unseen > 0) warnings_.push_back(where + ": and " + std::to_string(unseen) + " more");
    }

  private:
    static constexpr size_t most_ = 4;  // a generated scene may have thousands
    std::vector<std::string>& warnings_;
    int64_t count_ = 0;
};

/// Puts entry after entry into a scene, so that ids count on: spheres go to its list until the first file, and then to
/// a table of their own between the files.
class EntryReader {
  public:
    EntryReader(const std::string& folder, LoadedScene& loaded)
        : folder_(folder), scene_(loaded.scene), warnings_(loaded.warnings) {}

    void read(const JsonReader& entry) {
        if (entry.has("file"))
            read_file(entry);
        else
            read_sphere(entry);
    }

    void finish(const JsonReader& spheres) {
        end_table();
        expect_few_spheres(sphere_count(scene_), spheres.where());
        warnings_.finish(spheres.where());
    }

  private:
    void read_sphere(const JsonReader& entry) {
        entry.expect_object("a sphere", {"center", "radius", "albedo"});
        const Sphere sphere{entry["center"].vec3(), entry["radius"].positive(), entry["albedo"].rgb()};
        warn_of(sphere.albedo, entry);
        const auto& [center, radius, albedo] = sphere;
        if (scene_.tables.empty())
            scene_.spheres.push_back(sphere);
        else
            rows_.insert(rows_.end(), {center.x, center.y, center.z, radius, albedo.r, albedo.g, albedo.b});
    }

    void read_file(const JsonReader& entry) {
        entry.expect_object("a file of spheres", {"file"}, {"radius", "albedo"});
        SphereDefaults defaults;
        if (entry.has("radius")) defaults.radius = entry["radius"].positive();
        if (entry.has("albedo")) defaults.albedo = entry["albedo"].rgb();
        const std::string path = (std::filesystem::path(folder_) / file_name(entry["file"])).string();
        end_table();
        scene_.tables.push_back(load_spheres(opened(path), defaults));
        warn_of(scene_.tables.back(), path, entry);
    }

    /// A file that is named many times is mapped once: a process may have no more than some 65 000 mappings.
    SharedFile opened(const std::string& path) {
        std::weak_ptr<const MappedFile>& known = files_[path];
        SharedFile file = known.lock();
        if (!file) known = file = open_spheres(path);
        return file;
    }

    /// Names without characters that would end the path too early, or that a terminal would obey in a message.
    static std::string file_name(const JsonReader& file) {
        const std::string name = file.text();
        const auto is_control = [](unsigned char c) { return c < ' ' || c == '\x7F'; };
        if (name.empty() || std::any_of(name.begin(), name.end(), is_control)) file.refuse("the name of a file");
        return name;
    }

    /// The spheres since the last file become a table.
    void end_table() {
        if (!rows_.empty()) scene_.tables.push_back(table_of(std::exchange(rows_, {}), columns_with_albedo, {}));
    }

    void warn_of(Rgb albedo, const JsonReader& entry) {
        if (!is_bright(albedo)) return;
        const JsonReader reader = entry["albedo"];
        warnings_.add(reader.where() + ": found " + reader.found() + too_bright);
    }

    void warn_of(const SphereTable& table, const std::string& path, const JsonReader& entry) {
        if (table.columns == columns_without_albedo && table.count > 0 && entry.has("albedo"))
            return warn_of(table.albedo, entry);
        const BrightRows bright = bright_rows(table, warnings_.room());
        for (const int64_t row : bright.first) {
            const Rgb albedo = table[row].albedo;
            warnings_.add(row_location(path, row) + ": found albedo " + shown(albedo) + too_bright);
        }
        warnings_.add_unseen(bright.count - static_cast<int64_t>(bright.first.size()));
    }

    static std::string shown(Rgb albedo) { return nlohmann::json{albedo.r, albedo.g, albedo.b}.dump(); }

    const std::string& folder_;
    Scene& scene_;
    FewWarnings warnings_;
    std::vector<double> rows_;
    std::map<std::string, std::weak_ptr<const MappedFile>> files_;  ///< those that tables keep, by path
};

}  // namespace

void read_spheres(const JsonReader& spheres, const std::string& folder, LoadedScene& loaded) {
    EntryReader reader(folder, loaded);
    if (spheres.is_object()) {
        reader.read(spheres);
    } else {
        const size_t size = spheres.array_size();
        loaded.scene.spheres.reserve(size);
        for (size_t i = 0; i < size; ++i) reader.read(spheres[i]);
    }
    reader.finish(spheres);
}

}  // namespace gnomon
