// Files of spheres that are damaged, or lie: each is refused, and told why.
#include <sys/stat.h>

#include <chrono>
#include <cmath>

#include "damaged_spheres.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// A good array of two rows with one value changed.
std::string npy_with(size_t index, double value) {
    std::vector<double> rows{1, 2, 3, 4, 0.5, 0.5, 0.5, 5, 6, 7, 8, 0.5, 0.5, 0.5};
    rows[index] = value;
    return npy(npy_dict("<f8", 2, 7), bytes_of(rows));
}

std::string npy_of(const std::string& dict) { return npy(dict, std::string(32, '\0')); }

std::string npy_shape(const std::string& shape) {
    return npy_of("{'descr': '<f4', 'fortran_order': False, 'shape': " + shape + ", }");
}

}  // namespace

TEST_CASE("what are no files of spheres is refused", "[sphere_io]") {
    const TempFolder folder;
    const auto check = [&](const std::string& path, const std::string& expected) {
        const std::string message = refusal(wrong_input, [&] { load_spheres(path); });
        INFO(message);
        CHECK(contains(message, path + ": " + expected));
    };
    check(folder / "missing.npy", "cannot read the file: No such file or directory");
    check(folder.write("empty.ply", ""), "found an empty file");
    folder.write("folder.xyz/inside", "");
    check(folder / "folder.xyz", "found a folder, expected a file");
    REQUIRE(mkfifo((folder / "pipe.npy").c_str(), 0600) == 0);
    check(folder / "pipe.npy", "found a pipe or a device, expected a file");
    for (const std::string name : {"a.obj", "npy", "a.npy.gz", ""}) {
        check(folder.write("x" + name, "1"), "found no format for spheres, expected .npy, .ply, .xyz or .extxyz");
    }
}

TEST_CASE("a file that changes while its rows are used is refused", "[sphere_io]") {
    const TempFolder folder;
    std::vector<float> rows = grains(5000, 4);
    const auto bytes = [&] { return npy(npy_dict("<f4", 5000, 4), bytes_of(rows)); };
    const auto use = [&](const std::string& name, auto change) {
        const std::string path = folder.write(name, bytes());
        const SphereTable table = load_spheres(path);
        table.forget(0, 2000);  // all is well so far
        change(path);
        return refusal(wrong_input, [&] { table.forget(2000, 3000); });
    };
    const auto later = [](const std::string& path) {  // whatever the clock's step
        const auto time = std::filesystem::last_write_time(path);
        std::filesystem::last_write_time(path, time + std::chrono::milliseconds(1));
    };
    rows[3] = 99;
    CHECK(use("a.npy", later) == folder / "a.npy: changed while it was read");
    const auto append = [&](const std::string& path) { std::ofstream(path, std::ios::app) << 'x'; };
    CHECK(use("b.npy", append) == folder / "b.npy: changed while it was read");
    const std::string path = folder.write("c.npy", bytes());
    const SphereTable table = load_spheres(path);
    std::filesystem::remove(path);  // another file of that name leaves the first as it is
    folder.write("c.npy", "x");
    CHECK_NOTHROW(table.forget(0, 5000));
}

TEST_CASE("wrong values are refused by row", "[sphere_io]") {
    const double inf = INFINITY;
    check_refused("a.npy", {
                               {npy_with(0, NAN), {": row 0: found x nan, expected a number from -3.4028234e38"}},
                               {npy_with(8, inf), {": row 1: found y inf, expected a number from"}},
                               {npy_with(9, -inf), {": row 1: found z -inf, expected a number from"}},
                               {npy_with(2, 3.5e38), {": row 0: found z 3.5e+38, expected", "(single precision)"}},
                               {npy_with(3, 0), {": row 0: found radius 0, expected a number > 0"}},
                               {npy_with(10, -2), {": row 1: found radius -2, expected a number > 0"}},
                               {npy_with(3, inf), {": row 0: found radius inf, expected a number from"}},
                               {npy_with(10, NAN), {": row 1: found radius nan, expected a number from"}},
                               {npy_with(11, -0.5), {": row 1: found red -0.5, expected a number >= 0"}},
                               {npy_with(5, NAN), {": row 0: found green nan"}},
                               {npy_with(13, 1e300), {": row 1: found blue 1e+300, expected a number from"}},
                           });
    check_refused("a.ply", {
                               {ply(two) + "1 2 3 4\n1 2 3 0\n", {": vertex 1: found radius 0, expected"}},
                               {ply(two) + "nan 2 3 4\n1 2 3 4\n", {": vertex 0: found x nan"}},
                               {ply(two, little) + bytes_of(std::vector<float>{1, 2, 3, 4, 1, 2, -INFINITY, 1}),
                                {": vertex 1: found z -inf"}},
                           });
    check_refused("a.xyz",
                  {{"2\n\nH 0 0 0\nH 0 inf 0\n", {": line 4: found y inf"}},
                   {"1\nProperties=species:S:1:pos:R:3:radius:R:1\nH 0 0 0 -1\n", {": line 3: found radius -1"}}});
}

