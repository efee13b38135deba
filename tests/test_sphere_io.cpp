// Good files of spheres, of each kind.
#include "sphere_io.h"

#include "catch.h"
#include "scenes.h"
#include "sphere_files.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// The table has these values, and no others.
void check_rows(const SphereTable& table, const std::vector<std::vector<double>>& expected) {
    REQUIRE(table.count == static_cast<int64_t>(expected.size()));
    for (size_t i = 0; i < expected.size(); ++i) CHECK(values_of(table[static_cast<int64_t>(i)]) == expected[i]);
}

void check_grains(const SphereTable& table, const std::vector<float>& rows, int columns) {
    REQUIRE(table.columns == columns);
    std::vector<std::vector<double>> expected;
    for (auto row = rows.begin(); row != rows.end(); row += columns) {
        expected.emplace_back(row, row + columns);
        if (columns == 4) expected.back().insert(expected.back().end(), {0.5, 0.25, 0.125});
    }
    check_rows(table, expected);
}

bool is_float(const SphereTable& table) { return std::holds_alternative<const float*>(table.rows); }

const void* first_row(const SphereTable& table) {
    return std::visit([](const auto* rows) -> const void* { return rows; }, table.rows);
}

const SphereDefaults green_of_radius_2{2.0, Rgb{0.25, 0.5, 0.125}};

}  // namespace

TEST_CASE("the same spheres come out of every format", "[sphere_io]") {
    const TempFolder folder;
    const size_t count = 3000;  // some blocks, and a part of one
    const int columns = GENERATE(4, 7);
    const std::vector<float> rows = grains(count, columns);
    const std::vector<double> doubles(rows.begin(), rows.end());
    const SphereDefaults defaults{7.0, Rgb{0.5, 0.25, 0.125}};  // what the file has goes before
    const auto check = [&](const std::string& name, const std::string& bytes, bool as_float) {
        INFO(name << ", " << columns << " columns");
        const SphereTable table = load_spheres(folder.write(name, bytes), defaults);
        CHECK(is_float(table) == as_float);
        check_grains(table, rows, columns);
    };
    const auto width = static_cast<size_t>(columns);
    check("f4.npy", npy(npy_dict("<f4", count, width), bytes_of(rows)), true);
    check("f8.npy", npy(npy_dict("<f8", count, width), bytes_of(doubles)), false);
    check("big_f4.npy", npy(npy_dict(">f4", count, width), bytes_of(rows, true)), true);
    check("big_f8.npy", npy(npy_dict(">f8", count, width), bytes_of(doubles, true)), false);
    const auto ply = [&](const std::string& format, const std::string& type) {
        return ply_header(format, type, count, columns);
    };
    check("text.ply", ply("ascii", "float") + lines_of(rows, columns), true);
    check("text_double.ply", ply("ascii", "float64") + lines_of(rows, columns), false);
    check("little.ply", ply("binary_little_endian", "float32") + bytes_of(rows), true);
    check("big.PLY", ply("binary_big_endian", "float") + bytes_of(rows, true), true);
    check("big_double.ply", ply("binary_big_endian", "double") + bytes_of(doubles, true), false);
    const std::string head = std::to_string(count) + "\nProperties=species:S:1:pos:R:3:radius:R:1";
    check("atoms.xyz", head + (columns == 7 ? ":color:R:3\n" : "\n") + lines_of(rows, columns, "Xx "), false);
}

TEST_CASE("rows of an array stay in the file where they can", "[sphere_io]") {
    const TempFolder folder;
    const std::vector<float> rows = grains(5, 4);
    const std::vector<double> doubles(rows.begin(), rows.end());
    const SphereDefaults defaults{{}, Rgb{0.5, 0.25, 0.125}};
    const auto load = [&](const std::string& name, const std::string& bytes) {
        return load_spheres(folder.write(name, bytes), defaults);
    };
    const auto in_page = [](const SphereTable& table) {
        return reinterpret_cast<std::uintptr_t>(first_row(table)) % 4096;
    };
    const SphereTable mapped = load("mapped.npy", npy(npy_dict("<f4", 5, 4), bytes_of(rows)));
    CHECK(in_page(mapped) == 128);  // where the header ends
    const SphereTable shifted = load("shifted.npy", npy(npy_dict("<f8", 5, 4), bytes_of(doubles), 1, 3));
    CHECK(in_page(shifted) % alignof(double) == 0);
    check_grains(shifted, rows, 4);
    check_grains(load("by_4.npy", npy(npy_dict("<f4", 5, 4), bytes_of(rows), 1, 4)), rows, 4);
    std::filesystem::remove(folder / "mapped.npy");
    check_grains(mapped, rows, 4);  // the mapping outlives the file's name
}