TEST_CASE("the one wrong value among many is found", "[sphere_io]") {
    const TempFolder folder;
    const size_t count = 5000;
    const auto check = [&](size_t row, int columns, auto zero) {
        const std::vector<float> floats = grains(count, columns);
        std::vector<decltype(zero)> rows(floats.begin(), floats.end());
        rows[row * static_cast<size_t>(columns) + 3] = zero;
        const std::string dict = npy_dict(sizeof zero == 4 ? "<f4" : "<f8", count, static_cast<size_t>(columns));
        const std::string path = folder.write("a.npy", npy(dict, bytes_of(rows)));
        CHECK(contains(refusal(wrong_input, [&] { load_spheres(path); }),
                       "row " + std::to_string(row) + ": found radius"));
    };
    for (const size_t row : {0, 15, 16, 1023, 1024, 4095, 4991, 4992, 4999})
        for (const int columns : {4, 7}) {
            check(row, columns, 0.0f);
            check(row, columns, 0.0);
        }
}

TEST_CASE("damaged arrays are refused", "[sphere_io]") {
    const std::string good = npy(npy_dict("<f4", 2, 4), bytes_of(std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8}));
    const std::string end = "{'descr': '<f4', 'fortran_order': False, ";
    check_refused(
        "a.npy",
        {
            {"hello", {"found no NumPy array: the file does not begin with \\x93NUMPY"}},
            {good.substr(0, 6), {"the file ends in the header"}},
            {good.substr(0, 7), {"the file ends in the header"}},
            {"\x93NUMPY" + std::string(2, '\0'), {"found version 0.0 of the format, expected 1.0, 2.0 or 3.0"}},
            {"\x93NUMPY\x04" + good.substr(7), {"found version 4.0"}},
            {"\x93NUMPY\x01\x01" + good.substr(8), {"found version 1.1"}},
            {good.substr(0, 9), {"the file ends in the header"}},
            {good.substr(0, 60), {"the file ends in the header"}},
            {"\x93NUMPY" + std::string("\2\0\xFF\xFF\xFF\xFF{}", 8), {"the file ends in the header"}},
            {good.substr(0, good.size() - 1), {"found data for 1 of 2 rows", "was the file written to its end?"}},
            {good.substr(0, 128), {"found data for 0 of 2 rows"}},
            {good + "x", {"found 1 bytes after the 2 rows"}},
            {good + good, {"found 160 bytes after the 2 rows"}},
            {npy_of(npy_dict("<i4", 2, 4)), {"found numbers of type \"<i4\", expected <f4, <f8, >f4 or >f8", "astype"}},
            {npy_of(npy_dict("<f2", 2, 4)), {"found numbers of type \"<f2\""}},
            {npy_of(npy_dict("", 2, 4)), {"found numbers of type \"\""}},
            {npy_of(npy_dict("|O", 2, 4)), {"found numbers of type \"|O\""}},
            {npy_shape("(8,)"), {"found an array of shape (8,), expected (N, 4): x y z radius, or (N, 7)"}},
            {npy_shape("()"), {"found an array of shape (), expected"}},
            {npy_shape("(2, 3)"), {"found an array of shape (2, 3), expected"}},
            {npy_shape("(1, 2, 4)"), {"found an array of shape (1, 2, 4), expected"}},
            {npy_shape("(1, 2, 3, 4, 5, 6, 7, 8, 9)"), {"found an array of shape (1, 2, 3, 4, 5, 6, 7, 8, ...), exp"}},
            {npy_shape("(-2, 4)"), {"in the header, expected a size from 0"}},
            {npy_shape("(2 4)"), {"found \"4), }", "in the header, expected ')'"}},
            {npy_shape("[2, 4]"), {"in the header, expected '('"}},
            {npy_shape("(2, 4"), {"in the header, expected"}},
            {npy_shape("(99999999999999999999, 4)"), {"in the header, expected a size from 0"}},
            {npy_shape("(9223372036854775807, 4)"), {"found 9223372036854775807 spheres, expected at most 2147483647"}},
            {npy_shape("(2147483648, 4)"), {"found 2147483648 spheres, expected at most 2147483647"}},
            {npy_shape("(2147483647, 4)"), {"found data for 2 of 2147483647 rows"}},
            {npy_of(""), {"found the header's end in the header, expected '{'"}},
            {npy_of("{}"), {"found no keys in the header, expected 'descr', 'fortran_order', 'shape'"}},
            {npy_of(end + "}"), {"found \"descr\", \"fortran_order\" in the header, expected"}},
            {npy_of(end), {"found the header's end in the header, expected a string"}},
            {npy_of(end + "'shape': (2, 4)} x"), {"found \"x", "expected the header's end"}},
            {npy_of(end + "'shape': (2, 4), 'shape': (2, 4)}"), {"found the key \"shape\" twice"}},
            {npy_of(end + "'shapes': (2, 4)}"), {"found the unknown key \"shapes\" in the header"}},
            {npy_of(end + "'" + std::string(5000, 'k') + "': 1}"), {"found the unknown key \"kkk"}},
            {npy_of(end + "'sha"), {"in the header, expected a string"}},
            {npy_of("{'descr': [('x', '<f4')], 'fortran_order': False}"), {"found \"[('x'", "expected a string"}},
            {npy_of("{'descr': '<f4', 'fortran_order': 0}"), {"found \"0}", "expected True or False"}},
            {npy_of("{'descr' '<f4'}"), {"expected ':'"}},
        });
}