TEST_CASE("arrays of every version and order are read", "[sphere_io]") {
    const TempFolder folder;
    const std::vector<float> rows{1, 2, 3, 4, 5, 6, 7, 8};
    const auto check = [&](const std::string& bytes) {
        check_rows(load_spheres(folder.write("a.npy", bytes)), {{1, 2, 3, 4, 1, 1, 1}, {5, 6, 7, 8, 1, 1, 1}});
    };
    for (const char version : {'\1', '\2', '\3'}) check(npy(npy_dict("<f4", 2, 4), bytes_of(rows), version));
    for (const std::string dict : {"{'shape':(2,4),'fortran_order':False,'descr':'<f4'}",
                                   "{ 'shape' : ( 2 , 4 , ) ,\n\"descr\" : \"<f4\" , "
                                   "'fortran_order' : False , } ",
                                   "{'descr': '<f4', 'fortran_order': False, 'shape': (2L, 4L), }"}) {
        INFO(dict);
        check(npy(dict, bytes_of(rows)));
    }
    const std::vector<float> transposed{1, 5, 2, 6, 3, 7, 4, 8};
    check(npy(npy_dict("<f4", 2, 4, true), bytes_of(transposed)));
    check(npy(npy_dict(">f4", 2, 4, true), bytes_of(transposed, true)));
}

TEST_CASE("a file of no spheres is one", "[sphere_io]") {
    const TempFolder folder;
    CHECK(load_spheres(folder.write("a.npy", npy(npy_dict("<f4", 0, 7), ""))).count == 0);
    CHECK(load_spheres(folder.write("a.ply", ply_header("ascii", "float", 0, 4))).count == 0);
    CHECK(load_spheres(folder.write("b.ply", ply_header("binary_little_endian", "float", 0, 4))).count == 0);
    CHECK(load_spheres(folder.write("a.xyz", "0\n\n")).count == 0);
}

TEST_CASE("a PLY file is read around what are no spheres", "[sphere_io]") {
    const TempFolder folder;
    const std::string elements =
        "obj_info from a scanner\nelement camera 2\nproperty list uchar int views\nproperty double tilt\n"
        "element vertex 2\nproperty uchar blue\nproperty short z\nproperty list int8 uint16 rings\nproperty uint8 red\n"
        "property float32 x\nproperty int confidence\nproperty uchar green\nproperty char y\n"
        "element face 1\nproperty list uint32 int32 vertex_indices\nend_header\n";
    const std::vector<std::vector<double>> expected{{1.5, -3, -700, 2, 1, 0.2f, 0}, {2.5, 4, 9, 2, 0, 0, 1}};
    const std::string text =
        "3 7 8 9 0.5\n0 -1e300\n0 -700 0 255 1.5 12345678 51 -3\n255 9 2 4 5 0 2.5 -7 0 4\n3 0 1 2\n";
    const SphereTable table =
        load_spheres(folder.write("a.ply", "ply\nformat ascii 1.0\n" + elements + text), {2.0, {}});
    CHECK(is_float(table));
    check_rows(table, expected);

    const bool big = GENERATE(false, true);
    const auto number = [&](auto value) { return bytes_of(value, big); };
    const auto byte = [](int value) { return std::string(1, static_cast<char>(value)); };
    const std::string cameras = byte(2) + number(int32_t{7}) + number(int32_t{8}) + number(0.5) + byte(0) + number(1.0);
    const std::string first = byte(0) + number(int16_t{-700}) + byte(0) + byte(255) + number(1.5f) +
                              number(int32_t{12345678}) + byte(51) + byte(-3);
    const std::string second = byte(255) + number(int16_t{9}) + byte(2) + number(uint16_t{4}) + number(uint16_t{5}) +
                               byte(0) + number(2.5f) + number(int32_t{-7}) + byte(0) + byte(4);
    const std::string faces = number(uint32_t{1}) + number(int32_t{0});
    const std::string format = big ? "binary_big_endian" : "binary_little_endian";
    const std::string bytes = "ply\r\nformat " + format + " 1.0\r\n" + elements + cameras + first + second + faces;
    check_rows(load_spheres(folder.write("b.ply", bytes), {2.0, {}}), expected);
}

TEST_CASE("PLY headers may have remarks before the format, and blanks between words and after them", "[sphere_io]") {
    const TempFolder folder;
    const std::string header =
        "ply \r\ncomment first\nobj_info second\nformat  binary_little_endian\t1.0 \nelement   vertex 1 \n"
        "property float  x\nproperty float y\t\nproperty float z\nproperty float radius\nend_header \t\r\n";
    check_rows(load_spheres(folder.write("a.ply", header + bytes_of(std::vector<float>{1, 2, 3, 4}))),
               {{1, 2, 3, 4, 1, 1, 1}});
}

TEST_CASE("integers that float cannot hold make a table of doubles", "[sphere_io]") {
    const TempFolder folder;
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty uint x\nproperty int y\nproperty int16 z\n";
    const SphereTable table =
        load_spheres(folder.write("a.ply", head + "end_header\n4294967295 -16777217 5\n"), green_of_radius_2);
    CHECK_FALSE(is_float(table));
    check_rows(table, {{4294967295.0, -16777217, 5, 2, 0.25, 0.5, 0.125}});
}

TEST_CASE("a radius for all that float cannot hold makes a table of doubles", "[sphere_io]") {
    const TempFolder folder;
    const std::string path = folder.write("a.ply", ply_header("ascii", "float", 1, 3) + "1 2 3\n");
    CHECK(is_float(load_spheres(path, {1e-40, {}})));
    const SphereTable table = load_spheres(path, {1e-60, {}});
    CHECK_FALSE(is_float(table));
    check_rows(table, {{1, 2, 3, 1e-60, 1, 1, 1}});
}

TEST_CASE("numbers too small for their type are 0", "[sphere_io]") {
    const TempFolder folder;
    const std::string tiny = "1e-50 -1e-400 1e-40 2\n";
    const auto load = [&](const char* type) {
        return load_spheres(folder.write("a.ply", ply_header("ascii", type, 1, 4) + tiny));
    };
    check_rows(load("float"), {{0, 0, double{1e-40f}, 2, 1, 1, 1}});
    check_rows(load("double"), {{1e-50, 0, 1e-40, 2, 1, 1, 1}});
}

TEST_CASE("atoms take radius and colour from their element", "[sphere_io]") {
    const TempFolder folder;
    const std::string water =
        "3\nwater, in angstrom\nO 0 0 0.1173\r\nH 0 .7572 -0.4692\n\tH  +0   -7.572E-1 -0.4692 \n\n";
    const SphereTable table = load_spheres(folder.write("water.xyz", water));
    REQUIRE(table.count == 3);
    REQUIRE(table.columns == 7);
    CHECK(table[0].center.z == 0.1173);
    CHECK(table[0].radius == 1.52);  // Bondi's
    CHECK(table[0].albedo.r == 1);
    CHECK(table[0].albedo.g == Approx(0.0040).margin(0.00005));  // 13 of 255, on the sRGB curve's straight part
    CHECK(table[1].radius == 1.10);
    CHECK(values_of(table[2]) == std::vector<double>{0, -0.7572, -0.4692, 1.10, 1, 1, 1});
    const SphereTable carbon = load_spheres(folder.write("c.EXTXYZ", "1\n\nC 0 0 0"));
    CHECK(carbon[0].radius == 1.70);
    CHECK(carbon[0].albedo.b == Approx(0.2789).margin(0.00005));  // 144 of 255 is 0.5647
    const SphereTable iron = load_spheres(folder.write("fe.xyz", "1\n\nFe 0 0 0"));
    CHECK(iron[0].radius == 2.44);  // Alvarez's
}