TEST_CASE("damaged XYZ files are refused", "[sphere_io]") {
    const std::string free = "1\nProperties=";
    check_refused(
        "a.xyz",
        {
            {long_line, {"line 1: found no line end within 1 MiB"}},
            {"1\n" + long_line, {"line 2: found no line end within 1 MiB"}},
            {"x\n", {"line 1: found \"x\", expected the number of atoms"}},
            {"\n", {"line 1: found \"\", expected the number of atoms"}},
            {"-1\n\n", {"line 1: found \"-1\", expected the number of atoms"}},
            {"1 2\n\n", {"line 1: found \"1 2\", expected the number of atoms"}},
            {"1.0\n\n", {"line 1: found \"1.0\", expected the number of atoms"}},
            {"2147483648\n\nH 0 0 0\n", {"line 1: found 2147483648 spheres, expected at most 2147483647"}},
            {"2147483647\n\nH 0 0 0\n", {"found 8 bytes, too few for 2147483647 atoms"}},
            {"0\n", {"line 2: the file ends here, expected the comment"}},
            {"2\n\nH 0.00 0.00 0.00\n", {"line 4: the file ends here, expected an atom"}},
            {"1\n\nH 0 0 0\nH 0 0 0\n", {"line 4: found \"H 0 0 0\" after the last atom", "only a file's one frame"}},
            {"1\n\nH 0 0 0\n\n1\n\nH 0 0 0\n", {"line 5: found \"1\" after the last atom"}},
            {"1\n\nH 0 0 -\n", {"line 3: found \"-\", expected a number"}},
            {"1\n\nH 0 0 1e999\n", {"line 3: found \"1e999\", expected a number"}},
            {"1\n\nH 0 0 1" + std::string(310, '0') + "e-1\n", {"line 3: found \"1000", "expected a number"}},
            {"1\n\nH 0 0 0x1p3\n", {"line 3: found \"0x1p3\", expected a number"}},
            {"1\n\nHydrogen 0 0\n", {"line 3: the line ends before the last column", "Properties=species:S:1"}},
            {free + "pos:R:3:radius:R:1\n0 0 0 9 9\n", {"line 3: found \"9\" after the last column"}},
            {free + "pos:I:3:radius:R:1\n0 0.5 0 9\n", {"line 3: found \"0.5\", expected an integer"}},
            {free + "pos:R:3:radius:I:1\n0 0 0 1e3\n", {"line 3: found \"1e3\", expected an integer"}},
            {free + "species:S:1:pos:R:3:color:I:3\nH 0 0 0 0 0 256\n",
             {"line 3: found 256 in a color of integers, expected 0 to 255"}},
            {free + "species:S:1:pos:R:3:color:I:3\nH 0 0 0 0 -1 0\n", {"line 3: found -1 in a color of integers"}},
            {"1\n\n\nH 0 0 0\n", {"line 3: the line ends before the last column"}},
            {"2\n\nH 0 0 0\nA7 0 0 0\n",
             {"line 4: found the unknown species \"A7\"", "\"radius\": ..., \"albedo\": ..."}},
            {"1\n\n0 0 0 0\n", {"line 3: found the unknown species \"0\", expected an element"}},
            {"1\n\n110 0 0 0\n", {"line 3: found the unknown species \"110\""}},
            {"1\n\nPm 0 0 0\n", {"line 3: no van der Waals radius is published for \"Pm\""}},
            {free + "species:S:1\nH\n", {"line 2: found no \"pos\" in Properties"}},
            {free + "pos:R\nH\n", {"line 2: found \"pos:R:\" in Properties, expected a name, a type"}},
            {free + "pos:X:3\nH\n", {"line 2: found \"pos:X:3\" in Properties"}},
            {free + "pos:R:0\nH\n", {"line 2: found \"pos:R:0\" in Properties"}},
            {free + "pos:R:2\nH\n", {"line 2: found \"pos:R:2\", expected \"pos:R:3\""}},
            {free + "pos:S:3\nH\n", {"line 2: found \"pos:S:3\", expected \"pos:R:3\""}},
            {free + "species:R:1:pos:R:3\nH\n", {"line 2: found \"species:R:1\", expected \"species:S:1\""}},
            {free + "pos:R:3:pos:R:3\nH\n", {"line 2: found \"pos\" twice in Properties"}},
            {free + "\nH 0 0 0\n", {"line 2: found no value of Properties, expected columns"}},
            {free + "\"\"\nH 0 0 0\n", {"line 2: found no value of Properties"}},
            {free + " pbc = F\nH 0 0 0\n", {"line 2: found no value of Properties"}},
            {free + "pos:R:3 PROPERTIES = pos:R:3\n0 0 0\n", {"line 2: found Properties twice"}},
            {"1\nname=\"x Properties=pos:R:3\n0 0 0\n", {"line 2: found no end of the quoted \"\\\"x Properties"}},
            {"1\nProperties = species:S:1:vel:R:3\nH 0 0 0\n", {"line 2: found no \"pos\" in Properties"}},
            {"1\nenergy= Properties =vel:R:3\n0 0 0\n", {"line 2: found no \"pos\" in Properties"}},
            {free + "pos:R:3\n1 2 3\n", {"found no radius: the atoms have neither one nor species"}},
            {free + "a:R:9223372036854775807:b:R:9223372036854775807:pos:R:3\n1 2 3\n", {"too few for 1 atoms"}},
            {free + "species:S:1:pos:R:3:radius:R:1\nA7 1 2 3 4\n", {"line 3: found the unknown species \"A7\""}},
        });
    check_refused("a.xyz", {{"1\n\nA7 0 0 0\n", {"line 3: found the unknown species \"A7\""}}}, {2.0, {}});
    check_refused("a.xyz", {{"1\n\nA7 0 0 0\n", {"line 3: found the unknown species \"A7\""}}}, {{}, Rgb{}});
}