TEST_CASE("atoms are written in several ways", "[sphere_io]") {
    const TempFolder folder;
    const auto load = [&](const std::string& text) { return load_spheres(folder.write("a.xyz", text)); };
    for (const std::string chlorine : {"Cl", "CL", "cl", "17"}) {
        INFO(chlorine);
        CHECK(load("1\n\n" + chlorine + " 0 0 0\n")[0].radius == 1.75);
    }
    CHECK(load("1\n\n82 0 0 0\n")[0].radius == 2.02);  // lead
    check_rows(load("1\n\nH 1 2 3 0.5 forces -1\n"), {{1, 2, 3, 1.10, 1, 1, 1}});
    check_rows(load("1\nProperties=pos:I:3:color:I:3:radius:I:1\n-1 2 3 255 51 0 4\n"), {{-1, 2, 3, 4, 1, 0.2, 0}});
}

TEST_CASE("defaults go before an element, and a column before defaults", "[sphere_io]") {
    const TempFolder folder;
    const auto load = [&](const std::string& text, const SphereDefaults& defaults) {
        return load_spheres(folder.write("a.xyz", text), defaults);
    };
    const std::string one = "1\n\nO 1 2 3\n";
    check_rows(load(one, green_of_radius_2), {{1, 2, 3, 2, 0.25, 0.5, 0.125}});
    CHECK(load(one, {2.0, {}})[0].radius == 2);
    CHECK(load(one, {2.0, {}})[0].albedo.r == 1);
    CHECK(load(one, {{}, Rgb{0, 0, 0}})[0].radius == 1.52);
    CHECK(load(one, {{}, Rgb{0, 0, 0}})[0].albedo.r == 0);
    check_rows(load("1\n\nA7 1 2 3\n", green_of_radius_2), {{1, 2, 3, 2, 0.25, 0.5, 0.125}});
    const std::string colored =
        "1\nLattice=\"Properties=no:R:1 a\" x Properties=\"id:I:1:pos:R:3:color:R:3:fixed:L:2\" t=1\n";
    check_rows(load(colored + "9 1 2 3 .5 .5 .75 T F", green_of_radius_2), {{1, 2, 3, 2, 0.5, 0.5, 0.75}});
    const std::string sized = "1\nProperties=radius:R:1:species:S:1:pos:R:3\n";
    check_rows(load(sized + "9 A7 1 2 3", green_of_radius_2), {{1, 2, 3, 9, 0.25, 0.5, 0.125}});
    CHECK(load(sized + "9 H 1 2 3", {2.0, {}})[0].radius == 9);
    for (const std::string comment :
         {"properties=pos:R:3", "Properties = pos:R:3", "t =1 Properties\t= \"pos:R:3\" a= b",
          "a = b \"c\" energy= Properties= pos:R:3", "= == Properties=pos:R:3 pbc ="}) {
        INFO(comment);
        check_rows(load("1\n" + comment + "\n1 2 3", {2.0, {}}), {{1, 2, 3, 2, 1, 1, 1}});
    }
}

TEST_CASE("rows that reflect more than arrives are found", "[sphere_io]") {
    const TempFolder folder;
    std::vector<float> rows = grains(5000, 7);
    CHECK(bright_rows(load_spheres(folder.write("a.npy", npy(npy_dict("<f4", 5000, 7), bytes_of(rows)))), 2).count ==
          0);
    for (const size_t row : {7, 1023, 1024, 4999}) rows[row * 7 + 4 + row % 3] = 1.0000001f;
    const std::string path = folder.write("a.npy", npy(npy_dict("<f4", 5000, 7), bytes_of(rows)));
    const BrightRows bright = bright_rows(load_spheres(path), 2);
    CHECK(bright.count == 4);
    CHECK(bright.first == std::vector<int64_t>{7, 1023});
    CHECK(row_location("a.npy", 7) == "a.npy: row 7");
    CHECK(row_location("a.ply", 7) == "a.ply: vertex 7");
    CHECK(row_location("a.xyz", 7) == "a.xyz: line 10");
}
